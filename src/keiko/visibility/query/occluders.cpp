#include "keiko/visibility/query/occluders.h"

#include "keiko/visibility/query/apex_candidates.h"

#include <chrono>

namespace keiko {
namespace {

PieceTree silhouette_tree(const std::vector<SilhouettePiece>& pieces) {
    std::vector<PieceBound> bounds;
    for (const SilhouettePiece& p : pieces)
        bounds.push_back({p.box, p.frame.rows[2], p.normal_angle});
    return PieceTree(std::move(bounds));
}

PieceTree border_tree(const std::vector<BorderPiece>& pieces) {
    std::vector<PieceBound> bounds;
    for (const BorderPiece& p : pieces) bounds.push_back({p.box, p.normal, p.normal_angle});
    return PieceTree(std::move(bounds));
}

PieceTree surface_tree(std::span<const Box3> boxes) {
    std::vector<PieceBound> bounds;
    for (const Box3& box : boxes) bounds.push_back({box});
    return PieceTree(std::move(bounds));
}

} // namespace

Occluders::Scene::Scene(const SurfaceModel& model, const Tracer& tracer, const Job& job)
    : silhouettes(silhouettes_of(model, job)),
      borders(keiko::border_pieces(model, tracer, job)),
      silhouette_pieces(silhouette_tree(silhouettes.pieces)),
      border_pieces(border_tree(borders)),
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

ApexView::ApexView(const Occluders& occluders, const Tracer& tracer, const Apex& apex,
                   std::span<const Vec3> region, const std::optional<Vec3>& facing)
    : candidates_(std::make_unique<Candidates>(*occluders.scene_, tracer, apex, region, facing)) {}

ApexView::~ApexView() = default;
ApexView::ApexView(ApexView&&) noexcept = default;
ApexView& ApexView::operator=(ApexView&&) noexcept = default;

SeenParts ApexView::intervals(const Vec3& a, const Vec3& b) const {
    return candidates_->intervals({a, b});
}

std::vector<SeenParts> ApexView::intervals(std::span<const SegmentEnds> row) const {
    if (auto parts = candidates_->intervals_of_row(row)) return std::move(*parts);
    std::vector<SeenParts> parts;
    for (const SegmentEnds& ends : row) parts.push_back(candidates_->intervals(ends));
    return parts;
}

std::vector<std::optional<bool>> ApexView::seen_as_whole(std::span<const PrismEdges> prisms) const {
    return candidates_->seen_as_whole(prisms);
}

std::vector<SeenTurn> ApexView::turns(const PrismEdges& prism, double gap, double missed) const {
    return candidates_->turns(prism, gap, missed);
}

} // namespace keiko
