#include "keiko/inspect/seam_probe.h"

#include "keiko/base/units.h"
#include "keiko/patch/closest_point.h"
#include "keiko/patch/curvature_slope.h"
#include "keiko/patch/differential_geometry.h"

namespace keiko {
namespace {

/// A unit vector across the border, from the material out over the seam on side a and on into
/// the material of side b, and the normal to the left of it and of the seam's run: for both
/// sides of a smooth surface the same, however each side is parametrised.
struct Side {
    Vec3 across{0}, normal{0};
    double curvature = 0, slope = 0;
};

Side side(const BoundaryFrame& frame, bool leaving, bool forward) {
    const Vec3 across = leaving ? -frame.inward : frame.inward;
    const Vec3 run = forward ? frame.tangent : -frame.tangent;
    const Vec3 left = across.cross(run);
    const Vec3 normal = left.dot(frame.normal) > 0 ? frame.normal : -frame.normal;
    return {across, normal, normal_curvature(frame.surface, normal, across),
            normal_curvature_slope(frame.surface, normal, across)};
}

} // namespace

SeamPoint SeamProbe::at(double t, double s_guess) const {
    const Vec3 place = a_.at(t).position;
    const ClosestPoint foot = closest_point(b_, place, s_guess, on_b_.begin, on_b_.end);
    SeamPoint point;
    point.t = t, point.s = foot.t;
    point.place = place, point.gap = foot.distance;
    const auto frame_a = a_.frame(t, 3), frame_b = b_.frame(foot.t, 3);
    if (!frame_a || !frame_b) return point;
    const Side from = side(*frame_a, true, true);
    const Side into = side(*frame_b, false, on_b_.begin < on_b_.end);
    point.angle = radians_to_degrees(angle_between(from.normal, into.normal));
    point.curvature_a = from.curvature;
    point.curvature_b = into.curvature;
    point.slope_a = from.slope, point.slope_b = into.slope;
    const Vec3 apart = foot.point.position - place;
    point.overlap = -apart.dot(from.across) > 0.5 * foot.distance ||
                    -apart.dot(into.across) > 0.5 * foot.distance;
    return point;
}

SeamPoint SeamProbe::at(double t) const {
    const double share = (t - on_a_.begin) / (on_a_.end - on_a_.begin);
    return at(t, on_b_.begin + share * (on_b_.end - on_b_.begin));
}

} // namespace keiko
