#include "keiko/inspect/seams/seam_probe.h"

#include "keiko/base/units.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/geometry/seam/border_run.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace keiko {
namespace {

/// A side's frame at a place of the border. `across` is a unit vector across the border, from the
/// material out over the seam on side a and on into the material of side b. `normal` is to the left
/// of it and of the seam's run. On a smooth surface both sides have equal frames, for any
/// parametrisation.
struct Side {
    Vec3 across{0}, normal{0}, run{0};
    double curvature = 0, slope = 0;
};

Side side(const BoundaryFrame& frame, bool leaving, bool forward) {
    const Vec3 across = leaving ? -frame.inward : frame.inward;
    const Vec3 run = forward ? frame.tangent : -frame.tangent;
    const Vec3 left = across.cross(run);
    const Vec3 normal = left.dot(frame.normal) > 0 ? frame.normal : -frame.normal;
    return {across, normal, run, normal_curvature(frame.surface, normal, across),
            normal_curvature_slope(frame.surface, normal, across)};
}

/// The frame along a given direction, in place of the one square to the line; unchanged if that
/// direction leads out of the surface more than along it.
Side along_way(const Side& side, const SurfaceDerivatives& surface, const Vec3& way) {
    constexpr double mostly = 0.5;
    const Vec3 along = way - side.normal * way.dot(side.normal);
    if (!(along.length() > mostly * way.length())) return side;
    const Vec3 across = along.normalized();
    return {across, side.normal, side.normal.cross(across),
            normal_curvature(surface, side.normal, across),
            normal_curvature_slope(surface, side.normal, across)};
}

/// Area that a unit of both parameters covers; 0 where the surface has no frame.
double area_of(const std::optional<BoundaryFrame>& frame) {
    return frame ? frame->surface.du().cross(frame->surface.dv()).length() : 0;
}

/// Radians between the normals, negative where the surface bends the other way.
double turn_between(const Side& from, const Side& into) {
    const double angle = angle_between(from.normal, into.normal);
    return from.normal.cross(into.normal).dot(from.run) < 0 ? -angle : angle;
}

/// True if the path from one side to the other leads back over the material of either.
bool lies_on_material(const Vec3& apart, const Side& from, const Side& into) {
    const double least = 0.5 * apart.length();
    return -apart.dot(from.across) > least || -apart.dot(into.across) > least;
}

/// True if the path from one side to the other leads along both normals.
bool lies_over(const Vec3& apart, const Side& from, const Side& into) {
    const double least = 0.9 * apart.length();
    return std::abs(apart.dot(from.normal)) > least && std::abs(apart.dot(into.normal)) > least;
}

/// Radians that the normal turns about the run of the line on a path from one side to the other,
/// beyond what the mean of their curvatures explains; negative where the surface bends towards it.
/// At most pi: what turns over is a fold. A curvature whose radius is smaller than the path, as
/// where curvature has no bound, explains nothing of it: the whole turn counts.
double unexplained_turn(const Side& from, const Side& into, double way) {
    const double all =
        std::atan2(from.normal.cross(into.normal).dot(from.run), from.normal.dot(into.normal));
    const double largest = std::max(std::abs(from.curvature), std::abs(into.curvature));
    if (!(largest * way <= 1)) return all;
    const double turn = all + (from.curvature + into.curvature) / 2 * way;
    return std::clamp(turn, -std::numbers::pi, std::numbers::pi);
}

} // namespace

SeamProbe::SeamProbe(const SurfaceCurve& a, const ParameterInterval& on_a, const SurfaceCurve& b,
                     const ParameterInterval& on_b)
    : a_(a),
      b_(b),
      on_a_(on_a),
      on_b_(on_b),
      reach_b_(on_b),
      forward_(on_b.begin < on_b.end),
      changes_(find_changes()) {}

SeamProbe SeamProbe::part(const SeamPoint& from, const SeamPoint& to) const {
    SeamProbe result = *this;
    result.runs_out_.reset();
    result.on_a_ = {from.t, to.t}, result.on_b_ = {from.s, to.s};
    const auto is_beyond = [&](double t) { return !(t > from.t && t < to.t); };
    std::erase_if(result.changes_.a, is_beyond);
    std::erase_if(result.changes_.either, [&](const SeamStep& at) { return is_beyond(at.t); });
    return result;
}

std::optional<SeamProbe> SeamProbe::away_from_poles(double way) const {
    const SeamPoint middle = at((begin() + end()) / 2);
    SeamPoint from = at(begin(), on_b_.begin), to = at(end(), on_b_.end);
    const bool at_begin = collapses_towards(from, middle), at_end = collapses_towards(to, middle);
    if (!at_begin && !at_end) return std::nullopt;
    if (at_begin) from = inside_of(false, way);
    if (at_end) to = inside_of(true, way);
    return part(from, to);
}

