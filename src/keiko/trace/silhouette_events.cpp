#include "keiko/trace/silhouette_events.h"

#include "keiko/trace/newton.h"
#include "keiko/trace/subpatch.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Of a piece: neighbours overlap by this much, so that no event falls between them.
constexpr double overlap = 1e-7;
/// Above this the Jacobian may vary too much for a proof that rounding leaves intact.
constexpr double proved = 0.95;
/// Below this Newton's method converges from anywhere on the piece to a root on it.
constexpr double straight = 0.25;

/// (f, g) with its derivatives by the patch's parameters.
struct Jacobian {
    Vec2 value, du, dv;

    double determinant() const { return du.x * dv.y - du.y * dv.x; }
    Vec2 newton_step() const {
        const double d = determinant();
        return {(value.y * dv.x - value.x * dv.y) / d, (value.x * du.y - value.y * du.x) / d};
    }
};

Jacobian jacobian(const SurfaceJet& s, const Vec3& center, const SegmentPlane& plane) {
    const Vec3& m = plane.normal();
    const Vec3 x = center + s.position;
    const Vec3 way = plane.apex().way_to(x);
    const Vec3 n = s.du.cross(s.dv);
    const double off = plane.weights(x).w;
    return {Vec2(off, n.dot(way)),
            Vec2(m.dot(s.du), (s.duu.cross(s.dv) + s.du.cross(s.duv)).dot(way)),
            Vec2(m.dot(s.dv), (s.duv.cross(s.dv) + s.du.cross(s.dvv)).dot(way))};
}

bool within(const Vec2& xy, double reach) {
    return std::abs(xy.x) <= reach && std::abs(xy.y) <= reach;
}

/// On which side of a fold the surface lies: by the side to which its section with the plane
/// bends, as II(d, d) along the section has the sign of that bend's component along the normal.
int dark_side(const SurfaceJet& s, const SegmentPlane& plane) {
    const Vec3 n = s.du.cross(s.dv);
    const double a = -plane.normal().dot(s.dv), b = plane.normal().dot(s.du);
    const Vec3 second = s.duu * (a * a) + s.duv * (2 * a * b) + s.dvv * (b * b);
    const Vec3 tangent = s.du * a + s.dv * b;
    const double bend = n.dot(second), lean = n.dot(plane.along());
    constexpr double sure = 1e-7;
    const double size = n.length();
    if (!(std::abs(bend) > sure * size * second.length() && tangent.length2() > 0)) return 0;
    if (!(std::abs(lean) > sure * size * plane.along().length())) return 0;
    return (bend > 0) == (lean > 0) ? 1 : -1;
}

struct Interval {
    double low, high;

    static Interval about(double middle, double half) { return {middle - half, middle + half}; }
    bool holds_zero() const { return low <= 0 && high >= 0; }
};

Interval operator+(const Interval& a, const Interval& b) {
    return {a.low + b.low, a.high + b.high};
}

Interval operator*(const Interval& a, const Interval& b) {
    const double p[4] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
    return {*std::min_element(p, p + 4), *std::max_element(p, p + 4)};
}

Interval square(const Interval& a) {
    const double low = a.low * a.low, high = a.high * a.high;
    return {a.holds_zero() ? 0 : std::min(low, high), std::max(low, high)};
}

Interval weighed(const Vec4& weights, const Vec4& middle, const Vec4& range) {
    const Vec4 sizes(std::abs(weights.x), std::abs(weights.y), std::abs(weights.z),
                     std::abs(weights.w));
    return Interval::about(weights.dot(middle), sizes.dot(range));
}

/// Coefficients of sum weights[k] * component k.
std::vector<double> weighed(const HomogeneousNet& net, const Vec4& weights) {
    std::vector<double> c;
    c.reserve(net.points.size());
    for (const Vec4& p : net.points) c.push_back(p.dot(weights));
    return c;
}

/// Raises one degree of a net of scalars, u outer, by one.
std::vector<double> raised(const std::vector<double>& c, std::size_t rows, std::size_t columns,
                           bool in_u) {
    const std::size_t new_rows = rows + in_u, new_columns = columns + !in_u;
    const auto degree = static_cast<double>(in_u ? rows : columns);
    std::vector<double> raised(new_rows * new_columns);
    for (std::size_t i = 0; i < new_rows; ++i)
        for (std::size_t j = 0; j < new_columns; ++j) {
            const std::size_t k = in_u ? i : j, last = in_u ? rows : columns;
            const double share = static_cast<double>(k) / degree;
            double value = 0;
            if (k > 0) value += share * c[in_u ? (i - 1) * columns + j : i * columns + j - 1];
            if (k < last) value += (1 - share) * c[i * columns + j];
            raised[i * new_columns + j] = value;
        }
    return raised;
}

