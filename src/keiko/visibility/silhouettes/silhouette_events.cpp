#include "keiko/visibility/silhouettes/silhouette_events.h"

#include "keiko/visibility/nets/affine_bounds.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

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
    const Vec3 way = plane.viewpoint().way_to(x);
    const Vec3 n = s.du.cross(s.dv);
    const double off = plane.weights(x).w;
    return {Vec2(off, n.dot(way)),
            Vec2(m.dot(s.du), (s.duu.cross(s.dv) + s.du.cross(s.duv)).dot(way)),
            Vec2(m.dot(s.dv), (s.duv.cross(s.dv) + s.du.cross(s.dvv)).dot(way))};
}

bool within(const Vec2& xy, double reach) {
    return std::abs(xy.x) <= reach && std::abs(xy.y) <= reach;
}

/// Side of a fold on which the surface lies. Its section with the plane bends to that side, as
/// II(d, d) along the section has the sign of that bend's component along the normal.
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
    return jet_on(kernels_, patch, uv);
}

bool SilhouetteSolver::find(const OwnCandidate& own, const SegmentPlane& plane,
                            const ShadowWedge& wedge, std::vector<VisibilityEvent>& events) const {
    const OccluderPatch& patch = silhouettes_.patches[own.patch];
    const Section section(own.rings->frame(), patch.size, plane, wedge);
    bool certain = true;
    own.rings->each_part(
        section,
        [&](const SilhouettePart& in, const LinearizedSystem& pair) {
            return add_only_root(pair, own.patch, in.uv(), own.trimmed, plane, events);
        },
        [&](const SilhouettePart& in) {
            const Part part{own.patch, in.uv(), own.trimmed, patch.size};
            certain = search(in, section, part, plane, events) && certain;
        });
    return certain;
}

void SilhouetteSolver::find_part(const SilhouetteCandidate& candidate,
                                 const Viewpoint& viewpoint) const {
    const SilhouettePiece& piece = silhouettes_.pieces[candidate.piece];
    const Vec4 weights = piece.weights(viewpoint);
    DegreeReducedScalar edge_on{weighed(piece.lowered_planes.net, weights),
                                magnitudes(weights).dot(piece.lowered_planes.error)};
    candidate.part.emplace();
    if (!may_vanish(edge_on.net, edge_on.error)) return;
    *candidate.part = std::make_unique<SilhouettePart>(piece.overlapped(), piece.overlapped_points,
                                                       std::move(edge_on), Vec2(1));
}

bool SilhouetteSolver::find(const SilhouetteCandidate& candidate, const SegmentPlane& plane,
                            const ShadowWedge& wedge, std::vector<VisibilityEvent>& events) const {
    if (candidate.nowhere_edge_on()) return true;
    const SilhouettePiece& piece = silhouettes_.pieces[candidate.piece];
    const NetFrame& frame = piece.frame;
    const AffineBounds::Weighed f = piece.points.weighed(frame.local(plane.weights(frame.center)));
    if (f.vanishes_nowhere()) return true;
    const LinearizedSystem pair(f, candidate.edge_on);
    if (pair.root_is_outside()) return true;
    if (add_only_root(pair, piece.patch, piece.uv, piece.trimmed, plane, events)) return true;
    if (!candidate.part) find_part(candidate, plane.viewpoint());
    if (candidate.nowhere_edge_on()) return true;
    constexpr int most_halvings = 10;
    const Section section(frame, piece.box.size(), plane, wedge);
    bool certain = true;
    (*candidate.part)
        ->each_part(
            section, most_halvings,
            [&](const SilhouettePart& in, const LinearizedSystem& of_part) {
                return add_only_root(of_part, piece.patch, in.uv(), piece.trimmed, plane, events);
            },
            [&](const SilhouettePart& in) {
                const Part part{piece.patch, in.uv(), piece.trimmed, piece.box.size()};
                certain = search(in, section, part, plane, events) && certain;
            });
    return certain;
}

bool SilhouetteSolver::may_be_in(const ViewVolume& volume, const SilhouetteCandidate& candidate,
                                 const Viewpoint& viewpoint) const {
    if (candidate.nowhere_edge_on()) return false;
    const SilhouettePiece& piece = silhouettes_.pieces[candidate.piece];
    ViewVolume::Sides sides = volume.all_sides();
    if (!volume.may_hold(piece, sides)) return false;
    if (!candidate.part) find_part(candidate, viewpoint);
    if (candidate.nowhere_edge_on()) return false;
    constexpr int most_halvings = 8;
    return (*candidate.part)->may_be_in(volume, sides, piece.frame, most_halvings);
}

