#include "keiko/compare/alignment/surface_pieces.h"

#include "keiko/base/error.h"
#include "keiko/base/parallel.h"
#include "keiko/geometry/bezier/subpatch.h"

namespace keiko {
namespace {

/// Bound of LeafFrame::contraction. Kept apart from TracerOptions: where an alignment from afar
/// begins changes with the pieces.
constexpr double piece_contraction = 0.65;

Vec3 euclidean(const Vec4& p) {
    return Vec3(p.x, p.y, p.z) / p.w;
}

/// Boxes of the leaf's parameters, the lower half first.
std::array<Box2, 2> halves(const BezierPatchView& piece, const Box2& box) {
    const unsigned axis = longer_side(piece);
    std::array<Box2, 2> both{box, box};
    both[0].upper[axis] = both[1].lower[axis] = box.center()[axis];
    return both;
}

std::array<Convexity, 4> quarter_convexity(const BezierPatchView& leaf) {
    std::array<Convexity, 4> quarters;
    auto next = quarters.begin();
    for (const Box2& half : halves(leaf, unit_square)) {
        const std::vector<Vec4> points = subpatch(leaf, half);
        for (const Box2& quarter : halves({leaf.degree_u, leaf.degree_v, points}, half)) {
            const std::vector<Vec4> part = subpatch(leaf, quarter);
            *next++ = Convexity({leaf.degree_u, leaf.degree_v, part});
        }
    }
    return quarters;
}

} // namespace

unsigned longer_side(const BezierPatchView& piece) {
    const Vec3 a = euclidean(piece.point(0, 0)), b = euclidean(piece.point(piece.degree_u, 0));
    const Vec3 c = euclidean(piece.point(0, piece.degree_v));
    const Vec3 d = euclidean(piece.point(piece.degree_u, piece.degree_v));
    const double along_u = (b - a).length() + (d - c).length();
    const double along_v = (c - a).length() + (d - b).length();
    return along_u >= along_v ? 0 : 1;
}

Vec3 outward_normal(const SurfaceDerivatives& s, const Vec2& uv, const Face& face) {
    const auto normal = unit_normal(s, uv);
    if (!normal) return Vec3(0);
    return face.reversed ? -*normal : *normal;
}

SurfaceFeet::Pieces::Pieces(PlacedModel placed, const Job& job) : body(std::move(placed)) {
    const SurfaceModel& model = body.model;
    if (model.patches.empty()) throw Error(model.source, "", "has no faces to compare");
    for (const Face& face : model.faces) trims.emplace_back(model, face);
    std::vector<LeafSet> sets(model.faces.size());
    parallel_for(sets.size(), job, "", [&](std::size_t f) {
        sets[f] = make_leaves(model, model.faces[f], trims[f], 0, piece_contraction);
    });
    for (LeafSet& set : sets) append(leaves, std::move(set));
    std::vector<Box3> boxes;
    for (const Leaf& leaf : leaves.leaves) {
        const BezierPatchView view = leaves.view(leaf);
        const Box3 box = hull_bounds(view);
        boxes.push_back({box.lower + leaf.center, box.upper + leaf.center});
        convex.emplace_back(view);
    }
    quarters.resize(leaves.leaves.size());
    parallel_for(quarters.size(), job, "", [&](std::size_t i) {
        quarters[i] = quarter_convexity(leaves.view(leaves.leaves[i]));
    });
    tree.emplace(std::move(boxes));
    borders.emplace(model);
}

std::optional<SurfacePoint> SurfaceFeet::Pieces::point(std::uint32_t index, const Vec2& uv) const {
    const Leaf& leaf = leaves.leaves[index];
    if (!is_material(leaf, uv)) return std::nullopt;
    const std::uint32_t face = body.model.patches[leaf.patch].face;
    const SurfaceDerivatives s = evaluate(leaves.view(leaf), uv, 2);
    return SurfacePoint{.piece = index,
                        .uv = uv,
                        .face = face,
                        .position = s.position() + leaf.center,
                        .normal = outward_normal(s, uv, body.model.faces[face]),
                        .stretch = s.du().cross(s.dv()).length()};
}

bool SurfaceFeet::Pieces::is_material(const Leaf& leaf, const Vec2& uv) const {
    if (leaf.trim == TrimSide::inside) return true;
    return trims[body.model.patches[leaf.patch].face].contains(
        body.model.face_parameters(leaf.patch, leaf.patch_parameters(uv)));
}

} // namespace keiko