/// A scalar net in higher degrees.
std::vector<double> elevated(std::vector<double> c, const HomogeneousNet& from, int to_u,
                             int to_v) {
    auto rows = static_cast<std::size_t>(from.degree_u) + 1;
    auto columns = static_cast<std::size_t>(from.degree_v) + 1;
    for (; static_cast<int>(rows) <= to_u; ++rows) c = raised(c, rows, columns, true);
    for (; static_cast<int>(columns) <= to_v; ++columns) c = raised(c, rows, columns, false);
    return c;
}

/// Both functions over a whole occluder patch, each scaled to 1.
PlanarNet net_of(const OccluderPatch& patch, const SegmentPlane& plane) {
    PlanarNet net;
    net.degree_u = std::max(patch.points.degree_u, patch.planes.degree_u);
    net.degree_v = std::max(patch.points.degree_v, patch.planes.degree_v);
    const auto fill = [&](const HomogeneousNet& from, const Vec4& weights, auto& into) {
        const std::vector<double> c =
            elevated(weighed(from, weights), from, net.degree_u, net.degree_v);
        double most = 0;
        for (const double x : c) most = std::max(most, std::abs(x));
        const double scale = most > 0 ? 1 / most : 0;
        for (std::size_t i = 0; i < c.size(); ++i) into[i] = c[i] * scale;
    };
    fill(patch.points, plane.weights(patch.center), net.f);
    fill(patch.planes, plane.apex().seen_from(patch.center), net.g);
    return net;
}

bool may_vanish(const std::array<double, PlanarNet::capacity>& c, std::size_t count, double slack) {
    bool below = false, above = false;
    for (std::size_t i = 0; i < count; ++i) {
        below = below || c[i] <= slack;
        above = above || c[i] >= -slack;
    }
    return below && above;
}

} // namespace

SurfaceJet SilhouetteSolver::jet_at(const OccluderPatch& patch, const Vec2& uv) const {
    return projected(kernels_.evaluate(patch.points.view(), uv), patch.rational);
}

std::optional<SilhouetteCandidate> SilhouetteSolver::candidate(std::uint32_t index,
                                                               const Apex& apex) const {
    const SilhouettePiece& piece = silhouettes_.pieces[index];
    SilhouetteCandidate c;
    c.piece = index;
    c.edge_on = piece.planes.weighed(piece.weights(apex));
    if (c.edge_on.vanishes_nowhere()) return std::nullopt;
    const OccluderPatch& patch = silhouettes_.patches[piece.patch];
    if (const auto& root = apex.excluded();
        root && root->instance == patch.instance && root->patch == patch.patch) {
        const Vec2 own = (root->uv.center() - patch.uv.lower) / patch.uv.extent();
        c.foot = (own - piece.uv.center()) / (piece.uv.extent() * 0.5);
        c.own = std::max(std::abs(c.foot.x), std::abs(c.foot.y)) <= 1 + overlap;
    }
    return c;
}

bool SilhouetteSolver::find(const SilhouetteCandidate& candidate, const SegmentPlane& plane,
                            std::vector<VisibilityEvent>& events) const {
    const SilhouettePiece& piece = silhouettes_.pieces[candidate.piece];
    const AffineNet::Weighed f = piece.points.weighed(piece.local(plane.weights(piece.center)));
    const AffineNet::Weighed& g = candidate.edge_on;
    if (f.vanishes_nowhere()) return true;
    if (candidate.own)
        return bends_one_way(candidate, f, plane) || subdivide(candidate, plane, events);
    const double d = f.along_x * g.along_y - f.along_y * g.along_x;
    const double size = std::abs(d);
    const Vec2 xy((f.along_y * g.value - g.along_y * f.value) / d,
                  (g.along_x * f.value - f.along_x * g.value) / d);
    const Vec2 off((std::abs(g.along_y) * f.off + std::abs(f.along_y) * g.off) / size,
                   (std::abs(g.along_x) * f.off + std::abs(f.along_x) * g.off) / size);
    if (std::abs(xy.x) - off.x > 1 + overlap || std::abs(xy.y) - off.y > 1 + overlap) return true;
    const double varies = std::max(std::abs(g.along_y) * f.slope + std::abs(f.along_y) * g.slope,
                                   std::abs(g.along_x) * f.slope + std::abs(f.along_x) * g.slope) /
                          size;
    if (varies < proved) {
        const Vec2 start(std::clamp(xy.x, -1.0, 1.0), std::clamp(xy.y, -1.0, 1.0));
        const auto root = newton(piece, start, plane);
        if (root && within(*root, 1 + overlap)) {
            add(piece, piece.uv.center() + piece.uv.extent() * 0.5 * *root, plane, events);
            return true;
        }
        // From so near a root inside, Newton's method would not have gone out.
        if (root && varies < straight) return true;
    }
    return subdivide(candidate, plane, events);
}

