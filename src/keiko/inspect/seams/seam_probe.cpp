#include "keiko/inspect/seams/seam_probe.h"

#include "keiko/base/units.h"
#include "keiko/geometry/bezier/curvature_slope.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/geometry/model/closest_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// A unit vector across the border, from the material out over the seam on side a and on into
/// the material of side b, and the normal to the left of it and of the seam's run: for both
/// sides of a smooth surface the same, however each side is parametrised.
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

/// Radians that the normal turns about the run of the line on a way from one side to the other,
/// beyond what the mean of their curvatures explains; negative where the surface bends towards it.
double unexplained_turn(const Side& from, const Side& into, double way) {
    const double all =
        std::atan2(from.normal.cross(into.normal).dot(from.run), from.normal.dot(into.normal));
    return all + (from.curvature + into.curvature) / 2 * way;
}

/// Moves a step by up to a tenth either way, so that no regular wave has its zeros at all of them:
/// the fractions of the golden section's multiples.
double uneven(int i) {
    constexpr double golden = 0.6180339887498949, most = 0.1;
    return most * (2 * std::fmod(i * golden, 1.0) - 1);
}

/// Steps of a polynomial's parameter that are shorter towards its ends, as its waves may be.
double polynomial_share(double share) {
    return (1 - std::cos(std::numbers::pi * share)) / 2;
}

} // namespace

SeamProbe SeamProbe::part(const SeamPoint& from, const SeamPoint& to) const {
    SeamProbe result = *this;
    result.on_a_ = {from.t, to.t}, result.on_b_ = {from.s, to.s};
    return result;
}

SeamPoint SeamProbe::at(double t, double s_guess) const {
    const Vec3 place = a_.at(t).position;
    const ClosestPoint foot = closest_point(b_, place, s_guess, reach_b_.begin, reach_b_.end);
    SeamPoint point;
    point.t = t, point.s = foot.t;
    point.place = place, point.gap = bend_ ? 0 : foot.distance;
    const auto frame_a = a_.frame(t, 3), frame_b = b_.frame(foot.t, 3);
    if (!frame_a || !frame_b) return point;
    const Side from = side(*frame_a, true, true);
    const Side into = side(*frame_b, false, forward_);
    point.angle = radians_to_degrees(angle_between(from.normal, into.normal));
    point.signed_angle =
        from.normal.cross(into.normal).dot(from.run) < 0 ? -*point.angle : *point.angle;
    point.curvature_a = from.curvature;
    point.curvature_b = into.curvature;
    point.slope_a = from.slope, point.slope_b = into.slope;
    if (bend_) {
        point.signed_angle = radians_to_degrees(unexplained_turn(from, into, foot.distance));
        point.angle = std::abs(point.signed_angle);
        return point;
    }
    const Vec3 apart = foot.point.position - place;
    point.overlap = -apart.dot(from.across) > 0.5 * foot.distance ||
                    -apart.dot(into.across) > 0.5 * foot.distance;
    return point;
}

SeamPoint SeamProbe::at(double t) const {
    const double length = on_a_.end - on_a_.begin;
    const double share = length != 0 ? (t - on_a_.begin) / length : 0;
    return at(t, on_b_.begin + share * (on_b_.end - on_b_.begin));
}

std::vector<double> SeamProbe::patch_changes() const {
    std::vector<double> changes = a_.patch_changes(on_a_.begin, on_a_.end);
    const auto [low, high] = std::minmax(on_b_.begin, on_b_.end);
    for (const double s : b_.patch_changes(low, high)) {
        const double share = (s - on_b_.begin) / (on_b_.end - on_b_.begin);
        const double guess = on_a_.begin + share * (on_a_.end - on_a_.begin);
        changes.push_back(closest_point(a_, b_.at(s).position, guess, on_a_.begin, on_a_.end).t);
    }
    std::sort(changes.begin(), changes.end());
    return changes;
}

/// In which a search of the steps' ends and middles sees the waves of a polynomial of that degree.
int SeamProbe::least_steps(double from, double stop) const {
    const double t = (from + stop) / 2, span = on_a_.end - on_a_.begin;
    const double s = on_b_.begin + (t - on_a_.begin) / span * (on_b_.end - on_b_.begin);
    return std::max({2, a_.degree_at(t), b_.degree_at(s)});
}

std::vector<double> SeamProbe::steps(int least) const {
    const double span = on_a_.end - on_a_.begin;
    std::vector<double> stops = patch_changes();
    stops.push_back(on_a_.end);
    std::vector<double> result{on_a_.begin};
    constexpr double distinct = 1e-12; // share of the seam: changes of both sides at one place
    for (const double stop : stops) {
        const double from = result.back();
        if (!(stop - from > distinct * span)) continue;
        const int count = std::max(least_steps(from, stop),
                                   static_cast<int>(std::ceil((stop - from) / span * least)));
        for (int i = 1; i < count; ++i)
            result.push_back(from + (stop - from) * polynomial_share((i + uneven(i)) / count));
        result.push_back(stop);
    }
    if (result.size() > 1) result.back() = on_a_.end;
    return result;
}

} // namespace keiko
