#include "keiko/intersect/subpatch/packed_sub_patch.h"

#include "keiko/intersect/subpatch/traced_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double infinity = std::numeric_limits<double>::infinity();

void set_bounds(PackedSubPatch& hot, const SubPatchFrame& frame) {
    const std::array<const ComponentBounds*, 4> bounds{&frame.u, &frame.v, &frame.n, &frame.w};
    for (std::size_t k = 0; k < 4; ++k) {
        hot.value[k] = bounds[k]->value;
        hot.slope[k] = bounds[k]->slope;
        hot.bend[k] = bounds[k]->bend;
    }
    hot.height = frame.height;
}

void set_patch_ends(PackedSubPatch& hot, const SubPatch& sub_patch) {
    for (unsigned k = 0; k < 2; ++k) {
        const double low = sub_patch.domain.lower[k], extent = sub_patch.domain.extent()[k];
        const double slip = 2 * sub_patch.slip[k];
        hot.patch_low[k] = std::max(-1.0, 2 * (-slip - low) / extent - 1);
        hot.patch_high[k] = std::min(1.0, 2 * (1 + slip - low) / extent - 1);
    }
}

/// Blur in mm that the polynomial's rounding causes across a row. The weight's counts with a place
/// up to 2 half sub-patches out: where the contraction is below 1, a root on the sub-patch has |a|
/// < 2.
double polynomial_blur(const std::array<double, 4>& rounding,
                       const std::array<double, 3>& row_length) {
    double blur = 0;
    for (std::size_t k = 0; k < 3; ++k)
        blur = std::max(blur, (rounding[k] + 2 * rounding[3]) / row_length[k]);
    return blur;
}

/// Puts a regular frame at its placement.
void set_frame(PackedSubPatch& hot, const SubPatch& sub_patch, const SubPatchFrame& frame,
               const PartPlacement& placement) {
    const Vec3 part_center = sub_patch.center + frame.center;
    const Vec3 center = placement.identity ? part_center : placement.to_world.point(part_center);
    for (unsigned k = 0; k < 3; ++k) {
        hot.center[k] = center[k];
        const Vec3& row = frame.rows[k];
        const auto& to_part = placement.to_part.rows;
        // A row of coordinates is turned like a normal: by the inverse transposed.
        const Vec3 turned = to_part[0] * row.x + to_part[1] * row.y + to_part[2] * row.z;
        const Vec3& used = placement.identity ? row : turned;
        hot.rows[k] = {used.x, used.y, used.z};
        hot.row_length[k] = used.length() * (1 + 4 * epsilon);
    }
}

/// Blur in mm of the stored centre and rows, which differ from the exact ones by some roundings of
/// their terms. The centre's are in world size, the rows' in the sub-patch's; the error of the
/// placement's inverse adds to both. There also count a control point's five on its way into the
/// frame, and one where an affine part was subtracted.
double frame_blur(const PackedSubPatch& hot, const SubPatch& sub_patch, const SubPatchFrame& frame,
                  const PartPlacement& placement) {
    const double size = placement.magnification * (sub_patch.radius + frame.center.length());
    const double away = Vec3(hot.center[0], hot.center[1], hot.center[2]).length() +
                        placement.to_world.translation.length() +
                        placement.magnification * sub_patch.center.length();
    const double turning = placement.identity ? 1 : placement.magnification * placement.reduction;
    return placement.magnification * sub_patch.coefficient_error + 4 * epsilon * away +
           (16 * epsilon * turning + 2 * placement.inverse_error) * size;
}

} // namespace

void PackedSubPatch::set_unbounded() {
    regular = false;
    value.fill(infinity);
    slope.fill(infinity);
    bend.fill(infinity);
    height = infinity;
}

PackedSubPatch packed_sub_patch(const SubPatchSet& sub_patches, std::uint32_t index,
                                const PartPlacement& placement) {
    const SubPatch& sub_patch = sub_patches.sub_patches[index];
    const SubPatchFrame& frame = sub_patches.frames[index];
    PackedSubPatch hot;
    hot.degree_u = static_cast<std::uint8_t>(sub_patch.degree_u);
    hot.degree_v = static_cast<std::uint8_t>(sub_patch.degree_v);
    hot.polynomial = sub_patch.first_point;
    hot.rational = sub_patches.view(sub_patch).rational();
    hot.material = sub_patch.trim == TrimSide::inside;
    set_patch_ends(hot, sub_patch);
    hot.regular = frame.regular;
    if (!frame.regular) {
        hot.set_unbounded();
        return hot;
    }
    set_bounds(hot, frame);
    set_frame(hot, sub_patch, frame, placement);
    hot.blur = frame_blur(hot, sub_patch, frame, placement) +
               polynomial_blur(sub_patches.roundings[index], hot.row_length);
    return hot;
}

namespace {

class Classifier {
public:
    Classifier(const SubPatch& sub_patch, const PatchFrame& patch, const FaceTrim& trim)
        : sub_patch_(sub_patch), patch_(patch), trim_(trim) {}

    /// Classifies the cells of a square of `count` x `count`; (i, j) is the first.
    void classify(unsigned i, unsigned j, unsigned count) {
        const Vec2 first(i, j), last(i + count, j + count);
        // Roots are rounded on their way to the face's parameters.
        const Vec2 room(1e-9);
        const Box2 here{sub_patch_.patch_parameters((first - room) / 8),
                        sub_patch_.patch_parameters((last + room) / 8)};
        const TrimSide side =
            within(here, unit_square) ? trim_.region.classify(on_face(here)) : TrimSide::mixed;
        const TrimCells::Set cells =
            TrimCells::met({(first + room) / 4 - Vec2(1), (last - room) / 4 - Vec2(1)});
        if (side == TrimSide::inside)
            cells_.material |= cells;
        else if (side == TrimSide::outside && !may_be_seam(here))
            cells_.empty |= cells;
        else if (count > 1)
            for (const unsigned dj : {0U, count / 2})
                for (const unsigned di : {0U, count / 2}) classify(i + di, j + dj, count / 2);
    }
    const TrimCells& cells() const { return cells_; }

private:
    static bool within(const Box2& box, const Box2& all) {
        return all.contains(box.lower) && all.contains(box.upper);
    }
    Box2 on_face(const Box2& box) const {
        Box2 result;
        result.extend(patch_.to_face(box.lower));
        result.extend(patch_.to_face(box.upper));
        return result;
    }
    bool may_be_seam(const Box2& box) const {
        // Where the reach is wider, or not known at a pole, boxes of curves tell nothing.
        constexpr double widest = 0.01;
        if (!(trim_.reach > 0)) return false;
        const Vec2& reach = sub_patch_.seam_reach;
        if (!(reach.x < widest && reach.y < widest)) return true;
        return trim_.region.may_be_near_edge(on_face({box.lower - reach, box.upper + reach}));
    }

    const SubPatch& sub_patch_;
    const PatchFrame& patch_;
    const FaceTrim& trim_;
    TrimCells cells_;
};

} // namespace

TrimCells trim_cells(const SubPatch& sub_patch, const PatchFrame& patch, const FaceTrim& trim) {
    if (sub_patch.trim != TrimSide::mixed) return {};
    Classifier classifier(sub_patch, patch, trim);
    classifier.classify(0, 0, 8);
    return classifier.cells();
}

} // namespace keiko
