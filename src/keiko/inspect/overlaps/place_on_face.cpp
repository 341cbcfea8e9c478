#include "keiko/inspect/overlaps/place_on_face.h"

#include "keiko/geometry/bezier/subpatch.h"

namespace keiko {

NearFace::NearFace(const SurfaceModel& model, const PlacedFace& face, double reach)
    : model_(model), inside_(model, model.faces[face.face], reach), reach_(reach) {
    const Face& of = model.faces[face.face];
    for (std::uint32_t k = 0; k < of.patch_count; ++k)
        patches_.emplace_back(model, of.first_patch + k, model.instances[face.instance].transform);
}

std::optional<PlaceOnFace> NearFace::find(const Vec3& p) {
    std::optional<PlaceOnFace> nearest;
    for (const PlacedPatch& patch : patches_) {
        if (!patch.box.padded(reach_).contains(p)) continue;
        const Patch& of = model_.patches[patch.index];
        const BezierPatchView whole{of.degree_u, of.degree_v, patch.points};
        const auto found = search(patch, whole, unit_square, p - patch.middle, 0);
        if (found && (!nearest || found->distance < nearest->distance)) nearest = found;
    }
    return nearest;
}

/// Newton's iteration finds the place from the middle of a gentle piece. Where it does not, halves
/// are searched, down to pieces that are as small as the reach.
std::optional<PlaceOnFace> NearFace::search(const PlacedPatch& patch, const BezierPatchView& whole,
                                            const Box2& box, const Vec3& p, int depth) {
    const std::vector<Vec4> points = subpatch(whole, box);
    const BezierPatchView piece{whole.degree_u, whole.degree_v, points};
    const Box3 hull = hull_bounds(piece);
    if (!hull.padded(reach_).contains(p)) return std::nullopt;
    if (const auto found = foot_in(patch, whole, box, piece, p)) return found;
    constexpr int most_depth = 60;
    if (hull.size() <= reach_ / 2 || depth == most_depth) return std::nullopt;
    const Vec3 corner = euclidean(piece.point(0, 0));
    const double along_u = (euclidean(piece.point(piece.degree_u, 0)) - corner).length();
    const double along_v = (euclidean(piece.point(0, piece.degree_v)) - corner).length();
    // Cut in turn where the sides are alike, so that a closed piece is cut in both directions.
    const unsigned axis = along_u > 2 * along_v   ? 0
                          : along_v > 2 * along_u ? 1
                                                  : static_cast<unsigned>(depth % 2);
    for (const bool upper : {false, true}) {
        Box2 half = box;
        (upper ? half.lower : half.upper)[axis] = box.center()[axis];
        if (const auto found = search(patch, whole, half, p, depth + 1)) return found;
    }
    return std::nullopt;
}

std::optional<PlaceOnFace> NearFace::foot_in(const PlacedPatch& patch, const BezierPatchView& whole,
                                             const Box2& box, const BezierPatchView& piece,
                                             const Vec3& p) {
    const PieceProjection foot = piece_projection(piece, p);
    if (!(foot.distance <= reach_)) return std::nullopt;
    const Vec2 uv = box.lower + box.extent() * foot.uv;
    const SurfaceDerivatives s = evaluate(whole, uv, 1);
    if (!inside_.is_on(patch.index, uv, s)) return std::nullopt;
    return PlaceOnFace{foot.distance, inside_.is_inside(patch.index, uv, s)};
}

} // namespace keiko