bool SilhouetteSolver::search(const SilhouettePart& in, const Section& section, const Part& part,
                              const SegmentPlane& plane,
                              std::vector<VisibilityEvent>& events) const {
    constexpr int few = 60, many = 200;
    ScalarNet distance = weighed(in.points(), section.plane);
    auto found = run({distance, in.edge_on().net, in.edge_on().error}, part, plane, few);
    if (!found.unclear.empty()) {
        const OccluderPatch& patch = silhouettes_.patches[part.patch];
        ScalarNet exact =
            restricted(weighed(patch.planes, plane.viewpoint().seen_from(patch.center)), part.uv);
        found = run({std::move(distance), std::move(exact)}, part, plane, many);
    }
    return add(found, part, plane, events);
}

bool SilhouetteSolver::add_only_root(const LinearizedSystem& pair, std::uint32_t index,
                                     const Box2& uv, bool trimmed, const SegmentPlane& plane,
                                     std::vector<VisibilityEvent>& events) const {
    if (!(pair.variation() < LinearizedSystem::proved)) return false;
    const OccluderPatch& patch = silhouettes_.patches[index];
    const Vec2 extent = uv.extent();
    const auto root =
        newton(patch, uv.center() + extent * 0.5 * pair.nearest_inside(), extent, plane);
    if (!root) return false;
    if (!within((*root - uv.center()) / (extent * 0.5), 1 + LinearizedSystem::overlap))
        return pair.variation() < LinearizedSystem::straight;
    add(patch, trimmed, *root, plane, events);
    return true;
}

std::optional<Vec2> SilhouetteSolver::newton(const OccluderPatch& patch, Vec2 uv,
                                             const Vec2& extent, const SegmentPlane& plane) const {
    constexpr int most_steps = 12;
    constexpr double settled = 1e-15, rounding = 1e-10, astray = 2;
    const Vec2 start = uv;
    double last = 1;
    for (int i = 0; i < most_steps; ++i) {
        const Vec2 step = jacobian(jet_at(patch, uv), patch.center, plane).newton_step();
        uv += step;
        if (!within((uv - start) / extent, astray)) return std::nullopt;
        // Steps that small and no longer shrinking are rounding.
        const double size = std::max(std::abs(step.x), std::abs(step.y));
        if (size <= settled || (size <= rounding && size > last / 2)) return uv;
        // Each step is about the square of the one before: the next would be rounding.
        constexpr double sure = 0.01;
        if (i > 0 && size * size * size <= sure * settled * last * last) return uv;
        last = size;
    }
    return std::nullopt;
}

SilhouetteSearch::Result SilhouetteSolver::run(const SilhouetteSearch& search, const Part& part,
                                               const SegmentPlane& plane, int most_boxes) const {
    const OccluderPatch& patch = silhouettes_.patches[part.patch];
    const Viewpoint& viewpoint = plane.viewpoint();
    const Vec2 extent = part.uv.extent();
    const auto to_patch = [&](const Vec2& at) { return part.uv.lower + extent * at; };
    const auto place = [&](const Vec2& at) {
        return patch.center + jet_at(patch, to_patch(at)).position;
    };
    const auto solve = [&](const Vec2& at, const Vec2& size) -> std::optional<Vec2> {
        const auto root = newton(patch, to_patch(at), size * extent, plane);
        return root ? std::optional((*root - part.uv.lower) / extent) : std::nullopt;
    };
    const double length = plane.along().length();
    const auto spread = [&](const Box2& box) {
        const double step = part.size * std::max(box.extent().x, box.extent().y);
        if (viewpoint.infinite()) return step / length;
        const double away = (place(box.center()) - viewpoint.place()).length() - step;
        return step / std::max(away, 1e-300) * (plane.at(0.5) - viewpoint.place()).length() /
               length;
    };
    return search.run(solve, spread, most_boxes);
}

bool SilhouetteSolver::add(const SilhouetteSearch::Result& found, const Part& part,
                           const SegmentPlane& plane, std::vector<VisibilityEvent>& events) const {
    const OccluderPatch& patch = silhouettes_.patches[part.patch];
    const auto to_patch = [&](const Vec2& at) { return part.uv.lower + part.uv.extent() * at; };
    for (const Vec2& root : found.roots) add(patch, part.trimmed, to_patch(root), plane, events);
    for (const Vec2& at : found.unclear) {
        const Vec3 x = patch.center + jet_at(patch, to_patch(at)).position;
        if (const auto t = plane.hidden_by(x)) events.push_back({*t, 0});
    }
    return found.certain;
}

void SilhouetteSolver::add(const OccluderPatch& patch, bool trimmed, const Vec2& uv,
                           const SegmentPlane& plane, std::vector<VisibilityEvent>& events) const {
    const SurfaceJet s = jet_at(patch, uv);
    const auto t = plane.hidden_by(patch.center + s.position);
    if (!t) return;
    if (trimmed && !silhouettes_.regions[patch.face].contains(patch.face_parameters(uv))) return;
    events.push_back({*t, dark_side(s, plane)});
}

} // namespace keiko
