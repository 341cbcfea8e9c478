#include "keiko/inspect/face_combs.h"

#include "keiko/inspect/field_cells.h"
#include "keiko/patch/differential_geometry.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace keiko {
namespace {

/// Of the body's size: how far apart on a curve trims are asked.
constexpr double trim_step = 1e-3;
constexpr int most_halvings = 8; ///< between two points of a curve

/// The height over the plane times the weight, which has the same zeros.
BernsteinField height_field(const PlacedPatch& patch, const BezierPatchView& view,
                            const SectionPlane& plane) {
    const double height = plane.height - plane.normal.dot(patch.middle);
    std::vector<double> values;
    for (const Vec4& p : view.points)
        values.push_back(plane.normal.dot(Vec3(p.x, p.y, p.z)) - height * p.w);
    return {view.degree_u, view.degree_v, std::move(values), patch.rounding};
}

} // namespace

FaceCombs::FaceCombs(const SurfaceModel& model, const CombFace& placed, const CombOptions& options,
                     double size)
    : model_(model),
      placed_(placed),
      face_(model.faces[placed.face]),
      trims_(model, face_),
      options_(options),
      size_(size) {
    for (std::uint32_t p = 0; p < face_.patch_count; ++p)
        for (const Vec2& corner : {Vec2(0), Vec2(1)})
            domain_.extend(model.face_parameters(face_.first_patch + p, corner));
    const bool mirrored = model.instances[placed.instance].transform.mirrored();
    sign_ = face_.reversed != mirrored ? -1 : 1;
}

std::vector<CombPiece> FaceCombs::run(const CombFamily& family) const {
    std::vector<CombPiece> pieces;
    for (std::uint32_t p = face_.first_patch; p < face_.first_patch + face_.patch_count; ++p)
        run_on(p, family, pieces);
    return pieces;
}

void FaceCombs::run_on(std::uint32_t index, const CombFamily& family,
                       std::vector<CombPiece>& pieces) const {
    const PlacedPatch patch(model_, index, model_.instances[placed_.instance].transform);
    const BezierPatchView own = model_.patch(index);
    const BezierPatchView view{own.degree_u, own.degree_v, patch.points};
    const auto field = field_of(family, patch, view);
    if (!field || !field->range().holds_zero()) return;
    const FieldZeros zeros(patch, view, *field);
    const auto material = [&](const LinePoint& at) {
        return trims_.untrimmed() || trims_.contains(model_.face_parameters(index, at.uv));
    };
    for (const PatchLine& line : material_pieces(field_cells(*field), zeros, options_.chord_error,
                                                 trim_step * size_, material)) {
        CombPiece piece{placed_.instance, placed_.face, index, samples(family, view, zeros, line)};
        if (piece.samples.size() > 1) pieces.push_back(std::move(piece));
    }
}

std::optional<BernsteinField> FaceCombs::field_of(const CombFamily& family,
                                                  const PlacedPatch& patch,
                                                  const BezierPatchView& view) const {
    if (family.kind == CombCurve::Kind::section) return height_field(patch, view, family.plane);
    const bool by_u = family.kind == CombCurve::Kind::iso_u;
    const auto axis = [by_u](const Vec2& p) { return by_u ? p.x : p.y; };
    const double at =
        axis(domain_.lower) + family.share * (axis(domain_.upper) - axis(domain_.lower));
    const double begin = axis(model_.face_parameters(patch.index, Vec2(0))),
                 end = axis(model_.face_parameters(patch.index, Vec2(1)));
    // A border between patches belongs to the one beyond it.
    if (!(std::min(begin, end) <= at && at < std::max(begin, end))) return std::nullopt;
    return iso_field(by_u, local_share(patch.index, by_u, at));
}

/// The patch parameter at which a parameter of the face is reached; parameters rise or fall all
/// along a patch, not always evenly.
double FaceCombs::local_share(std::uint32_t patch, bool by_u, double at) const {
    const auto reached = [&](double t) {
        const Vec2 p = model_.face_parameters(patch, Vec2(t));
        return by_u ? p.x : p.y;
    };
    const bool rising = reached(0) < reached(1);
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        ((reached(middle) < at) == rising ? low : high) = middle;
    }
    return (low + high) / 2;
}

std::optional<CombSample> FaceCombs::sample_at(const CombFamily& family,
                                               const BezierPatchView& view,
                                               const LinePoint& at) const {
    const SurfaceDerivatives s = evaluate(view, at.uv, 2);
    const std::optional<Vec3> normal = unit_normal(s, at.uv);
    if (!normal || !reliable_curvatures(s, *normal)) return std::nullopt;
    const Vec3 outward = *normal * sign_;
    const Vec2 along = family.kind == CombCurve::Kind::iso_u ? Vec2(0, 1) : Vec2(1, 0);
    const auto bend = family.kind == CombCurve::Kind::section
                          ? section_bend(s, outward, family.plane.normal)
                          : normal_bend(s, outward, along);
    if (!bend) return std::nullopt;
    return CombSample{at.place, 0, *bend};
}

/// At the points of the line and, until straight lines between them are true enough, between.
std::vector<CombSample> FaceCombs::samples(const CombFamily& family, const BezierPatchView& view,
                                           const ZeroFunction& zeros, const PatchLine& line) const {
    std::vector<Point> points;
    double largest = 1 / size_;
    for (const LinePoint& at : line.points)
        if (const auto found = sample_at(family, view, at)) {
            points.push_back({at, *found});
            largest = std::max(largest, std::abs(found->bend.curvature));
        }
    if (points.empty()) return {};
    std::vector<CombSample> all{points.front().sample};
    const std::function<void(const Point&, const Point&, int)> fill =
        [&](const Point& a, const Point& b, int halvings) {
            const auto at = halvings > 0 ? zeros.between(a.at, b.at, 0.5) : std::nullopt;
            const auto found = at ? sample_at(family, view, *at) : std::nullopt;
            if (!found) {
                all.push_back(b.sample);
                return;
            }
            const double straight = (a.sample.bend.curvature + b.sample.bend.curvature) / 2;
            const double off = std::abs(found->bend.curvature - straight);
            const int left = off <= options_.tolerance * largest ? 0 : halvings - 1;
            fill(a, {*at, *found}, left);
            fill({*at, *found}, b, left);
        };
    for (std::size_t i = 1; i < points.size(); ++i) fill(points[i - 1], points[i], most_halvings);
    return all;
}

} // namespace keiko
