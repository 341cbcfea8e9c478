#include "keiko/inspect/seams/broken_knots.h"

#include "keiko/inspect/seams/isoline_places.h"

#include <algorithm>

namespace keiko {
namespace {

/// A far side of a patch, where another one may follow.
struct FarSide {
    KnotPiece piece;
    int degree; ///< along it
};

std::array<FarSide, 2> far_sides(const SurfaceModel& model, std::uint32_t patch) {
    const ParameterMap &u = model.patches[patch].map_u, &v = model.patches[patch].map_v;
    const BezierPatchView points = model.patch(patch);
    return {FarSide{{true, u.end, v.begin, v.end}, points.degree_v},
            FarSide{{false, v.end, u.begin, u.end}, points.degree_u}};
}

/// The relation of both sides of a piece at its tested places.
std::vector<SeamPoint> places(const KnottedFace& face, const FarSide& side) {
    const Affine unmoved;
    const std::array<Vec3, 2> line = side.piece.side(true);
    const SeamProbe across = face.probe(side.piece, unmoved, line, line);
    std::vector<SeamPoint> points;
    for (const double t : isoline_places(4 * side.degree)) points.push_back(across.at(t));
    return points;
}

} // namespace

BrokenKnots broken_knots(const KnottedFace& face) {
    constexpr double closed = 1e-4; // mm
    const auto gapes = [](const SeamPoint& p) { return p.gap > closed; };
    const Box2 domain = face.domain();
    BrokenKnots knots;
    for (std::uint32_t k = 0; k < face.face().patch_count; ++k)
        for (const FarSide& side : far_sides(face.model(), face.face().first_patch + k)) {
            const KnotPiece& piece = side.piece;
            const bool at_end = piece.at >= (piece.constant_u ? domain.upper.x : domain.upper.y);
            if (at_end || !(piece.end > piece.begin)) continue;
            const std::vector<SeamPoint> points = places(face, side);
            if (std::none_of(points.begin(), points.end(), breaks_at)) continue;
            knots.pieces.push_back(piece);
            if (std::any_of(points.begin(), points.end(), gapes)) knots.torn.push_back(piece);
        }
    return knots;
}

} // namespace keiko
