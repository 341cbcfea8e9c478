#include "keiko/inspect/seam_probe.h"

#include "keiko/base/units.h"
#include "keiko/patch/closest_point.h"
#include "keiko/patch/differential_geometry.h"

namespace keiko {
namespace {

/// A unit vector across the border, from the material out over the seam on side a and on into
/// the material of side b, and the normal to the left of it and of the seam's run: for both
/// sides of a smooth surface the same, however each side is parametrised.
struct Side {
    Vec3 across{0}, normal{0};
    double curvature = 0;
};

Side side(const BoundaryFrame& frame, bool leaving, bool forward) {
    const Vec3 across = leaving ? -frame.inward : frame.inward;
    const Vec3 run = forward ? frame.tangent : -frame.tangent;
    const Vec3 left = across.cross(run);
    const Vec3 normal = left.dot(frame.normal) > 0 ? frame.normal : -frame.normal;
    return {across, normal, normal_curvature(frame.surface, normal, across)};
}

} // namespace

SeamPoint SeamProbe::at(double t, double s_guess) const {
    const Vec3 place = a_.at(t).position;
    const ClosestPoint foot = closest_point(b_, place, s_guess, seam_.b.begin, seam_.b.end);
    SeamPoint point{t, foot.t, place, foot.distance, std::nullopt, 0, 0};
    const auto frame_a = a_.frame(t), frame_b = b_.frame(foot.t);
    if (!frame_a || !frame_b) return point;
    const Side from = side(*frame_a, true, true);
    const Side into = side(*frame_b, false, seam_.b.begin < seam_.b.end);
    point.angle = radians_to_degrees(angle_between(from.normal, into.normal));
    point.curvature_a = from.curvature;
    point.curvature_b = into.curvature;
    return point;
}

SeamPoint SeamProbe::at(double t) const {
    const double share = (t - seam_.a.begin) / (seam_.a.end - seam_.a.begin);
    return at(t, seam_.b.begin + share * (seam_.b.end - seam_.b.begin));
}

} // namespace keiko
