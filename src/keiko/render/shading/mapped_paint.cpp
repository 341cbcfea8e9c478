#include "keiko/render/shading/mapped_paint.h"

#include "keiko/intersect/hit/local_surface.h"
#include "keiko/maps/bump.h"

namespace keiko {
namespace {

/// True if a ray meets the front of a normal there, and is mirrored above the surface.
bool is_visible(const Vec3& normal, const Vec3& direction, const Vec3& flat) {
    return normal.dot(direction) < 0 && reflect(direction, normal).dot(flat) > 0;
}

/// The largest share, to 1/4096, whose `normal_at`(share) is visible; that of 0 is.
template <class NormalAt>
double visible_share(const NormalAt& normal_at, const Vec3& direction, const Vec3& flat) {
    if (is_visible(normal_at(1.0), direction, flat)) return 1;
    double share = 0;
    for (double step = 0.5; step > 1.0 / 8192; step /= 2)
        if (is_visible(normal_at(share + step), direction, flat)) share += step;
    return share;
}

void raise(Hit& hit, const Vec3& flat, const HeightJet& height) {
    if (!hit.second) return;
    const SurfaceDerivatives s = raised(derivatives_of(hit), flat, height);
    hit.dpdu = s.d[1][0], hit.dpdv = s.d[0][1];
    hit.second = {s.d[2][0], s.d[1][1], s.d[0][2]};
}

} // namespace

Vec3 bounded(const Vec3& step) {
    constexpr double longest = 1e9; // mm
    const double length = step.length();
    if (length < longest) return step;
    return std::isfinite(length) ? step * (longest / length) : Vec3(longest, 0, 0);
}

MapPlace MappedHits::place_of(const Ray& ray, const Hit& hit) const {
    MapPlace place{hit.position, hit.normal};
    if (hit.normal.dot(ray.direction) > 0) place.normal = -hit.normal;
    place.from_inside = is_from_inside(ray, hit);
    place.parameters = maps_->parameters().at(hit.patch, hit.uv, hit.dpdu, hit.dpdv);
    if (!ray.differentials) return place;
    const RayDifferentials& d = *ray.differentials;
    place.dx = bounded(transfer(ray, hit, d.origin_dx, d.direction_dx));
    place.dy = bounded(transfer(ray, hit, d.origin_dy, d.direction_dy));
    return place;
}

std::shared_ptr<const MappedPaint> MappedHits::paint(const Paint& base, const Ray& ray,
                                                     const Hit& hit) const {
    const SurfaceMaps& maps = *maps_->of_face(hit.face);
    const bool bends = maps.drives(MappedQuantity::bump) || maps.drives(MappedQuantity::normal);
    const bool lobes = maps.drives(MappedQuantity::roughness) ||
                       (base.gloss() && maps.drives(MappedQuantity::gloss));
    const MapPlace place = place_of(ray, hit);
    return std::make_shared<const MappedPaint>(
        MappedPaint{base.varied(materials_[hit.face], maps.values(place)), bends || lobes});
}

bool MappedHits::shines(const Ray& ray, const Hit& hit) const {
    const Material& material = materials_[hit.face];
    if (material.emits == Rgb(0)) return false;
    return !maps_ || material.emits_both_ways || !is_from_inside(ray, hit);
}

void MappedHits::bend(const Ray& ray, Hit& hit) const {
    if (!has(hit.face)) return;
    const SurfaceMaps& maps = *maps_->of_face(hit.face);
    const MapPlace place = place_of(ray, hit);
    const std::optional<HeightJet> height = maps.height(place);
    const std::optional<Vec3> mapped = maps.normal(place);
    if (!height && !mapped) return;
    const Vec3& flat = place.normal;
    const Vec3 tilt = mapped.value_or(flat) - flat;
    const HeightJet jet = height.value_or(HeightJet());
    const auto normal_at = [&](double share) {
        return (raised_normal(flat, jet.gradient * share) + tilt * share).normalized();
    };
    const double share = visible_share(normal_at, ray.direction, flat);
    const Vec3 normal = normal_at(share);
    if (height) raise(hit, flat, jet * share);
    hit.normal = hit.normal.dot(flat) < 0 ? -normal : normal;
}

} // namespace keiko
