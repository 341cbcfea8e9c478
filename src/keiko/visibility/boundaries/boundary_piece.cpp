#include "keiko/visibility/boundaries/boundary_piece.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/visibility/boundaries/adjacent_faces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {

namespace {

/// Whether opposite sides of a face without loops are one line, crossed smoothly.
bool closes_smoothly(const SurfaceCurve& side, const SurfaceCurve& opposite) {
    constexpr int samples = 9;
    constexpr double same_place = 1e-10, same_normal = 1e-9;
    Box3 box;
    for (int i = 0; i <= samples; ++i) box.extend(side.at(double(i) / samples).position);
    const double scale = box.size() + box.center().length();
    for (int i = 0; i <= samples; ++i) {
        const double t = double(i) / samples;
        if (!((side.at(t).position - opposite.at(1 - t).position).length() <= same_place * scale))
            return false;
        const auto a = side.frame(t), b = opposite.frame(1 - t);
        if (a && b && !(angle_between(a->normal, b->normal) <= same_normal)) return false;
    }
    return true;
}

bool is_smooth_closing(const BoundaryCurves& borders, const BoundaryInterval& interval) {
    if (interval.curve < natural_side) return false;
    BoundaryInterval opposite = interval;
    opposite.curve = natural_side + (interval.curve - natural_side + 2) % 4;
    return closes_smoothly(borders.curve(interval), borders.curve(opposite));
}

double reach_of(const SurfaceModel& model, const Tracer& tracer, const BoundaryInterval& border) {
    if (border.curve >= natural_side) return boundary_reach(model, border.instance, border.face);
    return boundary_reach(model, tracer, border.instance, border.face, border.curve);
}

/// By border curve.
std::vector<std::vector<BoundaryPiece>> border_covers(const SurfaceModel& model,
                                                      const Tracer& tracer, const Job& job) {
    const BoundaryCurves borders(model);
    const AdjacentFaces partners(model, borders, tracer);
    const std::vector<BoundaryInterval> intervals = borders.all();
    std::vector<std::vector<BoundaryPiece>> covers(intervals.size());
    parallel_for(intervals.size(), job, "borders", [&](std::size_t i) {
        if (is_smooth_closing(borders, intervals[i])) return;
        BoundaryPiece kind;
        kind.instance = intervals[i].instance;
        kind.face = intervals[i].face;
        kind.error = reach_of(model, tracer, intervals[i]);
        const auto partner = partners.partner(intervals[i]);
        const auto beyond = [&](double, const Vec3& place) {
            return partner ? partner->inward_at(place) : std::nullopt;
        };
        covers[i] = curve_cover(borders.curve(intervals[i]), beyond, kind);
    });
    return covers;
}

/// By crease.
std::vector<std::vector<BoundaryPiece>> crease_covers(const SurfaceModel& model, const Job& job) {
    const CreaseLines creases(model);
    std::vector<std::vector<BoundaryPiece>> covers(creases.all().size());
    parallel_for(creases.all().size(), job, "creases", [&](std::size_t i) {
        const CreaseLine& line = creases.all()[i];
        BoundaryPiece kind;
        kind.instance = line.instance;
        kind.face = line.face;
        kind.error = boundary_reach(model, line.instance, line.face);
        kind.trimmed = model.faces[line.face].loop_count > 0;
        kind.first = Vec2(line.p_curve[0].x, line.p_curve[0].y);
        kind.last = Vec2(line.p_curve[1].x, line.p_curve[1].y);
        const auto beyond = [&](double t, const Vec3&) { return creases.inward_beyond(line, t); };
        covers[i] = curve_cover(creases.curve(line), beyond, kind);
    });
    return covers;
}

} // namespace

Vec3 point_on(const BoundaryPiece::Curve& curve, double t) {
    static_assert(BoundaryPiece::points == 6);
    const double s = 1 - t, ss = s * s, tt = t * t;
    return curve[0] * (ss * ss * s) + curve[1] * (5 * ss * ss * t) + curve[2] * (10 * ss * s * tt) +
           curve[3] * (10 * ss * tt * t) + curve[4] * (5 * s * tt * tt) + curve[5] * (tt * tt * t);
}

/// The ways from which a cone of normals is not seen edge-on are a convex cone themselves, so that
/// the control points speak for the curve.
bool BoundaryPiece::may_be_edge_on(const Viewpoint& viewpoint, const Curve& part) const {
    if (!(normal_angle < std::numbers::pi / 2)) return true;
    const double sine = std::sin(normal_angle);
    bool before = true, behind = true;
    for (const Vec3& p : part) {
        const Vec3 way = viewpoint.way_to(center + p);
        const double rise = normal.dot(way), least = sine * way.length() + 2 * error;
        before = before && rise > least;
        behind = behind && rise < -least;
    }
    return !before && !behind;
}

Vec3 BoundaryPiece::at(double t) const {
    return point_on(curve, t);
}

Vec3 BoundaryPiece::derivative(double t) const {
    static_assert(points == 6);
    const double s = 1 - t, ss = s * s, tt = t * t;
    const Curve& c = curve;
    return ((c[1] - c[0]) * (ss * ss) + (c[2] - c[1]) * (4 * ss * s * t) +
            (c[3] - c[2]) * (6 * ss * tt) + (c[4] - c[3]) * (4 * s * tt * t) +
            (c[5] - c[4]) * (tt * tt)) *
           5;
}

