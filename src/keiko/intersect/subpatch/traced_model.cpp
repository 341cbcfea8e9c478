#include "keiko/intersect/subpatch/traced_model.h"

#include "keiko/base/error.h"
#include "keiko/base/parallel.h"
#include "keiko/geometry/bezier/subpatch.h"
#include "keiko/math/unit_vectors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

double frobenius_norm(const std::array<Vec3, 3>& rows) {
    double squares = 0;
    for (const Vec3& row : rows) squares += row.length2();
    return std::sqrt(squares);
}

/// Bound of the largest stretch, exact where rows stay at right angles: by Gershgorin's circles of
/// the rows' products with each other, and these products' rounding.
double stretch(const Affine& map) {
    double widest = 0;
    for (const Vec3& a : map.rows) {
        double sum = 0;
        for (const Vec3& b : map.rows) sum += std::abs(a.dot(b));
        widest = std::max(widest, sum);
    }
    const double all = frobenius_norm(map.rows);
    return std::sqrt(widest + 8 * epsilon * all * all);
}

/// Error of the inverse left by rounding: the product's distance from 1, and the product's
/// rounding.
double inverse_error(const Affine& map, const Affine& inverse) {
    Affine off = inverse * map;
    for (unsigned k = 0; k < 3; ++k) off.rows[k][k] -= 1;
    return frobenius_norm(off.rows) +
           4 * epsilon * frobenius_norm(map.rows) * frobenius_norm(inverse.rows);
}

/// A placement that is far from turning and scaling alone leaves no bound of use to what is
/// computed in the part.
void require_placeable(const Instance& instance, const Affine& inverse) {
    constexpr double most = 1e4;
    const double condition =
        frobenius_norm(instance.transform.rows) * frobenius_norm(inverse.rows) / 3;
    if (condition <= most) return;
    throw Error("", instance.name.empty() ? "instance" : "instance " + instance.name,
                "its placement is flat, or sheared beyond all measure");
}

std::vector<PartPlacement> placements(const SurfaceModel& model,
                                      const std::vector<std::uint32_t>& first_sub_patch_of_face) {
    std::vector<PartPlacement> result;
    for (const Instance& instance : model.instances) {
        const Part& part = model.parts[instance.part];
        const std::uint32_t first = first_sub_patch_of_face[part.first_face];
        const std::uint32_t end = first_sub_patch_of_face[part.first_face + part.face_count];
        const Affine to_part = instance.transform.inverse();
        require_placeable(instance, to_part);
        const bool identity = instance.transform.is_identity();
        const double error = identity ? 0 : inverse_error(instance.transform, to_part);
        result.push_back({.to_world = instance.transform,
                          .to_part = to_part,
                          .identity = identity,
                          .magnification = stretch(instance.transform),
                          .reduction = stretch(to_part) * (1 + 2 * error),
                          .inverse_error = error,
                          .first_sub_patch = first,
                          .sub_patch_count = end - first});
    }
    return result;
}

double widest_seam(const SurfaceModel& model, const Face& face, const std::vector<SeamGap>& gaps) {
    double widest = 0;
    for (const TrimLoop& loop : model.loops_of(face))
        for (std::uint32_t c = loop.first_curve; c < loop.first_curve + loop.curve_count; ++c)
            widest = std::max(widest, gaps[c].width);
    return widest;
}

std::vector<double> edge_widths(const SurfaceModel& model, const std::vector<SeamGap>& gaps) {
    std::vector<double> widths(model.edges.size());
    for (std::size_t c = 0; c < gaps.size(); ++c)
        if (const std::uint32_t edge = model.trim_curves[c].edge; edge != no_index)
            widths[edge] = std::max(widths[edge], gaps[c].width);
    return widths;
}

PatchFrame patch_frame(const SurfaceModel& model, const Patch& patch) {
    return {patch.face, patch.map_u, patch.map_v, model.faces[patch.face].reversed};
}

