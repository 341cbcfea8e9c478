#include "keiko/intersect/subpatch/traced_model.h"

#include "keiko/base/error.h"
#include "keiko/base/parallel.h"
#include "keiko/geometry/bezier/subpatch.h"
#include "keiko/intersect/subpatch/seam_width.h"

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

/// Of the inverse as rounding has left it: what the product lacks of 1, and the product's rounding.
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
                                      const std::vector<std::uint32_t>& first_leaf_of_face) {
    std::vector<PartPlacement> result;
    for (const Instance& instance : model.instances) {
        const Part& part = model.parts[instance.part];
        const std::uint32_t first = first_leaf_of_face[part.first_face];
        const std::uint32_t end = first_leaf_of_face[part.first_face + part.face_count];
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
                          .first_leaf = first,
                          .leaf_count = end - first});
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

/// `cells`, a leaf.
void place_leaves(TracedModel& traced, const std::vector<TrimCells>& cells) {
    for (std::uint32_t i = 0; i < traced.placements.size(); ++i) {
        const PartPlacement& placement = traced.placements[i];
        for (std::uint32_t k = 0; k < placement.leaf_count; ++k) {
            traced.placed.push_back({i, placement.first_leaf + k});
            traced.hot.push_back(hot_leaf(traced.leaves, placement.first_leaf + k, placement));
            traced.hot.back().cells = cells[placement.first_leaf + k];
        }
    }
    // The records hold all that tracing reads of them.
    traced.leaves.frames = {};
    traced.leaves.roundings = {};
}

} // namespace

TracedModel traced_model(const SurfaceModel& model, double join, double flat_enough,
                         const Job& job) {
    std::vector<SeamGap> gaps = seam_gaps(model, join, job);
    std::vector<double> widths;
    for (const SeamGap& gap : gaps) widths.push_back(gap.width);
    std::vector<std::optional<FaceTrim>> trims(model.faces.size());
    std::vector<LeafSet> sets(model.faces.size());
    std::vector<std::vector<TrimCells>> cells_by_face(model.faces.size());
    parallel_for(model.faces.size(), job, "build", [&](std::size_t i) {
        const Face& face = model.faces[i];
        trims[i] = FaceTrim{TrimRegion(model, face, widths), widest_seam(model, face, gaps)};
        sets[i] =
            make_leaves(model, face, trims[i]->region, seam_depth * trims[i]->reach, flat_enough);
        for (const Leaf& leaf : sets[i].leaves)
            cells_by_face[i].push_back(
                trim_cells(leaf, patch_frame(model, model.patches[leaf.patch]), *trims[i]));
    });

    TracedModel traced;
    std::vector<std::uint32_t> first_leaf;
    std::vector<TrimCells> cells;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        first_leaf.push_back(static_cast<std::uint32_t>(traced.leaves.leaves.size()));
        append(traced.leaves, std::move(sets[i]));
        cells.insert(cells.end(), cells_by_face[i].begin(), cells_by_face[i].end());
        traced.faces.push_back(std::move(*trims[i]));
    }
    first_leaf.push_back(static_cast<std::uint32_t>(traced.leaves.leaves.size()));
    for (const Patch& patch : model.patches) traced.patches.push_back(patch_frame(model, patch));
    traced.seam_widths = edge_widths(model, gaps);
    traced.seam_gaps = std::move(gaps);
    traced.placements = placements(model, first_leaf);
    place_leaves(traced, cells);
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

Box3 TracedModel::bounds(const PlacedLeaf& at) const {
    const Leaf& leaf = leaves.leaves[at.leaf];
    const PartPlacement& placement = placements[at.instance];
    Box3 box;
    // A bent leaf's quarters have far smaller hulls than its whole.
    for (const Vec2& corner : {Vec2(0, 0), Vec2(0.5, 0), Vec2(0, 0.5), Vec2(0.5, 0.5)})
        for (const Vec4& p : subpatch(leaves.view(leaf), {corner, corner + Vec2(0.5)})) {
            const Vec3 point = leaf.center + Vec3(p.x, p.y, p.z) / p.w;
            box.extend(placement.identity ? point : placement.to_world.point(point));
        }
    // What the leaf is off, and the rounding of placing it.
    const double away = leaf.center.length() + leaf.radius;
    const double rounding =
        4 * epsilon * (placement.magnification * away + placement.to_world.translation.length());
    return box.padded(placement.magnification * leaf.coefficient_error + rounding);
}

std::size_t TracedModel::bytes() const {
    std::size_t trims = 0;
    for (const FaceTrim& face : faces) trims += face.region.bytes();
    for (const SeamGap& gap : seam_gaps) trims += gap.samples.size() * sizeof(SeamGap::Sample);
    return trims + leaves.leaves.size() * sizeof(Leaf) + leaves.points.size() * sizeof(Vec4) +
           leaves.polynomials.size() * sizeof(leaves.polynomials.front()) +
           placed.size() * (sizeof(PlacedLeaf) + sizeof(HotLeaf)) +
           patches.size() * sizeof(PatchFrame) + faces.size() * sizeof(FaceTrim) +
           seam_gaps.size() * sizeof(SeamGap) + seam_widths.size() * sizeof(double) +
           placements.size() * sizeof(PartPlacement);
}

} // namespace keiko
