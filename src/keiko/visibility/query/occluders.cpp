#include "keiko/visibility/query/occluders.h"

#include "keiko/visibility/query/visibility_query.h"

#include <chrono>
#include <numbers>
#include <vector>

namespace keiko {

namespace {

BoundsTree silhouette_tree(const std::vector<SilhouettePiece>& pieces) {
    std::vector<PieceBound> bounds;
    for (const SilhouettePiece& p : pieces)
        bounds.push_back({p.box, p.frame.rows[2], p.normal_angle});
    return BoundsTree(std::move(bounds));
}

BoundsTree border_tree(const std::vector<BoundaryPiece>& pieces) {
    std::vector<PieceBound> bounds;
    for (const BoundaryPiece& p : pieces) bounds.push_back({p.box, p.normal, p.normal_angle});
    return BoundsTree(std::move(bounds));
}

BoundsTree surface_tree(std::span<const Box3> boxes) {
    std::vector<PieceBound> bounds;
    for (const Box3& box : boxes) bounds.push_back({box});
    return BoundsTree(std::move(bounds));
}

} // namespace

Occluders::Scene::Scene(const SurfaceModel& model, const Tracer& tracer, const Job& job)
    : silhouettes(silhouettes_of(model, job)),
      borders(keiko::boundary_pieces(model, tracer, job)),
      silhouette_pieces(silhouette_tree(silhouettes.pieces)),
      boundary_pieces(border_tree(borders)),
      surface(surface_tree(tracer.boxes())) {}

Occluders::Occluders(const SurfaceModel& model, const Tracer& tracer, const Job& job) {
    const auto begin = std::chrono::steady_clock::now();
    scene_ = std::make_unique<Scene>(model, tracer, job);
    scene_->statistics = {
        scene_->silhouettes.pieces.size(), scene_->borders.size(),
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()};
}

Occluders::~Occluders() = default;
Occluders::Occluders(Occluders&&) noexcept = default;
Occluders& Occluders::operator=(Occluders&&) noexcept = default;

const Occluders::Statistics& Occluders::statistics() const {
    return scene_->statistics;
}

VisibilityQuery::VisibilityQuery(const Occluders& occluders, const Tracer& tracer,
                                 const Viewpoint& viewpoint, std::span<const Vec3> region,
                                 const std::optional<Vec3>& facing)
    : candidates_(
          std::make_unique<Candidates>(*occluders.scene_, tracer, viewpoint, region, facing)) {}

VisibilityQuery::~VisibilityQuery() = default;
VisibilityQuery::VisibilityQuery(VisibilityQuery&&) noexcept = default;
VisibilityQuery& VisibilityQuery::operator=(VisibilityQuery&&) noexcept = default;

VisibleIntervals VisibilityQuery::intervals(const Segment& segment) const {
    return candidates_->intervals(segment);
}

std::vector<VisibleIntervals> VisibilityQuery::intervals(std::span<const Segment> row) const {
    if (auto parts = candidates_->intervals_of_row(row)) return std::move(*parts);
    std::vector<VisibleIntervals> parts;
    for (const Segment& ends : row) parts.push_back(candidates_->intervals(ends));
    return parts;
}

std::vector<std::optional<bool>> VisibilityQuery::classify_prisms(
    std::span<const Prism> prisms) const {
    return candidates_->classify_prisms(prisms);
}

std::vector<CriticalSlice> VisibilityQuery::turns(const Prism& prism, const TurnRule& rule) const {
    return candidates_->turns(prism, rule);
}

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
