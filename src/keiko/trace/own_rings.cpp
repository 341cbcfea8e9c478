#include "keiko/trace/own_rings.h"

#include "keiko/patch/bezier_patch.h"
#include "keiko/trace/subpatch.h"

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
LoweredScalar cheaper(const ScalarNet& edge_on) {
    constexpr double enough = 1e-4;
    for (const std::size_t degree : {5u, 8u}) {
        LoweredScalar low = lowered(edge_on, degree);
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

} // namespace

OwnRings::OwnRings(const OccluderPatch& patch, const Box2& uv, const Vec2& foot,
                   const std::optional<Vec3>& normal, ScalarNet edge_on)
    : patch_(&patch),
      uv_(uv),
      foot_((foot - uv.lower) / uv.extent()),
      apex_(evaluate(patch.points.view(), foot, 0).position()),
      normal_(normal),
      edge_on_(std::move(edge_on)) {}

OwnRings::Shell& OwnRings::shell(std::size_t k) const {
    while (shells_.size() <= k) {
        const Box2 box = shells_.empty() ? unit_square : shrunk(shells_.back().box, foot_);
        const ScalarNet g = shells_.empty() ? edge_on_ : restricted(edge_on_, box);
        const ScalarNet gx = derivative(g, true), gy = derivative(g, false);
        shells_.push_back({box, part_of(patch_->points, of_patch(box)), cheaper(g),
                           derivative_range(gx, true), derivative_range(gx, false),
                           derivative_range(gy, false)});
    }
    return shells_[k];
}

/// By Taylor's theorem the function has no other zero on a section f = 0 through the apex where its
/// second derivative keeps its sign along every chord that the section may have.
bool OwnRings::only_apex_in(std::size_t k, const Vec4& weights) const {
    const Shell& in = shell(k);
    const ScalarNet f = weighed(in.points, weights);
    const NetRange fx = derivative_range(f, true), fy = derivative_range(f, false);
    if (fx.holds_zero() && fy.holds_zero()) return false;
    const Interval xx = in.xx * square(fy), yy = in.yy * square(fx);
    const Interval xy = NetRange{-2 * in.xy.middle, 2 * in.xy.half} * product(fx, fy);
    return xx.low + xy.low + yy.low > 0 || xx.high + xy.high + yy.high < 0;
}

std::vector<OwnRings::Part>& OwnRings::ring(std::size_t k) const {
    Shell& outer = shell(k);
    if (outer.ring) return *outer.ring;
    outer.ring.emplace();
    const Vec2 extent = outer.box.extent();
    for (const Box2& box : beside(outer.box, shrunk(outer.box, foot_))) {
        const Box2 in_outer{(box.lower - outer.box.lower) / extent,
                            (box.upper - outer.box.lower) / extent};
        add_part(of_patch(box), {restricted(outer.edge_on.net, in_outer), outer.edge_on.error},
                 in_outer.extent(), 0, *outer.ring);
    }
    return *outer.ring;
}

std::vector<OwnRings::Part>& OwnRings::halves(Part& part) const {
    if (part.halves) return *part.halves;
    part.halves.emplace();
    const unsigned axis = part.slopes.axis_to_halve(part.uv.extent() / uv_.extent());
    for (const double from : {0.0, 0.5}) {
        Box2 half = unit_square;
        half.lower[axis] = from, half.upper[axis] = from + 0.5;
        const Vec2 extent = part.uv.extent();
        const Box2 uv{part.uv.lower + extent * half.lower, part.uv.lower + extent * half.upper};
        add_part(uv, {restricted(part.edge_on, half), part.error}, part.shares * half.extent(),
                 part.halvings + 1, *part.halves);
    }
    return *part.halves;
}

void OwnRings::add_part(const Box2& uv, LoweredScalar edge_on, const Vec2& shares,
                        int halvings, std::vector<Part>& parts) const {
    if (!may_vanish(edge_on.net, edge_on.error)) return;
    Slopes slopes = slopes_of(edge_on.net);
    slopes.add_error(edge_on.error, shares);
    HomogeneousNet points = part_of(patch_->points, uv);
    const double most = steepest(points);
    std::vector<Vec3> seen = seen_by_apex(points);
    double reach = 0;
    for (const Vec3& x : seen) reach = std::max(reach, x.length());
    parts.push_back({uv, std::move(points), std::move(seen), reach, std::move(edge_on.net),
                     edge_on.error, shares, slopes, most, halvings});
}

std::vector<Vec3> OwnRings::seen_by_apex(const HomogeneousNet& points) const {
    std::vector<Vec3> seen;
    seen.reserve(points.points.size());
    for (const Vec4& p : points.points) seen.push_back(Vec3(p.x, p.y, p.z) - apex_ * p.w);
    return seen;
}

/// By the largest rise over the tangent plane and the least distance from the apex.
double OwnRings::steepest(const HomogeneousNet& points) const {
    if (!normal_) return 1;
    Box3 seen;
    double rise = 0;
    for (const Vec4& p : points.points) {
        const Vec3 x = Vec3(p.x, p.y, p.z) / p.w - apex_;
        seen.extend(x);
        rise = std::max(rise, std::abs(normal_->dot(x)));
    }
    const double least = seen.center().length() - seen.size() / 2;
    constexpr double rounding = 1e-9;
    return least > rise ? rise / least + rounding : 1;
}

} // namespace keiko
