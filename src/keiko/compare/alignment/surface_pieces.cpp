#include "keiko/compare/alignment/surface_pieces.h"

#include "keiko/base/error.h"
#include "keiko/base/parallel.h"

#include <algorithm>
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

/// Bound of SubPatchFrame::contraction. Kept apart from TracerOptions: where an alignment from afar
/// begins changes with the pieces.
constexpr double piece_contraction = 0.65;

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
    }
    for (const SubPatchFrame& frame : sub_patches.frames) bounds.emplace_back(frame);
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
