#include "keiko/visibility/query/occluders.h"

#include "keiko/visibility/query/visibility_query.h"

#include <chrono>

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

} // namespace keiko
