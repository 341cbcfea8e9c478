#include "keiko/light/rig/rig_areas.h"

#include "keiko/light/areas/area_irradiance.h"
#include "keiko/light/luminance/flush.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace keiko {
namespace {

template <ShownLight Light>
Box3 box_around(const Light& light) {
    Box3 box;
    for (const Vec3& corner : bounds_of(light)) box.extend(corner);
    return box;
}

template <ShownLight Light>
bool is_shown(const Light& /*light*/) {
    return true;
}
bool is_shown(const PolygonLight& light) {
    return light.shown;
}

template <ShownLight Light>
const Light& shape_of(const Light& light) {
    return light;
}
PanelOutline shape_of(const PolygonLight& light) {
    return PanelOutline(light);
}

template <ShownLight Light>
std::vector<Vec3> places_on(const Light& light) {
    return {box_around(light).center()};
}
std::vector<Vec3> places_on(const PolygonLight& light) {
    const std::vector<Vec3>& corners = light.corners;
    const std::size_t count = corners.size();
    Vec3 middle(0);
    for (const Vec3& corner : corners) middle += corner / double(count);
    const Vec3 normal = light.normal();
    if (area_hit(PanelOutline(light), middle + normal, -normal, {})) return {middle};
    std::vector<Vec3> places;
    for (std::size_t i = 0; i < count; ++i)
        places.push_back((corners[i] + corners[(i + 1) % count] + corners[(i + 2) % count]) / 3);
    return places;
}

/// Tangent of the angle between a ray and the normal of a flat light; 0 for any other.
double slant(const PanelOutline& panel, const Vec3& direction) {
    const double along = std::abs(panel.plane.normal.dot(direction));
    return square_to(direction, panel.plane.normal).length() / along;
}
double slant(const DiscLight& disc, const Vec3& direction) {
    const double along = std::abs(disc.normal.dot(direction));
    return square_to(direction, disc.normal).length() / along;
}
template <class Shape>
double slant(const Shape& /*shape*/, const Vec3& /*direction*/) {
    return 0;
}

/// Width of a pixel at t, in lengths of the ray's direction.
double width_at(const RayDifferentials& spread, const Vec3& direction, double t) {
    const Vec3 across = spread.origin_dx + spread.direction_dx * t;
    const Vec3 up = spread.origin_dy + spread.direction_dy * t;
    return std::max(across.length(), up.length()) / direction.length();
}

/// Difference of t that a light takes up within a pixel of a width: that of a surface at 76 degrees
/// to the ray, or of a flat light that is more aslant. It has no more than it has in all.
double depth_within(double width, double slant, double most) {
    constexpr double at_least = 4;
    return std::max(at_least * width, std::min(slant * width, most));
}

/// A light along a ray, and how much of t it takes up within a pixel.
struct DeepLayer {
    RigAreas::Layer layer;
    double depth;
};

/// Faces of one lamp meet at an edge: there each covers a part of the pixel that the other leaves.
/// A layer's share of what those before it leave is made so large that it covers its own part.
void join_at_edges(std::vector<DeepLayer>& layers) {
    double covered = 0; // by the layers that meet the last one
    for (std::size_t i = 0; i < layers.size(); ++i) {
        AreaHit& hit = layers[i].layer.hit;
        const bool meets = i > 0 && hit.t - layers[i - 1].layer.hit.t <=
                                        std::max(layers[i].depth, layers[i - 1].depth);
        if (!meets) covered = 0;
        const double own = hit.coverage;
        hit.coverage = covered < 1 ? std::min(own / (1 - covered), 1.0) : 0;
        covered = std::min(covered + own, 1.0);
    }
}

} // namespace

RigAreas::RigAreas(const LightRig& rig) {
    for (const LightSource& source : rig.sources)
        std::visit(
            [&](const auto& light) {
                if constexpr (ShownLight<std::decay_t<decltype(light)>>)
                    if (is_shown(light))
                        areas_.push_back({shape_of(light), light.luminance, box_around(light),
                                          places_on(light)});
            },
            source);
}

std::vector<RigAreas::Layer> RigAreas::along(const Vec3& origin, const Vec3& direction,
                                             const std::optional<RayDifferentials>& spread,
                                             double t_max) const {
    std::vector<DeepLayer> deep;
    for (std::size_t i = 0; i < areas_.size(); ++i) {
        const Area& area = areas_[i];
        const auto hit = std::visit(
            [&](const auto& shape) { return area_hit(shape, origin, direction, spread); },
            area.shape);
        if (!hit || !(hit->t * (1 - flush) < t_max)) continue;
        deep.push_back({{*hit, area.luminance, i}, 0});
        if (spread)
            deep.back().depth = std::visit(
                [&](const auto& shape) {
                    return depth_within(width_at(*spread, direction, hit->t),
                                        slant(shape, direction),
                                        area.box.size() / direction.length());
                },
                area.shape);
    }
    std::stable_sort(deep.begin(), deep.end(), [](const DeepLayer& a, const DeepLayer& b) {
        return a.layer.hit.t < b.layer.hit.t;
    });
    if (spread) join_at_edges(deep);
    std::vector<Layer> layers;
    layers.reserve(deep.size());
    for (const DeepLayer& layer : deep) layers.push_back(layer.layer);
    return layers;
}

std::vector<Box3> RigAreas::boxes() const {
    std::vector<Box3> boxes;
    for (const Area& area : areas_) boxes.push_back(area.box);
    return boxes;
}

std::vector<std::vector<Vec3>> RigAreas::places() const {
    std::vector<std::vector<Vec3>> places;
    for (const Area& area : areas_) places.push_back(area.places);
    return places;
}

} // namespace keiko