/// `cells`, a sub-patch.
void place_sub_patches(TracedModel& traced, const std::vector<TrimCells>& cells) {
    for (std::uint32_t i = 0; i < traced.placements.size(); ++i) {
        const PartPlacement& placement = traced.placements[i];
        for (std::uint32_t k = 0; k < placement.sub_patch_count; ++k) {
            traced.placed.push_back({i, placement.first_sub_patch + k});
            traced.hot.push_back(
                packed_sub_patch(traced.sub_patches, placement.first_sub_patch + k, placement));
            traced.hot.back().cells = cells[placement.first_sub_patch + k];
        }
    }
    // The records hold all that tracing reads of them.
    traced.sub_patches.frames = {};
    traced.sub_patches.roundings = {};
}

} // namespace

TracedModel traced_model(const SurfaceModel& model, double join, double flat_enough,
                         const Job& job) {
    std::vector<SeamGap> gaps = seam_gaps(model, join, job);
    std::vector<double> widths;
    for (const SeamGap& gap : gaps) widths.push_back(gap.width);
    std::vector<std::optional<FaceTrim>> trims(model.faces.size());
    std::vector<SubPatchSet> sets(model.faces.size());
    std::vector<std::vector<TrimCells>> cells_by_face(model.faces.size());
    parallel_for(model.faces.size(), job, "build", [&](std::size_t i) {
        const Face& face = model.faces[i];
        trims[i] = FaceTrim{TrimRegion(model, face, widths), widest_seam(model, face, gaps)};
        sets[i] =
            subdivide(model, face, trims[i]->region, seam_depth * trims[i]->reach, flat_enough);
        for (const SubPatch& sub_patch : sets[i].sub_patches)
            cells_by_face[i].push_back(trim_cells(
                sub_patch, patch_frame(model, model.patches[sub_patch.patch]), *trims[i]));
    });

    TracedModel traced;
    std::vector<std::uint32_t> first_sub_patch;
    std::vector<TrimCells> cells;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        first_sub_patch.push_back(
            static_cast<std::uint32_t>(traced.sub_patches.sub_patches.size()));
        append(traced.sub_patches, std::move(sets[i]));
        cells.insert(cells.end(), cells_by_face[i].begin(), cells_by_face[i].end());
        traced.faces.push_back(std::move(*trims[i]));
    }
    first_sub_patch.push_back(static_cast<std::uint32_t>(traced.sub_patches.sub_patches.size()));
    for (const Patch& patch : model.patches) traced.patches.push_back(patch_frame(model, patch));
    traced.seam_widths = edge_widths(model, gaps);
    traced.seam_gaps = std::move(gaps);
    traced.placements = placements(model, first_sub_patch);
    place_sub_patches(traced, cells);
    return traced;
}

PartRay TracedModel::to_part(const PartPlacement& placement, const Vec3& origin,
                             const Vec3& direction, double error) const {
    if (placement.identity) return part_ray(origin, direction, error);
    const double rounding = (8 * epsilon + 2 * placement.inverse_error) *
                            (origin.length() + placement.to_world.translation.length());
    PartRay ray = part_ray(placement.to_part.point(origin), placement.to_part.vector(direction),
                           (error + rounding) * placement.reduction);
    ray.turn =
        2 * placement.inverse_error + 4 * epsilon * placement.magnification * placement.reduction;
    return ray;
}

