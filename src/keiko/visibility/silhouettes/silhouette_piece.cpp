#include "keiko/visibility/silhouettes/silhouette_piece.h"

#include "keiko/base/job.h"
#include "keiko/base/parallel.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/geometry/bezier/subpatch.h"
#include "keiko/math/axes.h"
#include "keiko/visibility/nets/degree_reduced_net.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// Halvings of an occluder patch along each parameter.
constexpr int most_halvings = 5;
/// rad: normals that turn by more over half a piece make viewpoints look at it in vain.
constexpr double widest_turn = 0.2;
/// Share of a net's slopes by which they may vary over a piece, for Newton's method to be proved.
constexpr double most_bent = 0.4;
/// rad: what turns by no more, however unevenly, is seldom seen edge-on.
constexpr double straight = 2e-3;

/// Points relative to another place.
HomogeneousNet moved_points(HomogeneousNet net, const Vec3& to) {
    for (Vec4& p : net.points) {
        const Vec3 q = spatial(p) - to * p.w;
        p = {q.x, q.y, q.z, p.w};
    }
    return net;
}

HomogeneousNet moved_planes(HomogeneousNet net, const Vec3& to) {
    for (Vec4& p : net.points) p.w += spatial(p).dot(to);
    return net;
}

HomogeneousNet part_of(const HomogeneousNet& net, const Box2& box) {
    return {net.degree_u, net.degree_v, subpatch(net.view(), box)};
}

/// Axes about the mean normal, the first along the surface.
std::array<Vec3, 3> axes_of(const HomogeneousNet& planes, const HomogeneousNet& points) {
    Vec3 sum(0);
    for (const Vec4& p : planes.points) sum += spatial(p);
    const Vec3 normal = sum.length() > 0 ? sum.normalized() : Vec3(0, 0, 1);
    Vec3 along = spatial(points.points.back()) - spatial(points.points.front());
    along -= normal * normal.dot(along);
    if (!(along.length2() > 0)) along = any_perpendicular(normal);
    along.normalize();
    return {along, normal.cross(along), normal};
}

double normal_angle(const HomogeneousNet& planes, const Vec3& axis) {
    double angle = 0;
    for (const Vec4& p : planes.points) angle = std::max(angle, angle_between(axis, spatial(p)));
    return angle;
}

SilhouettePiece piece_over(const OccluderPatch& patch, const Box2& uv) {
    SilhouettePiece piece;
    piece.uv = uv;
    HomogeneousNet points = part_of(patch.points, uv);
    const Box3 local = hull_bounds(points.view());
    const Vec3 middle = local.center();
    piece.frame.center = patch.center + middle;
    piece.box = {patch.center + local.lower, patch.center + local.upper};
    HomogeneousNet planes = moved_planes(part_of(patch.planes, uv), middle);
    piece.frame.rows = axes_of(planes, points);
    piece.normal_angle = normal_angle(planes, piece.frame.rows[2]);
    piece.points = affine_net(turned(moved_points(std::move(points), middle), piece.frame));
    piece.planes = affine_net(turned(std::move(planes), piece.frame));
    return piece;
}

/// Magnitude of the components in the tangent plane.
double lateral(const Vec4& p) {
    return std::hypot(p.x, p.y);
}

/// Along which axis the piece should be halved, if at all.
std::optional<unsigned> axis_to_halve(const SilhouettePiece& piece) {
    const auto steeper = [](const Vec4& xx, const Vec4& xx_range, const Vec4& yy,
                            const Vec4& yy_range) {
        return lateral(xx) + lateral(xx_range) >= lateral(yy) + lateral(yy_range) ? 0u : 1u;
    };
    const AffineNet& t = piece.planes;
    const double area = std::abs(t.value.z);
    const double turn_x = lateral(t.along_x), turn_y = lateral(t.along_y);
    const double turn = std::max(turn_x, turn_y), slope = lateral(t.slope);
    if (!(turn < widest_turn * area)) return turn_x >= turn_y ? 0u : 1u;
    if (slope > most_bent * turn && slope > straight * area)
        return steeper(t.xx, t.xx_range, t.yy, t.yy_range);
    const AffineNet& h = piece.points;
    const double step = std::max(lateral(h.along_x), lateral(h.along_y));
    if (lateral(h.slope) > most_bent * step) return steeper(h.xx, h.xx_range, h.yy, h.yy_range);
    return std::nullopt;
}

HomogeneousNet points_in_frame(const OccluderPatch& patch, const SilhouettePiece& piece,
                               const Box2& uv) {
    const Vec3 middle = piece.frame.center - patch.center;
    return turned(moved_points(part_of(patch.points, uv), middle), piece.frame);
}

/// Planes of few coefficients, for a search that splits the piece.
DegreeReducedNet lowered_planes(const OccluderPatch& patch, const SilhouettePiece& piece) {
    constexpr int enough = 5;
    const HomogeneousNet planes =
        moved_planes(part_of(patch.planes, piece.overlapped()), piece.frame.center - patch.center);
    return lowered(turned(planes, piece.frame), enough);
}

