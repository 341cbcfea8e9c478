#pragma once

#include "keiko/intersect/subpatch/sub_patch.h"

#include <vector>

namespace keiko {

/// Cuts sub-patches from one patch. Its points are taken relative to the patch's own centre before
/// anything is computed with them.
class SubPatchMaker {
public:
    /// `patch` is the `index`-th of its model; `reach` of its face's seams, mm.
    SubPatchMaker(const BezierPatchView& patch, std::uint32_t index, double reach);
    SubPatchMaker(const SubPatchMaker&) = delete;
    SubPatchMaker& operator=(const SubPatchMaker&) = delete;

    /// The patch, relative to its centre.
    const BezierPatchView& patch() const { return patch_; }
    /// mm, diagonal of its control points' box.
    double size() const { return size_; }
    /// Whether the control points leave the line through the two that are farthest apart by more
    /// than their rounding: a patch that does not is no surface, and rays do not meet it.
    bool has_area() const;
    /// Lets sub-patches at the patch's ends go on by so much, patch parameters.
    void go_on_by(const Box2& beyond) { beyond_ = beyond; }

    /// A part of the patch that becomes a sub-patch.
    struct Share {
        Box2 box;                         ///< patch parameters
        TrimSide trim = TrimSide::inside; ///< of the box
        bool near_border = false;         ///< a trim curve, or its seam, touches the box
    };
    /// Adds the sub-patch of a share to a set. `frame` is that of the patch over the share. Throws
    /// Cancelled.
    void add(const Share& share, const SubPatchFrame& frame, SubPatchSet& set) const;

private:
    struct WeightRange {
        double least = 1, largest = 1;
    };
    static WeightRange weight_range(const std::vector<Vec4>& points);

    SubPatch sub_patch_of(const Share& share, const SubPatchFrame& frame) const;
    std::vector<Vec4> points_of(SubPatch& sub_patch) const;
    void put_at_center(std::vector<Vec4>& points, SubPatch& sub_patch) const;
    double rounding_error(double growth) const;
    double growth(const Box2& domain, double least) const;

    std::uint32_t index_;
    double reach_;
    Vec3 origin_;
    std::vector<Vec4> points_;
    BezierPatchView patch_;
    double size_ = 0;
    WeightRange weights_;
    Box2 beyond_{Vec2(0), Vec2(0)};
};

} // namespace keiko
