#include "keiko/render/shading/direct_lighting.h"

#include "keiko/light/areas/area_irradiance.h"
#include "keiko/light/rig/light_visibility.h"
#include "keiko/light/sky/sky_panels.h"
#include "keiko/light/spotlight/point_light.h"
#include "keiko/light/tubes/tube_lamp.h"
#include "keiko/math/box_corners.h"

#include <algorithm>
#include <iterator>
#include <numbers>

namespace keiko {
namespace {

/// Corners of a box around lamps of a row, at a distance of `off` from their axes and `beyond`
/// their ends.
std::vector<Vec3> box_around(const CPlaneFrame& frame, int first, int last, double off,
                             double beyond) {
    std::vector<Vec3> corners;
    corners.reserve(8);
    for (const double along : {-beyond, frame.length + beyond})
        for (const double across : {frame.axis(first) - off, frame.axis(last) + off})
            for (const double height : {-off, off})
                corners.push_back(frame.at(along, across) + frame.normal * height);
    return corners;
}

struct Corners {
    std::span<const int> lamps;
    const Vec3& point;

    std::vector<Vec3> operator()(const LampRow& row) const {
        const CPlaneFrame& frame = row.frame;
        const double r = frame.radius() * std::numbers::sqrt2; // of boxes in any orientation
        return box_around(frame, lamps.front(), lamps.back(), r, r);
    }
    template <PointLight Light>
    std::vector<Vec3> operator()(const Light& light) const {
        return {light.position};
    }
    std::vector<Vec3> operator()(const Sun& sun) const { return {sun.seen_from(point)}; }
    std::vector<Vec3> operator()(const LineLight& light) const { return {light.a, light.b}; }
    template <AreaLight Light>
    std::vector<Vec3> operator()(const Light& light) const {
        return bounds_of(light);
    }
    std::vector<Vec3> operator()(const SkyLight& sky) const {
        std::vector<Vec3> corners;
        for (const int number : lamps)
            if (const auto panel = sky_panel(sky, number, point))
                corners.insert(corners.end(), panel->outline.corners.begin(),
                               panel->outline.corners.end());
        return corners;
    }
};

} // namespace

std::vector<Vec3> light_bounds(const PreparedSource& source, std::span<const int> lamps,
                               const Vec3& point) {
    return std::visit(Corners{lamps, point}, source.kind());
}

std::vector<Vec3> lamp_corners(const PreparedSource& source, int lamp, const Vec3& point,
                               TubeModel model) {
    const auto* row = std::get_if<LampRow>(&source.kind());
    if (const auto* light = std::get_if<ContourLight>(&source.kind()))
        return corners_of(light->body->bounds());
    if (!row) return light_bounds(source, {&lamp, 1}, point);
    const CPlaneFrame& frame = row->frame;
    if (weighs_width(row->plane, model)) return box_around(frame, lamp, lamp, frame.radius(), 0);
    return {frame.at(0, frame.axis(lamp)), frame.at(frame.length, frame.axis(lamp))};
}

std::vector<LightVisibility> DirectLighting::light_visibility(const Vec3& point, const Vec3& normal,
                                                              const std::optional<Root>& root,
                                                              std::span<const LightId> lights,
                                                              TubeModel model, bool axes) const {
    std::vector<LightVisibility> all;
    const auto add = [&](const PreparedSource& source, std::span<const int> lamps) {
        const OccludedVisibility visible = visibility(source, lamps, point, normal, root);
        std::vector<LightVisibility> seen = light_visibilities(
            source, lamps, point, normal, visible, model, axes || rig_.medium.has_value());
        std::move(seen.begin(), seen.end(), std::back_inserter(all));
    };
    each_source(lights, [&](std::size_t i, std::span<const int> lamps, std::size_t) {
        const PreparedSource& source = rig_.sources[i];
        if (!std::holds_alternative<SkyLight>(source.kind())) return add(source, lamps);
        // Panels of a sky lie all around: what hides one of them is not in the way of another.
        for (const int& lamp : lamps) add(source, {&lamp, 1});
    });
    return all;
}

OccludedVisibility DirectLighting::visibility(const PreparedSource& source,
                                              std::span<const int> lamps, const Vec3& point,
                                              const Vec3& normal,
                                              const std::optional<Root>& root) const {
    return {occluders_,
            tracer_,
            Viewpoint::at(point, root),
            occluders_ ? light_bounds(source, lamps, point) : std::vector<Vec3>(),
            {},
            normal};
}

bool DirectLighting::may_occlude(std::span<const Vec3> places, const LightId& light,
                                 const std::optional<Vec3>& facing, TubeModel model) const {
    if (!occluders_) return false;
    const PreparedSource& source = rig_.sources[light.source];
    const auto* sun = std::get_if<Sun>(&source.kind());
    const auto* sky = std::get_if<SkyLight>(&source.kind());
    if (sun && !sun->windows.empty()) return true; // their frames occlude it, too
    if (sky) return !sky->windows.empty();         // which show other parts of it
    std::vector<Vec3> region;
    // What is at infinity goes with the place.
    for (const Vec3& place : sun ? places : places.first(1))
        for (const Vec3& corner : lamp_corners(source, light.lamp, place, model))
            region.push_back(corner);
    return occluders_->may_occlude(places, region, facing);
}

std::vector<Rgb> PointLighting::illuminance_by_light(const ClearCoat* coat) const {
    return by_light([&](const PreparedSource& source, std::span<const int> lamps,
                        std::span<const LightVisibility> seen) {
        return illuminance_by_lamp(source, lamps, seen, rig_.medium, point_, normal_, model_, coat);
    });
}

} // namespace keiko
