#include "keiko/visibility/query/occluder_scene.h"

#include <span>

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

OccluderScene::OccluderScene(const SurfaceModel& model, const Tracer& tracer, const Job& job)
    : silhouettes(silhouettes_of(model, job)),
      borders(keiko::boundary_pieces(model, tracer, job)),
      silhouette_pieces(silhouette_tree(silhouettes.pieces)),
      boundary_pieces(border_tree(borders)),
      surface(surface_tree(tracer.boxes())) {}

} // namespace keiko
