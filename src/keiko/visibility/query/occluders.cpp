#include "keiko/visibility/query/occluders.h"

#include "keiko/visibility/query/occluder_scene.h"
#include "keiko/visibility/silhouettes/view_volume.h"

#include <chrono>
#include <numbers>
#include <vector>

namespace keiko {
namespace {

/// Ways from each place to each corner of a region.
class Ways {
public:
    Ways(std::span<const Vec3> places, std::span<const Vec3> region)
        : places_(places), region_(region) {}

    /// Whether any mixture of them may be tangent to a surface with these normals: those that run
    /// to one side of all its tangent planes are a convex cone.
    bool may_be_tangent(const PieceBound& bound) const {
        if (!(bound.angle < std::numbers::pi / 2)) return true;
        constexpr double rounding = 1e-9;
        const double least = bound.sine + rounding;
        bool up = true, down = true;
        for (const Vec3& way : units()) {
            const double rise = bound.normal.dot(way);
            up = up && rise > least;
            down = down && rise < -least;
            if (!up && !down) return true;
        }
        return false;
    }

private:
    /// Ways of length 1, computed on the first request, since most regions have nothing before
    /// them.
    std::span<const Vec3> units() const {
        if (units_.empty()) {
            units_.reserve(places_.size() * region_.size());
            for (const Vec3& place : places_)
                for (const Vec3& corner : region_) units_.push_back((corner - place).normalized());
        }
        return units_;
    }

    std::span<const Vec3> places_, region_;
    mutable std::vector<Vec3> units_;
};

} // namespace

Occluders::Occluders(const SurfaceModel& model, const Tracer& tracer, const Job& job)
    : tracer_(tracer) {
    const auto begin = std::chrono::steady_clock::now();
    scene_ = std::make_shared<const OccluderScene>(model, tracer, job);
    statistics_ = {scene_->silhouettes.pieces.size(), scene_->borders.size(),
                   std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()};
}

bool Occluders::may_occlude(std::span<const Vec3> places, std::span<const Vec3> region,
                            const std::optional<Vec3>& facing) const {
    const ViewVolume volume(places, region, facing);
    if (scene_->surface.touches(volume.region())) return true;
    const Ways ways(places, region);
    const auto tangent = [&](const PieceBound& bound) { return ways.may_be_tangent(bound); };
    const auto holds = [&](const auto& piece, ViewVolume::Sides sides) {
        return volume.may_hold(piece, sides);
    };
    using Sides = ViewVolume::Sides;
    return scene_->boundary_pieces.any(volume, tangent, [&](std::uint32_t i, Sides sides) {
        return holds(scene_->borders[i], sides);
    }) || scene_->silhouette_pieces.any(volume, tangent, [&](std::uint32_t i, Sides sides) {
        return holds(scene_->silhouettes.pieces[i], sides);
    });
}

} // namespace keiko
