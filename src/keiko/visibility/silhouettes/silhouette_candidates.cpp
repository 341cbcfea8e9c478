#include "keiko/visibility/silhouettes/silhouette_candidates.h"

#include "keiko/geometry/bezier/bezier.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/geometry/bezier/subpatch.h"
#include "keiko/math/axes.h"

#include <algorithm>
#include <cmath>

namespace keiko {

namespace {

bool within(const Vec2& xy, double reach) {
    return std::abs(xy.x) <= reach && std::abs(xy.y) <= reach;
}

} // namespace

void CandidateMaker::add(std::uint32_t index, const Viewpoint& viewpoint,
                         const std::optional<ViewpointHorizon>& horizon,
                         SilhouetteCandidates& all) const {
    const SilhouettePiece& piece = silhouettes_.pieces[index];
    const AffineBounds::Weighed edge_on = piece.planes.weighed(piece.weights(viewpoint));
    if (edge_on.vanishes_nowhere()) return;
    const auto known = std::find_if(all.own.begin(), all.own.end(),
                                    [&](const OwnCandidate& o) { return o.patch == piece.patch; });
    const auto found = known != all.own.end() ? std::optional(known->foot) : foot(piece, viewpoint);
    if (!found || !piece.surroundings().contains(*found))
        return all.pieces.push_back({index, edge_on});
    const auto steepest = [&] {
        return steepest_chord(piece.chords,
                              piece.frame.local(viewpoint.place() - piece.frame.center),
                              piece.frame.local(horizon->normal));
    };
    if (horizon && horizon->elevation > 0 && steepest() < horizon->elevation) return;
    auto own = known;
    if (own == all.own.end()) {
        all.own.push_back({piece.patch, {*found, *found}, *found});
        own = all.own.end() - 1;
    }
    own->uv.extend(piece.uv);
}

std::optional<Vec2> CandidateMaker::foot(const SilhouettePiece& piece,
                                         const Viewpoint& viewpoint) const {
    const auto& root = viewpoint.excluded();
    if (!root) return std::nullopt;
    const OccluderPatch& patch = silhouettes_.patches[piece.patch];
    if (root->instance == patch.instance && root->patch == patch.patch)
        return (root->uv.center() - patch.uv.lower) / patch.uv.extent();
    if (!piece.box.padded(piece.box.size()).contains(viewpoint.place())) return std::nullopt;
    constexpr int most_steps = 8;
    constexpr double on_surface = 1e-11, beside = 2;
    const double size = piece.box.size() + patch.center.length();
    Vec2 uv = piece.uv.center();
    for (int i = 0; i < most_steps; ++i) {
        const SurfaceJet s = jet_on(kernels_, patch, uv);
        const Vec3 off = viewpoint.place() - patch.center - s.position;
        if (off.length() <= on_surface * size) return uv;
        const double a = s.du.dot(s.du), b = s.du.dot(s.dv), c = s.dv.dot(s.dv);
        const double u = s.du.dot(off), v = s.dv.dot(off), d = a * c - b * b;
        uv += Vec2(c * u - b * v, a * v - b * u) / d;
        if (!within((uv - piece.uv.center()) / (piece.uv.extent() * 0.5), beside))
            return std::nullopt;
    }
    return std::nullopt;
}

double SilhouetteCandidates::own_steepest() const {
    double steepest = 0;
    for (const OwnCandidate& o : own) steepest = std::max(steepest, o.steepest);
    return steepest;
}

void CandidateMaker::finish(const Viewpoint& viewpoint,
                            const std::optional<ViewpointHorizon>& horizon,
                            SilhouetteCandidates& all) const {
    std::erase_if(all.own, [&](OwnCandidate& own) {
        const OccluderPatch& patch = silhouettes_.patches[own.patch];
        own.trimmed = !silhouettes_.regions[patch.face].untrimmed();
        if (horizon) {
            own.steepest = steepest_chord(patch.points, own.uv, viewpoint.place() - patch.center,
                                          horizon->normal);
            if (own.steepest < horizon->elevation) return true;
        }
        own.rings.emplace(
            patch, own.uv, own.foot,
            restricted(weighed(patch.planes, viewpoint.seen_from(patch.center)), own.uv));
        return own.rings->find_nothing();
    });
}

namespace {

struct ValueRange {
    double low, high;
};

ValueRange operator*(const NetRange& a, const ValueRange& b) {
    const double p[4] = {a.low() * b.low, a.low() * b.high, a.high() * b.low, a.high() * b.high};
    return {*std::min_element(p, p + 4), *std::max_element(p, p + 4)};
}

ValueRange product(const NetRange& a, const NetRange& b) {
    return a * ValueRange{b.low(), b.high()};
}

ValueRange square(const NetRange& a) {
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
    const ValueRange xx = in.second.xx * square(fy), yy = in.second.yy * square(fx);
    const ValueRange xy =
        NetRange{-2 * in.second.xy.middle, 2 * in.second.xy.half} * product(fx, fy);
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

bool NetCurvature::definite() const {
    if (xx.holds_zero() || yy.holds_zero() || (xx.middle > 0) != (yy.middle > 0)) return false;
    const double least = (std::abs(xx.middle) - xx.half) * (std::abs(yy.middle) - yy.half);
    return least > xy.largest() * xy.largest();
}

NetCurvature net_curvature(const ScalarNet& net) {
    NetCurvature second;
    if (net.rows > 1) {
        const ScalarNet by_x = derivative(net, true);
        second.xx = derivative_range(by_x, true);
        second.xy = derivative_range(by_x, false);
    }
    if (net.columns > 1) second.yy = derivative_range(derivative(net, false), false);
    return second;
}

NetCurvature net_curvature(const DegreeReducedScalar& lowered, const ScalarNet& exact) {
    NetCurvature second = net_curvature(lowered.net);
    const auto square = [](std::size_t count) {
        return static_cast<double>((count - 1) * (count - 1));
    };
    const double m = square(exact.rows), n = square(exact.columns);
    const double xx = m * (m - 1) / 3 * lowered.error, xy = m * n * lowered.error,
                 yy = n * (n - 1) / 3 * lowered.error;
    constexpr double little = 0.05;
    const double size = std::max({second.xx.largest(), second.xy.largest(), second.yy.largest()});
    if (!(std::max({xx, xy, yy}) <= little * size)) return net_curvature(exact);
    second.xx.half += xx;
    second.xy.half += xy;
    second.yy.half += yy;
    return second;
}

} // namespace keiko