Box3 TracedModel::bounds(const PlacedSubPatch& at) const {
    const SubPatch& sub_patch = sub_patches.sub_patches[at.sub_patch];
    const PartPlacement& placement = placements[at.instance];
    Box3 box;
    // A bent sub-patch's quarters have far smaller hulls than its whole.
    for (const Vec2& corner : {Vec2(0, 0), Vec2(0.5, 0), Vec2(0, 0.5), Vec2(0.5, 0.5)})
        for (const Vec4& p : subpatch(sub_patches.view(sub_patch), {corner, corner + Vec2(0.5)})) {
            const Vec3 point = sub_patch.center + euclidean(p);
            box.extend(placement.identity ? point : placement.to_world.point(point));
        }
    // What the sub-patch is off, and the rounding of placing it.
    const double away = sub_patch.center.length() + sub_patch.radius;
    const double rounding =
        4 * epsilon * (placement.magnification * away + placement.to_world.translation.length());
    return box.padded(placement.magnification * sub_patch.coefficient_error + rounding);
}

std::size_t TracedModel::bytes() const {
    std::size_t trims = 0;
    for (const FaceTrim& face : faces) trims += face.region.bytes();
    for (const SeamGap& gap : seam_gaps) trims += gap.samples.size() * sizeof(SeamGap::Sample);
    return trims + sub_patches.sub_patches.size() * sizeof(SubPatch) +
           sub_patches.points.size() * sizeof(Vec4) +
           sub_patches.polynomials.size() * sizeof(sub_patches.polynomials.front()) +
           placed.size() * (sizeof(PlacedSubPatch) + sizeof(PackedSubPatch)) +
           patches.size() * sizeof(PatchFrame) + faces.size() * sizeof(FaceTrim) +
           seam_gaps.size() * sizeof(SeamGap) + seam_widths.size() * sizeof(double) +
           placements.size() * sizeof(PartPlacement);
}

namespace {

/// Vector from the sub-patch's centre to the place of the ray nearest to it. Starting from there
/// keeps the numbers as small as the sub-patch, however far off the ray begins.
Vec3 foot_point(const PartRay& ray, const SubPatch& sub_patch, double& foot) {
    const Vec3 to_center = sub_patch.center - ray.origin;
    foot = to_center.dot(ray.direction);
    return ray.direction * foot - to_center;
}

} // namespace

PartRay part_ray(const Vec3& origin, const Vec3& direction, double error) {
    PartRay ray;
    ray.origin = origin;
    ray.speed = direction.length();
    ray.direction = direction / ray.speed;
    const AxesAcross across(ray.direction, std::copysign(1.0, ray.direction.z));
    ray.normal_f = across.x;
    ray.normal_g = across.y;
    ray.error = error;
    return ray;
}

bool near_sub_patch(const PartRay& ray, const SubPatch& sub_patch) {
    double foot = 0;
    const Vec3 off = foot_point(ray, sub_patch, foot);
    const double reach =
        sub_patch.radius + sub_patch.coefficient_error + ray.error + ray.turn * std::abs(foot);
    // The 1 + 1e-9 covers the rounding of the three lines above.
    return off.dot(off) <= reach * reach * (1 + 1e-9) + 1e-30 * foot * foot;
}

RayProjection project_ray(const PartRay& ray, const SubPatch& sub_patch,
                          const BezierPatchView& points) {
    RayProjection view;
    const Vec3 off = foot_point(ray, sub_patch, view.foot);
    const double off_f = ray.normal_f.dot(off), off_g = ray.normal_g.dot(off);
    view.net.degree_u = points.degree_u;
    view.net.degree_v = points.degree_v;
    for (std::size_t i = 0; i < points.points.size(); ++i) {
        const Vec4& p = points.points[i];
        const Vec3 xyz(p.x, p.y, p.z);
        view.net.f[i] = ray.normal_f.dot(xyz) - p.w * off_f;
        view.net.g[i] = ray.normal_g.dot(xyz) - p.w * off_g;
    }
    const double size = sub_patch.radius + off.length();
    const double steps = 8 + 4.0 * (points.degree_u + points.degree_v);
    view.slack = sub_patch.weight *
                 (epsilon * steps * size + (4 * epsilon + ray.turn) * std::abs(view.foot) +
                  sub_patch.coefficient_error + ray.error);
    return view;
}

} // namespace keiko
