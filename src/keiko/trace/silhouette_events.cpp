#include "keiko/trace/silhouette_events.h"

#include "keiko/trace/silhouette_search.h"

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
        c.foot = (root->uv.center() - patch.uv.lower) / patch.uv.extent();
        // Nearer than this the zero at the apex makes itself felt.
        const Vec2 off = (c.foot - piece.uv.center()) / (piece.uv.extent() * 0.5);
        constexpr double near = 2;
        c.own = within(off, near);
    }
    return c;
}

bool SilhouetteSolver::find(const SilhouetteCandidate& candidate, const SegmentPlane& plane,
                            std::vector<VisibilityEvent>& events) const {
    const SilhouettePiece& piece = silhouettes_.pieces[candidate.piece];
    const AffineNet::Weighed f = piece.points.weighed(piece.local(plane.weights(piece.center)));
    const AffineNet::Weighed& g = candidate.edge_on;
    if (f.vanishes_nowhere()) return true;
    if (candidate.own) return subdivide(candidate, plane, events);
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

bool SilhouetteSolver::subdivide(const SilhouetteCandidate& candidate, const SegmentPlane& plane,
                                 std::vector<VisibilityEvent>& events) const {
    const SilhouettePiece& piece = silhouettes_.pieces[candidate.piece];
    const OccluderPatch& patch = silhouettes_.patches[piece.patch];
    const Apex& apex = plane.apex();
    // An apex beside the piece on the same patch is left out in the same way.
    Box2 searched = piece.uv;
    if (candidate.own) searched.extend(candidate.foot);
    const Vec2 extent = searched.extent();
    SilhouetteSearch search(
        restricted(weighed(patch.points, plane.weights(patch.center)), searched),
        restricted(weighed(patch.planes, apex.seen_from(patch.center)), searched));
    if (candidate.own) search.leave_out((candidate.foot - searched.lower) / extent);

    const Vec2 middle = piece.uv.center(), half = piece.uv.extent() * 0.5;
    const auto to_piece = [&](const Vec2& at) {
        return (searched.lower + extent * at - middle) / half;
    };
    const auto solve = [&](const Vec2& at) -> std::optional<Vec2> {
        const auto root = newton(piece, to_piece(at), plane);
        return root ? std::optional((middle + half * *root - searched.lower) / extent)
                    : std::nullopt;
    };
    const double size = piece.box.size(), length = plane.along().length();
    const auto spread = [&](const Box2& box) {
        const Vec2 at = box.center();
        const double step = size * std::max(box.extent().x, box.extent().y);
        if (apex.infinite()) return step / length;
        const Vec3 x = patch.center + jet_at(patch, searched.lower + extent * at).position;
        const double away = std::max((x - apex.place()).length() - step, 1e-300);
        return step / away * (plane.at(0.5) - apex.place()).length() / length;
    };
    const SilhouetteSearch::Result found = search.run(solve, spread);
    for (const Vec2& root : found.roots) add(piece, searched.lower + extent * root, plane, events);
    for (const Vec2& at : found.unclear) {
        const Vec3 x = patch.center + jet_at(patch, searched.lower + extent * at).position;
        if (const auto t = plane.hidden_by(x)) events.push_back({*t, 0});
    }
    return found.certain;
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