Box2 face_box(const OccluderPatch& patch, const Box2& uv) {
    Box2 box;
    box.extend(patch.face_parameters(uv.lower));
    box.extend(patch.face_parameters(uv.upper));
    return box;
}

void split(const OccluderPatch& patch, const TrimRegion& region, const Box2& uv,
           std::array<int, 2> halved, std::vector<SilhouettePiece>& pieces) {
    check_stop();
    const TrimSide side =
        region.untrimmed() ? TrimSide::inside : region.classify(face_box(patch, uv));
    if (side == TrimSide::outside) return;
    SilhouettePiece piece = piece_over(patch, uv);
    const auto axis = axis_to_halve(piece);
    if (!axis || halved[*axis] >= most_halvings) {
        piece.lowered_planes = lowered_planes(patch, piece);
        piece.overlapped_points = points_in_frame(patch, piece, piece.overlapped());
        piece.chords = tangent_bounds(points_in_frame(patch, piece, piece.surroundings()));
        piece.trimmed = side == TrimSide::mixed;
        pieces.push_back(std::move(piece));
        return;
    }
    Box2 low = uv, high = uv;
    low.upper[*axis] = high.lower[*axis] = uv.center()[*axis];
    ++halved[*axis];
    split(patch, region, low, halved, pieces);
    split(patch, region, high, halved, pieces);
}

/// One patch of a placed part with its pieces.
Silhouettes silhouettes_of_patch(const SurfaceModel& model, std::uint32_t instance,
                                 std::uint32_t index, const TrimRegion& region) {
    Silhouettes set;
    const Affine& to_world = model.instances[instance].transform;
    const BezierPatchView view = model.patch(index);
    HomogeneousNet placed{view.degree_u, view.degree_v, {}};
    for (const Vec4& p : view.points) placed.points.push_back(to_world.homogeneous(p));
    const Vec3 center = hull_bounds(placed.view()).center();
    for (ReducedPatch& part : degree_reduction(moved_points(std::move(placed), center))) {
        OccluderPatch patch;
        patch.instance = instance;
        patch.face = model.patches[index].face;
        patch.patch = index;
        patch.uv = part.uv;
        patch.center = center;
        patch.points = std::move(part.points);
        patch.size = hull_bounds(patch.points.view()).size();
        patch.map_u = model.patches[index].map_u;
        patch.map_v = model.patches[index].map_v;
        patch.planes = tangent_planes(patch.points.view());
        patch.rational = patch.points.view().rational();
        patch.flat = is_flat(patch.planes);
        const auto number = static_cast<std::uint32_t>(set.patches.size());
        const std::size_t first = set.pieces.size();
        if (!patch.flat) split(patch, region, unit_square, {0, 0}, set.pieces);
        for (std::size_t i = first; i < set.pieces.size(); ++i) set.pieces[i].patch = number;
        set.patches.push_back(std::move(patch));
    }
    return set;
}

void append(Silhouettes& all, Silhouettes more) {
    const auto offset = static_cast<std::uint32_t>(all.patches.size());
    for (SilhouettePiece& piece : more.pieces) {
        piece.patch += offset;
        all.pieces.push_back(std::move(piece));
    }
    std::move(more.patches.begin(), more.patches.end(), std::back_inserter(all.patches));
}

} // namespace

std::optional<Vec3> Silhouettes::normal_at(const Root& root) const {
    const Vec2 at = root.uv.center();
    const auto before = [](const OccluderPatch& a, const Root& b) {
        return a.instance != b.instance ? a.instance < b.instance : a.patch < b.patch;
    };
    for (auto p = std::lower_bound(patches.begin(), patches.end(), root, before);
         p != patches.end() && p->instance == root.instance && p->patch == root.patch; ++p) {
        const Vec2 own = (at - p->uv.lower) / p->uv.extent();
        if (patches.end() - p > 1 && !unit_square.padded(1e-9).contains(own)) continue;
        return unit_normal(evaluate(p->points.view(), own, 2), own);
    }
    return std::nullopt;
}

Silhouettes silhouettes_of(const SurfaceModel& model, const Job& job) {
    Silhouettes all;
    for (const Face& face : model.faces) all.regions.emplace_back(model, face);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> placed;
    for (std::uint32_t i = 0; i < model.instances.size(); ++i) {
        const Part& part = model.parts[model.instances[i].part];
        for (std::uint32_t f = part.first_face; f < part.first_face + part.face_count; ++f)
            for (std::uint32_t k = 0; k < model.faces[f].patch_count; ++k)
                placed.emplace_back(i, model.faces[f].first_patch + k);
    }
    std::vector<Silhouettes> sets(placed.size());
    parallel_for(placed.size(), job, "silhouettes", [&](std::size_t i) {
        const auto& [instance, patch] = placed[i];
        sets[i] =
            silhouettes_of_patch(model, instance, patch, all.regions[model.patches[patch].face]);
    });
    for (Silhouettes& set : sets) append(all, std::move(set));
    return all;
}

} // namespace keiko
