#include "keiko/trace/occluder_scene.h"

#include <algorithm>
#include <numbers>

namespace keiko {
namespace {

/// Unit, from each place to each corner of the region.
std::vector<Vec3> ways_between(std::span<const Vec3> places, std::span<const Vec3> region) {
    std::vector<Vec3> ways;
    for (const Vec3& place : places)
        for (const Vec3& corner : region) ways.push_back((corner - place).normalized());
    return ways;
}

/// Whether any mixture of the ways may be tangent to a surface with these normals: those that run
/// to one side of all its tangent planes are a convex cone.
bool may_be_tangent(const PieceBound& bound, std::span<const Vec3> ways) {
    if (!(bound.angle < std::numbers::pi / 2)) return true;
    constexpr double rounding = 1e-9;
    const double least = bound.sine + rounding;
    bool up = true, down = true;
    for (const Vec3& way : ways) {
        const double rise = bound.normal.dot(way);
        up = up && rise > least;
        down = down && rise < -least;
        if (!up && !down) return true;
    }
    return false;
}

} // namespace

bool Occluders::may_come_between(std::span<const Vec3> places, std::span<const Vec3> region,
                                 const std::optional<Vec3>& facing) const {
    const ViewVolume volume(places, region, facing);
    if (scene_->surface.touches(volume.region())) return true;
    const std::vector<Vec3> ways = ways_between(places, region);
    const auto tangent = [&](const PieceBound& bound) { return may_be_tangent(bound, ways); };
    const auto holds = [&](const auto& piece, ViewVolume::Sides sides) {
        return volume.may_hold(piece, sides);
    };
    using Sides = ViewVolume::Sides;
    return scene_->border_pieces.any(volume, tangent, [&](std::uint32_t i, Sides sides) {
        return holds(scene_->borders[i], sides);
    }) || scene_->silhouette_pieces.any(volume, tangent, [&](std::uint32_t i, Sides sides) {
        return holds(scene_->silhouettes.pieces[i], sides);
    });
}

} // namespace keiko
