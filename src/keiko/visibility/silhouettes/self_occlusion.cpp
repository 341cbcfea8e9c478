#include "keiko/visibility/silhouettes/self_occlusion.h"

#include "keiko/geometry/bezier/bezier_patch.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/geometry/bezier/subpatch.h"
#include "keiko/math/axes.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

struct Interval {
    double low, high;
};

Interval operator*(const NetRange& a, const Interval& b) {
    const double p[4] = {a.low() * b.low, a.low() * b.high, a.high() * b.low, a.high() * b.high};
    return {*std::min_element(p, p + 4), *std::max_element(p, p + 4)};
}

Interval product(const NetRange& a, const NetRange& b) {
    return a * Interval{b.low(), b.high()};
}

Interval square(const NetRange& a) {
    const double low = a.low() * a.low(), high = a.high() * a.high();
    return {a.holds_zero() ? 0 : std::min(low, high), std::max(low, high)};
}

/// In fewer coefficients where those are enough: the first ring reaches down to a hundredth of the
/// largest values.
DegreeReducedScalar cheaper(const ScalarNet& edge_on) {
    constexpr double enough = 1e-4;
    for (const std::size_t degree : {5u, 8u}) {
        DegreeReducedScalar low = lowered(edge_on, degree);
        if (low.error <= enough * range(edge_on).half) return low;
    }
    return {edge_on};
}

/// The parts of a box beside an inner one.
std::vector<Box2> beside(const Box2& outer, const Box2& inner) {
    const double x[4] = {outer.lower.x, inner.lower.x, inner.upper.x, outer.upper.x};
    const double y[4] = {outer.lower.y, inner.lower.y, inner.upper.y, outer.upper.y};
    std::vector<Box2> boxes;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if ((i != 1 || j != 1) && x[i] < x[i + 1] && y[j] < y[j + 1])
                boxes.push_back({Vec2(x[i], y[j]), Vec2(x[i + 1], y[j + 1])});
    return boxes;
}

Box2 shrunk(const Box2& box, const Vec2& about) {
    constexpr double shrink = 0.2;
    const Vec2 half = box.extent() * (shrink / 2);
    return box.intersection({about - half, about + half});
}

HomogeneousNet part_of(const HomogeneousNet& net, const Box2& uv) {
    return {net.degree_u, net.degree_v, subpatch(net.view(), uv)};
}

/// Any axes about a normal that is none.
NetFrame frame_at(const OccluderPatch& patch, const Vec2& foot) {
    NetFrame frame{patch.center};
    const auto normal = unit_normal(evaluate(patch.points.view(), foot, 2), foot);
    if (!normal) return frame;
    const Vec3 along = any_perpendicular(*normal).normalized();
    frame.rows = {along, normal->cross(along), *normal};
    return frame;
}

} // namespace

SelfOcclusion::SelfOcclusion(const OccluderPatch& patch, const Box2& uv, const Vec2& foot,
                             ScalarNet edge_on)
    : patch_(&patch),
      uv_(uv),
      foot_((foot - uv.lower) / uv.extent()),
      frame_(frame_at(patch, foot)),
      points_(turned(patch.points, frame_)),
      edge_on_(std::move(edge_on)) {}

SelfOcclusion::Shell& SelfOcclusion::shell(std::size_t k) const {
    while (shells_.size() <= k) {
        const Box2 box = shells_.empty() ? unit_square : shrunk(shells_.back().box, foot_);
        const ScalarNet& exact = shells_.empty() ? edge_on_ : restricted(edge_on_, box);
        DegreeReducedScalar edge_on = cheaper(exact);
        const NetCurvature second = net_curvature(edge_on, exact);
        shells_.push_back({box, part_of(points_, of_patch(box)), std::move(edge_on), second});
    }
    return shells_[k];
}

/// By Taylor's theorem the function has no other zero on a section f = 0 through the viewpoint
/// where its second derivative keeps its sign along every chord that the section may have.
bool SelfOcclusion::only_viewpoint_in(std::size_t k, const Vec4& weights) const {
    const Shell& in = shell(k);
    const ScalarNet f = weighed(in.points, weights);
    const NetRange fx = derivative_range(f, true), fy = derivative_range(f, false);
    if (fx.holds_zero() && fy.holds_zero()) return false;
    const Interval xx = in.second.xx * square(fy), yy = in.second.yy * square(fx);
    const Interval xy = NetRange{-2 * in.second.xy.middle, 2 * in.second.xy.half} * product(fx, fy);
    return xx.low + xy.low + yy.low > 0 || xx.high + xy.high + yy.high < 0;
}

bool SelfOcclusion::may_be_in(const ViewVolume& volume, const Viewpoint& viewpoint,
                              const ViewpointHorizon& horizon) const {
    constexpr int most_halvings = 6;
    const Vec3 point = viewpoint.place() - patch_->center;
    for (std::size_t k = 0; k < most_boxes && !shell(k).second.definite(); ++k) {
        const double steepest =
            steepest_chord(patch_->points, of_patch(shell(k).box), point, horizon.normal);
        if (steepest < horizon.elevation) return false;
        std::vector<SilhouettePart>& parts = ring(k);
        if (std::any_of(parts.begin(), parts.end(), [&](SilhouettePart& part) {
                return part.may_be_in(volume, volume.all_sides(), frame_, most_halvings);
            }))
            return true;
    }
    return false;
}

std::vector<SilhouettePart>& SelfOcclusion::ring(std::size_t k) const {
    Shell& outer = shell(k);
    if (outer.ring) return *outer.ring;
    outer.ring.emplace();
    const Vec2 extent = outer.box.extent();
    for (const Box2& box : beside(outer.box, shrunk(outer.box, foot_))) {
        const Box2 in_outer{(box.lower - outer.box.lower) / extent,
                            (box.upper - outer.box.lower) / extent};
        DegreeReducedScalar edge_on{restricted(outer.edge_on.net, in_outer), outer.edge_on.error};
        if (may_vanish(edge_on.net, edge_on.error))
            outer.ring->emplace_back(of_patch(box), part_of(points_, of_patch(box)),
                                     std::move(edge_on), in_outer.extent());
    }
    return *outer.ring;
}

} // namespace keiko