std::optional<Vec2> SilhouetteSolver::newton(const SilhouettePiece& piece, Vec2 xy,
                                             const SegmentPlane& plane) const {
    const OccluderPatch& patch = silhouettes_.patches[piece.patch];
    const Vec2 middle = piece.uv.center(), half = piece.uv.extent() * 0.5;
    constexpr int most_steps = 12;
    constexpr double settled = 1e-13, astray = 3;
    for (int i = 0; i < most_steps; ++i) {
        const Vec2 uv = middle + half * xy;
        const Jacobian j = jacobian(jet_at(patch, uv), patch.center, plane);
        const Vec2 step = j.newton_step() / half;
        xy += step;
        const double size = std::max(std::abs(step.x), std::abs(step.y));
        if (!within(xy, astray)) return std::nullopt;
        if (size <= settled) return xy;
    }
    return std::nullopt;
}

/// An apex on the surface is itself a root, where g and both its derivatives vanish. By Taylor's
/// theorem there is no other where g's second derivative keeps its sign along every chord that
/// the plane's section may have.
bool SilhouetteSolver::bends_one_way(const SilhouetteCandidate& candidate,
                                     const AffineNet::Weighed& f, const SegmentPlane& plane) const {
    const SilhouettePiece& piece = silhouettes_.pieces[candidate.piece];
    const Interval x = Interval::about(-f.along_y, f.slope),
                   y = Interval::about(f.along_x, f.slope);
    if (x.holds_zero() && y.holds_zero()) return false;
    const Vec4 weights = piece.weights(plane.apex());
    const AffineNet& t = piece.planes;
    const Interval xy = weighed(weights, t.xy, t.xy_range);
    const Interval bend = weighed(weights, t.xx, t.xx_range) * square(x) +
                          Interval{2 * xy.low, 2 * xy.high} * (x * y) +
                          weighed(weights, t.yy, t.yy_range) * square(y);
    return !bend.holds_zero();
}

bool SilhouetteSolver::subdivide(const SilhouetteCandidate& candidate, const SegmentPlane& plane,
                                 std::vector<VisibilityEvent>& events) const {
    const SilhouettePiece& piece = silhouettes_.pieces[candidate.piece];
    const OccluderPatch& patch = silhouettes_.patches[piece.patch];
    const PlanarNet whole = net_of(patch, plane);
    const double slack = 4e-16 * (whole.degree_u + whole.degree_v + 4);
    const double scale = piece.box.size();
    constexpr int most_boxes = 600;
    constexpr double sharpest = 1e-11;   ///< of the segment: closer events are one
    constexpr double around_apex = 1e-7; ///< of the piece: what is so near is the apex itself
    std::vector<Box2> open{{piece.uv.lower - piece.uv.extent() * overlap,
                            piece.uv.upper + piece.uv.extent() * overlap}};
    bool certain = true;
    for (int count = 0; !open.empty(); ++count) {
        const Box2 box = open.back();
        open.pop_back();
        const PlanarNet net = restricted(whole, box);
        if (!may_vanish(net.f, net.size(), slack) || !may_vanish(net.g, net.size(), slack))
            continue;
        const std::vector<Vec4> points = subpatch(patch.points.view(), box);
        Box3 hull = hull_bounds({patch.points.degree_u, patch.points.degree_v, points});
        hull = {hull.lower + patch.center, hull.upper + patch.center};
        const double size = hull.size();
        const Vec3 middle = hull.center();
        const double distance =
            plane.apex().infinite() ? Box3::infinity : (middle - plane.apex().place()).length();
        if (distance + size <= around_apex * scale) continue;
        const bool apart = distance > size;
        if (apart) {
            const Preconditioned p = preconditioned(net, slack);
            if (at_most_one_root(p))
                if (const auto root = keiko::newton(p, Vec2(0.5))) {
                    add(piece, box.lower + box.extent() * root->uv, plane, events);
                    continue;
                }
        }
        // How far the segment is moved along when a place in the box moves across.
        const Vec3 end = plane.at(0.5);
        const double reach = plane.apex().infinite() ? 1
                                                     : (end - plane.apex().place()).length() /
                                                           std::max(distance, 1e-300);
        const bool sharp = size * reach <= sharpest * plane.along().length();
        if (sharp || count >= most_boxes) {
            if (const auto t = plane.hidden_by(middle)) events.push_back({*t, 0});
            certain = certain && sharp;
            continue;
        }
        Box2 low = box, high = box;
        const unsigned axis =
            box.extent().x * piece.uv.extent().y >= box.extent().y * piece.uv.extent().x ? 0 : 1;
        low.upper[axis] = high.lower[axis] = box.center()[axis];
        open.push_back(high);
        open.push_back(low);
    }
    return certain;
}

void SilhouetteSolver::add(const SilhouettePiece& piece, const Vec2& uv, const SegmentPlane& plane,
                           std::vector<VisibilityEvent>& events) const {
    const OccluderPatch& patch = silhouettes_.patches[piece.patch];
    const SurfaceJet s = jet_at(patch, uv);
    const auto t = plane.hidden_by(patch.center + s.position);
    if (!t) return;
    if (piece.trimmed && !silhouettes_.regions[patch.face].contains(patch.face_parameters(uv)))
        return;
    events.push_back({*t, dark_side(s, plane)});
}

} // namespace keiko
