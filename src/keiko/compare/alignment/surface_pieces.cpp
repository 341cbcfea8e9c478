#include "keiko/compare/alignment/surface_pieces.h"

#include "keiko/base/error.h"
#include "keiko/base/parallel.h"
#include "keiko/geometry/bezier/subpatch.h"
#include "keiko/intersect/subpatch/sub_patch_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {

BoundaryProjection::BoundaryProjection(const SurfaceModel& model)
    : curves_(model), borders_(curves_.all()) {
    constexpr double chord_error = 0.05; // mm
    std::vector<Box3> boxes;
    for (std::uint32_t i = 0; i < borders_.size(); ++i) {
        polylines_.push_back(make_polyline(curve(i), chord_error));
        const CurvePolyline& line = polylines_.back();
        for (std::uint32_t k = 0; k + 1 < line.points.size(); ++k) {
            Box3 box;
            box.extend(line.points[k]);
            box.extend(line.points[k + 1]);
            boxes.push_back(box.padded(line.deviation));
            chords_.push_back({i, k});
        }
    }
    tree_.emplace(std::move(boxes));
}

std::optional<ProjectedBoundaryPoint> BoundaryProjection::foot(
    const Vec3& p, double radius, const std::function<bool(std::uint32_t face)>& counts) const {
    std::optional<ProjectedBoundaryPoint> best;
    tree_->visit_near(p, radius, [&](std::uint32_t index) {
        const Chord& chord = chords_[index];
        if (counts && !counts(borders_[chord.border].face)) return radius;
        const std::vector<double>& t = polylines_[chord.border].t;
        const double begin = t[chord.first], end = t[chord.first + 1];
        const ClosestPoint found =
            closest_point(curve(chord.border), p, (begin + end) / 2, begin, end);
        if (found.distance < radius) {
            radius = found.distance;
            best = {chord.border, found.t, found.point.position, found.distance};
        }
        return radius;
    });
    return best;
}

namespace {

/// Bounds of a numerator of a frame's coordinate, its first and its second derivatives.
struct Numerator {
    double value, slope, bend;

    /// Bound of the coordinate's second derivatives, by the quotient rule with the weight 1 + w.
    double second(const ComponentBounds& w) const {
        const double least = 1 - w.value;
        return (bend + (2 * slope * w.slope + value * w.bend) / least +
                2 * value * w.slope * w.slope / (least * least)) /
               least;
    }
};

/// Least length of a x + b y over the unit circle.
double least_stretch(const Vec3& a, const Vec3& b) {
    const double uu = a.length2(), vv = b.length2(), uv = a.dot(b);
    return std::sqrt(std::max(0.0, (uu + vv) / 2 - std::hypot((uu - vv) / 2, uv)));
}

} // namespace

Convexity::Convexity(const BezierPatchView& piece) {
    const SubPatchFrame f = sub_patch_frame(piece);
    if (!f.regular) return;
    const auto& r = f.rows;
    const double determinant = r[0].dot(r[1].cross(r[2]));
    axes_ = {r[1].cross(r[2]) / determinant, r[2].cross(r[0]) / determinant,
             r[0].cross(r[1]) / determinant};
    const std::array<Numerator, 3> numerators{{{1 + f.u.value, 1 + f.u.slope, f.u.bend},
                                               {1 + f.v.value, 1 + f.v.slope, f.v.bend},
                                               {f.n.value, f.n.slope, f.n.bend}}};
    double value = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        second_[k] = numerators[k].second(f.w);
        value += axes_[k].length() * numerators[k].value;
    }
    const double off = axes_[0].length() * f.u.slope + axes_[1].length() * f.v.slope +
                       axes_[2].length() * f.n.slope;
    const double least = 1 - f.w.value;
    first_ = (least_stretch(axes_[0], axes_[1]) - off) / (1 + f.w.value) -
             value * f.w.slope / (least * least);
}

bool Convexity::holds(const BezierPatchView& piece, const Vec3& p) const {
    if (!(first_ > 0)) return false;
    std::array<double, 3> reach{};
    for (const Vec4& point : piece.points) {
        const Vec3 off = euclidean(point) - p;
        for (std::size_t k = 0; k < 3; ++k)
            reach[k] = std::max(reach[k], std::abs(off.dot(axes_[k])));
    }
    return first_ * first_ > reach[0] * second_[0] + reach[1] * second_[1] + reach[2] * second_[2];
}

namespace {

/// Bound of SubPatchFrame::contraction. Kept apart from TracerOptions: where an alignment from afar
/// begins changes with the pieces.
constexpr double piece_contraction = 0.65;

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
