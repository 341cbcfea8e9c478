#include "keiko/maps/surface_maps.h"

#include "keiko/maps/bump.h"
#include "keiko/maps/map_region.h"
#include "keiko/math/unit_vectors.h"

#include <algorithm>

namespace keiko {
namespace {

/// Depth, in cells of a texture, of the places that are looked up beneath the surface. On a face
/// that lies between two layers of cells, rounding would else choose one of them at each place.
constexpr double looked_up_beneath = 1e-6;

/// Unit vector into the body.
Vec3 inwards(const MapPlace& place) {
    return place.from_inside ? place.normal : -place.normal;
}

/// Gradient in the world of a function of the model's places.
Vec3 world_gradient(const Affine& to_model, const Vec3& gradient) {
    const auto& rows = to_model.rows;
    return rows[0] * gradient.x + rows[1] * gradient.y + rows[2] * gradient.z;
}

ProjectedPlace on_projection(const MapProjection& projection, const Affine& to_model,
                             const MapPlace& place) {
    if (projection.kind == ProjectionKind::parameter)
        return place.parameters.scaled(projection.scale, projection.offset);
    ProjectedPlace at = projected(projection, to_model.point(place.position));
    at.grad_u = world_gradient(to_model, at.grad_u);
    at.grad_v = world_gradient(to_model, at.grad_v);
    return at.scaled(projection.scale, projection.offset);
}

TextureFrame on_projection_frame(const ProjectedPlace& at, const MapPlace& place) {
    const auto change = [&](const Vec3& step) {
        return Vec3(at.grad_u.dot(step), at.grad_v.dot(step), 0);
    };
    const double steepest = std::max(at.grad_u.length(), at.grad_v.length());
    const double depth = steepest > 0 ? looked_up_beneath / steepest : 0; // mm
    return {{Vec3(at.at.x, at.at.y, 0) + change(inwards(place) * depth), change(place.dx),
             change(place.dy)},
            {Vec3(1, 0, 0), Vec3(0, 1, 0)},
            {at.grad_u, at.grad_v}};
}

TextureFrame in_space(double size, const Affine& to_model, const MapPlace& place) {
    const auto step = [&](const Vec3& v) { return to_model.vector(v) / size; };
    const auto [a, b] = AxesAcross(place.normal, place.normal.z < 0 ? -1 : 1);
    const Vec3 beneath = step(inwards(place)).normalized() * looked_up_beneath;
    return {{to_model.point(place.position) / size + beneath, step(place.dx), step(place.dy)},
            {step(a), step(b)},
            {a, b}};
}

TextureFrame frame_of(const MaterialMap& map, const Affine& to_model, const MapPlace& place) {
    const MapProjection& projection = map.projection;
    return projection.kind == ProjectionKind::solid
               ? in_space(map.texture.size, to_model, place)
               : on_projection_frame(on_projection(projection, to_model, place), place);
}

Rgb clamped(const Rgb& color) {
    const auto share = [](double x) { return std::clamp(x, 0.0, 1.0); };
    return {share(color.r), share(color.g), share(color.b)};
}

/// Value of a map, between what 0 and 1 stand for.
Rgb between(const MaterialMap& map, const Rgb& value) {
    return map.low + (map.high - map.low) * value;
}

} // namespace

SurfaceMaps::SurfaceMaps(std::span<const MaterialMap> maps) {
    for (const MaterialMap& map : maps)
        maps_.push_back({map, map.placement.inverse(),
                         Texture(map.texture, map.projection.kind == ProjectionKind::solid)});
}

bool SurfaceMaps::drives(MappedQuantity quantity) const {
    return std::any_of(maps_.begin(), maps_.end(),
                       [&](const Prepared& p) { return p.map.drives == quantity; });
}

double SurfaceMaps::share(const Prepared& prepared, const MapPlace& place) {
    const auto& [map, to_model, texture] = prepared;
    if (!map.region) return map.factor;
    const MapProjection& projection = map.region->projection;
    const ProjectedPlace at = on_projection(projection, to_model, place);
    TexturePlace shown = on_projection_frame(at, place).place;
    double covered = polygon_coverage(map.region->corners, shown);
    if (projection.kind != ProjectionKind::cylindrical &&
        projection.kind != ProjectionKind::spherical)
        return map.factor * covered;
    // A pixel at the seam, or a region across it, is a turn away as well.
    const double turn = projection.scale.x, u = shown.at.x;
    for (const double by : {-turn, turn}) {
        shown.at.x = u + by;
        covered += polygon_coverage(map.region->corners, shown);
    }
    return map.factor * std::min(covered, 1.0);
}

/// Factor of the quantity that a map drives.
Rgb SurfaceMaps::factor(const Prepared& prepared, const MapPlace& place) {
    const auto& [map, to_model, texture] = prepared;
    const double counts = share(prepared, place);
    if (counts == 0) return Rgb(1);
    const Rgb value = between(map, texture.value(frame_of(map, to_model, place).place));
    return Rgb(1) + (value - Rgb(1)) * counts;
}

MapValues SurfaceMaps::values(const MapPlace& place) const {
    MapValues values;
    for (const Prepared& prepared : maps_) {
        switch (prepared.map.drives) {
            case MappedQuantity::diffuse:
                values.diffuse *= factor(prepared, place);
                break;
            case MappedQuantity::roughness:
                values.roughness *= luminance(factor(prepared, place));
                break;
            case MappedQuantity::gloss:
                values.gloss *= clamped(factor(prepared, place));
                break;
            case MappedQuantity::transmission:
                values.transmission *= clamped(factor(prepared, place));
                break;
            case MappedQuantity::emission:
                values.emission *= factor(prepared, place);
                break;
            case MappedQuantity::bump:
            case MappedQuantity::normal:
                break;
        }
    }
    return values;
}

std::optional<HeightJet> SurfaceMaps::height(const MapPlace& place) const {
    if (!drives(MappedQuantity::bump)) return {};
    HeightJet sum;
    for (const Prepared& prepared : maps_) {
        const auto& [map, to_model, texture] = prepared;
        if (map.drives != MappedQuantity::bump) continue;
        const double scale = share(prepared, place) * (map.high.g - map.low.g);
        if (scale == 0) continue;
        sum = sum + texture.height(frame_of(map, to_model, place)) * scale;
    }
    return sum;
}

std::optional<Vec3> SurfaceMaps::normal(const MapPlace& place) const {
    if (!drives(MappedQuantity::normal)) return {};
    Vec3 normal = place.normal;
    for (const Prepared& prepared : maps_) {
        const auto& [map, to_model, texture] = prepared;
        if (map.drives != MappedQuantity::normal) continue;
        const double counts = share(prepared, place);
        const TextureFrame frame = frame_of(map, to_model, place);
        const auto& [grad_u, grad_v] = frame.gradient;
        if (counts == 0 || !(grad_u.cross(grad_v).length2() > 0)) continue;
        // The directions in which one coordinate changes alone.
        const Vec3 across = normal * (grad_u.cross(grad_v).dot(normal) < 0 ? -1 : 1);
        const MapTangents tangents(grad_v.cross(across), across.cross(grad_u), normal);
        Rgb texel = between(map, texture.value(frame.place));
        texel.r *= counts, texel.g *= counts;
        normal = mapped_normal(texel, tangents.tangent, tangents.bitangent, normal);
    }
    return normal;
}

} // namespace keiko
