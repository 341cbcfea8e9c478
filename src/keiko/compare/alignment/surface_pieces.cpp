#include "keiko/compare/alignment/surface_pieces.h"

#include "keiko/base/error.h"
#include "keiko/base/parallel.h"
#include "keiko/geometry/bezier/subpatch.h"

namespace keiko {
namespace {

/// Bound of SubPatchFrame::contraction. Kept apart from TracerOptions: where an alignment from afar
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

std::array<Convexity, 4> quarter_convexity(const BezierPatchView& sub_patch) {
    std::array<Convexity, 4> quarters;
    auto next = quarters.begin();
    for (const Box2& half : halves(sub_patch, unit_square)) {
        const std::vector<Vec4> points = subpatch(sub_patch, half);
        for (const Box2& quarter : halves({sub_patch.degree_u, sub_patch.degree_v, points}, half)) {
            const std::vector<Vec4> part = subpatch(sub_patch, quarter);
            *next++ = Convexity({sub_patch.degree_u, sub_patch.degree_v, part});
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

ClosestPointQuery::Pieces::Pieces(PlacedModel placed, const Job& job) : body(std::move(placed)) {
    const SurfaceModel& model = body.model;
    if (model.patches.empty()) throw Error(model.source, "", "has no faces to compare");
    for (const Face& face : model.faces) trims.emplace_back(model, face);
    std::vector<SubPatchSet> sets(model.faces.size());
    parallel_for(sets.size(), job, "", [&](std::size_t f) {
        sets[f] = subdivide(model, model.faces[f], trims[f], 0, piece_contraction);
    });
    for (SubPatchSet& set : sets) append(sub_patches, std::move(set));
    std::vector<Box3> boxes;
    for (const SubPatch& sub_patch : sub_patches.sub_patches) {
        const BezierPatchView view = sub_patches.view(sub_patch);
        const Box3 box = hull_bounds(view);
        boxes.push_back({box.lower + sub_patch.center, box.upper + sub_patch.center});
        convex.emplace_back(view);
    }
    quarters.resize(sub_patches.sub_patches.size());
    parallel_for(quarters.size(), job, "", [&](std::size_t i) {
        quarters[i] = quarter_convexity(sub_patches.view(sub_patches.sub_patches[i]));
    });
    tree.emplace(std::move(boxes));
    borders.emplace(model);
}

std::optional<SurfacePoint> ClosestPointQuery::Pieces::point(std::uint32_t index,
                                                             const Vec2& uv) const {
    const SubPatch& sub_patch = sub_patches.sub_patches[index];
    if (!is_material(sub_patch, uv)) return std::nullopt;
    const std::uint32_t face = body.model.patches[sub_patch.patch].face;
    const SurfaceDerivatives s = evaluate(sub_patches.view(sub_patch), uv, 2);
    return SurfacePoint{.piece = index,
                        .uv = uv,
                        .face = face,
                        .position = s.position() + sub_patch.center,
                        .normal = outward_normal(s, uv, body.model.faces[face]),
                        .stretch = s.du().cross(s.dv()).length()};
}

bool ClosestPointQuery::Pieces::is_material(const SubPatch& sub_patch, const Vec2& uv) const {
    if (sub_patch.trim == TrimSide::inside) return true;
    return trims[body.model.patches[sub_patch.patch].face].contains(
        body.model.face_parameters(sub_patch.patch, sub_patch.patch_parameters(uv)));
}

} // namespace keiko