bool SeamProbe::collapses_towards(const SeamPoint& end, const SeamPoint& inside) const {
    constexpr double next_to_nothing = 1e-3;
    const auto collapses = [](const SurfaceCurve& side, double t_end, double t_inside) {
        return area_of(side.frame(t_end)) < next_to_nothing * area_of(side.frame(t_inside));
    };
    return collapses(a_, end.t, inside.t) || collapses(b_, end.s, inside.s);
}

SeamPoint SeamProbe::inside_of(bool at_end, double way) const {
    const double end = at_end ? on_a_.end : on_a_.begin;
    const Vec3 from = place(end);
    double near = end, far = (on_a_.begin + on_a_.end) / 2;
    if ((place(far) - from).length() <= way) return at(far);
    for (double t = (near + far) / 2; t != near && t != far; t = (near + far) / 2)
        ((place(t) - from).length() < way ? near : far) = t;
    return at(far);
}

SeamPoint SeamProbe::at(double t, double s_guess) const {
    const Vec3 place = a_.at(t).position;
    const ClosestPoint foot = closest_point(b_, place, s_guess, reach_b_.begin, reach_b_.end);
    SeamPoint point;
    point.t = t, point.s = foot.t;
    point.place = place, point.gap = bend_ ? 0 : foot.distance;
    const auto frame_a = a_.frame(t, 3), frame_b = b_.frame(foot.t, 3);
    if (!frame_a || !frame_b) return point;
    Side from = side(*frame_a, true, true);
    Side into = side(*frame_b, false, forward_);
    const Vec3 apart = foot.point.position - place;
    if (!nearly_parallel(from.run, into.run, std::sin(parallel_borders))) {
        const Vec3 way = bend_ ? apart : from.across + into.across;
        from = along_way(from, frame_a->surface, way);
        into = along_way(into, frame_b->surface, way);
    }
    point.signed_angle = radians_to_degrees(bend_ ? unexplained_turn(from, into, foot.distance)
                                                  : turn_between(from, into));
    point.angle = std::abs(point.signed_angle);
    point.curvature_a = from.curvature, point.curvature_b = into.curvature;
    point.slope_a = from.slope, point.slope_b = into.slope;
    if (bend_) return point;
    point.overlap = lies_on_material(apart, from, into);
    point.stacked = lies_over(apart, from, into);
    return point;
}

SeamPoint SeamProbe::at(double t) const {
    const double length = on_a_.end - on_a_.begin;
    const double share = length != 0 ? (t - on_a_.begin) / length : 0;
    return at(t, on_b_.begin + share * (on_b_.end - on_b_.begin));
}

double SeamProbe::length(double from, double to) const {
    const auto first = std::upper_bound(changes_.a.begin(), changes_.a.end(), from);
    const auto last = std::lower_bound(first, changes_.a.end(), to);
    return a_.length(from, to, std::span(first, last));
}

SeamProbe::PatchChanges SeamProbe::find_changes() const {
    PatchChanges changes{a_.patch_changes(on_a_.begin, on_a_.end), {}};
    const auto [low, high] = std::minmax(on_b_.begin, on_b_.end);
    const std::vector<double> on_b = b_.patch_changes(low, high);
    if (!changes.a.empty() || !on_b.empty()) add_changes(on_b, changes);
    return changes;
}

/// Adds the changes of either side, each with the place of the other one that faces it. About that
/// place is known by the lengths of both.
void SeamProbe::add_changes(const std::vector<double>& on_b, PatchChanges& changes) const {
    constexpr int least = 16;
    const SideCourse a(a_, on_a_.begin, on_a_.end, least), b(b_, on_b_.begin, on_b_.end, least);
    for (const double t : changes.a) changes.either.push_back({t, b.parameter_at(a.share_at(t))});
    for (const double s : on_b) {
        const double guess = a.parameter_at(b.share_at(s));
        const Vec3 place = b_.at(s).position;
        changes.either.push_back({closest_point(a_, place, guess, on_a_.begin, on_a_.end).t, s});
    }
    std::sort(changes.either.begin(), changes.either.end(),
              [](const SeamStep& x, const SeamStep& y) { return x.t < y.t; });
}

std::vector<double> SeamProbe::patch_changes() const {
    std::vector<double> changes;
    for (const SeamStep& change : changes_.either) changes.push_back(change.t);
    return changes;
}

std::vector<SeamStep> SeamProbe::steps(int least) const {
    std::vector<SeamStep> stops{{on_a_.begin, on_b_.begin}};
    stops.insert(stops.end(), changes_.either.begin(), changes_.either.end());
    stops.push_back({on_a_.end, on_b_.end});
    return seam_steps(a_, b_, stops, least);
}

} // namespace keiko