Vec3 BoundaryPiece::inward_at(double t) const {
    return inward[0] * ((1 - 2 * t) * (1 - t)) + inward[1] * (4 * t * (1 - t)) +
           inward[2] * (t * (2 * t - 1));
}

std::vector<BoundaryPiece> boundary_pieces(const SurfaceModel& model, const Tracer& tracer,
                                           const Job& job) {
    std::vector<BoundaryPiece> all;
    for (const auto& covers : {border_covers(model, tracer, job), crease_covers(model, job)})
        for (const auto& cover : covers) all.insert(all.end(), cover.begin(), cover.end());
    return all;
}

namespace {

/// Bound of what a placement makes of a length.
double most_stretch(const Affine& placement) {
    double squares = 0;
    for (const Vec3& row : placement.rows) squares += row.length2();
    return placement.is_identity() ? 1 : std::sqrt(squares);
}

} // namespace

double boundary_reach(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face) {
    Box3 box;
    for (std::uint32_t i = 0; i < model.faces[face].patch_count; ++i)
        box.extend(hull_bounds(model.patch(model.faces[face].first_patch + i)));
    const Box3 placed = transformed(model.instances[instance].transform, box);
    // Of the face, more than sub-patches overlap by and go on past its ends; of the coordinates.
    constexpr double overlap = 1e-10, rounding = 1e-14;
    return overlap * placed.size() + rounding * placed.center().length();
}

double boundary_reach(const SurfaceModel& model, const Tracer& tracer, std::uint32_t instance,
                      std::uint32_t face, std::uint32_t trim_curve) {
    const double seam =
        tracer.seam_width(trim_curve) * most_stretch(model.instances[instance].transform);
    return std::max(seam, boundary_reach(model, instance, face));
}

namespace {

constexpr double same_normal = 1e-9; ///< rad

std::optional<Vec3> normal_at(const SurfaceModel& model, std::uint32_t patch,
                              const Vec2& face_parameters) {
    const Patch& p = model.patches[patch];
    const Vec2 uv(p.map_u.to_patch(face_parameters.x), p.map_v.to_patch(face_parameters.y));
    return unit_normal(evaluate(model.patch(patch), uv, 2), uv);
}

/// The four sides of a patch in face parameters, anticlockwise there.
std::array<std::array<Vec3, 2>, 4> sides_of(const SurfaceModel& model, std::uint32_t patch) {
    Box2 box;
    box.extend(model.face_parameters(patch, Vec2(0)));
    box.extend(model.face_parameters(patch, Vec2(1)));
    const Vec3 a(box.lower.x, box.lower.y, 1), b(box.upper.x, box.lower.y, 1);
    const Vec3 c(box.upper.x, box.upper.y, 1), d(box.lower.x, box.upper.y, 1);
    return {{{a, b}, {b, c}, {c, d}, {d, a}}};
}

} // namespace

CreaseLines::CreaseLines(const SurfaceModel& model) : model_(&model) {
    for (const Face& face : model.faces) grids_.emplace_back(model, face);
    for (std::uint32_t i = 0; i < model.instances.size(); ++i) {
        const Part& part = model.parts[model.instances[i].part];
        for (std::uint32_t f = part.first_face; f < part.first_face + part.face_count; ++f) {
            const Face& face = model.faces[f];
            for (std::uint32_t k = 0; face.patch_count > 1 && k < face.patch_count; ++k)
                for (const auto& side : sides_of(model, face.first_patch + k)) {
                    const CreaseLine line{i, f, side};
                    if (normal_jumps(face.first_patch + k, line)) lines_.push_back(line);
                }
        }
    }
}

bool CreaseLines::normal_jumps(std::uint32_t patch, const CreaseLine& line) const {
    constexpr int samples = 9;
    const Vec2 first(line.p_curve[0].x, line.p_curve[0].y);
    const Vec2 way = Vec2(line.p_curve[1].x, line.p_curve[1].y) - first;
    for (int i = 0; i < samples; ++i) {
        const Vec2 at = first + way * ((i + 0.5) / samples);
        const std::uint32_t beyond = grids_[line.face].locate(at, Vec2(way.y, -way.x));
        if (beyond == patch) return false;
        const auto here = normal_at(*model_, patch, at), there = normal_at(*model_, beyond, at);
        if (here && there && !(angle_between(*here, *there) <= same_normal)) return true;
    }
    return false;
}

SurfaceCurve CreaseLines::curve(const CreaseLine& line) const {
    return {*model_,
            grids_[line.face],
            model_->instances[line.instance].transform,
            {line.p_curve},
            true};
}

std::optional<Vec3> CreaseLines::inward_beyond(const CreaseLine& line, double t) const {
    const CreaseLine back{line.instance, line.face, {line.p_curve[1], line.p_curve[0]}};
    const auto frame = curve(back).frame(1 - t);
    return frame ? std::optional(frame->inward) : std::nullopt;
}

} // namespace keiko
