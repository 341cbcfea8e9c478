#include "keiko/visibility/boundaries/boundary_piece.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/visibility/boundaries/adjacent_faces.h"
#include "keiko/visibility/boundaries/boundary_reach.h"
#include "keiko/visibility/boundaries/crease_lines.h"
#include "keiko/visibility/boundaries/curve_cover.h"

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

std::array<BoundaryPiece::Curve, 2> cut_at(const BoundaryPiece::Curve& curve, double t) {
    std::array<BoundaryPiece::Curve, 2> parts{curve, curve};
    auto& [low, high] = parts;
    constexpr std::size_t last = BoundaryPiece::points - 1;
    for (std::size_t level = 1; level <= last; ++level) {
        for (std::size_t i = 0; i + level <= last; ++i)
            high[i] = high[i] * (1 - t) + high[i + 1] * t;
        low[level] = high[0];
    }
    return parts;
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

} // namespace keiko
