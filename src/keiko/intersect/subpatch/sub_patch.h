#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/intersect/subpatch/sub_patch_frame.h"

#include <cstdint>
#include <vector>

namespace keiko {

/// A piece of a patch, split until most rays are proved to meet it at most once; near a pole that
/// cannot be had.
struct SubPatch {
    std::uint32_t patch = 0;                  ///< index into the model's patches
    std::uint16_t degree_u = 1, degree_v = 1; ///< of the patch
    TrimSide trim = TrimSide::inside;         ///< never outside: such sub-patches are not kept
    bool near_border = false;                 ///< a trim curve, or its seam, touches it
    std::uint32_t first_point = 0;            ///< into SubPatchSet::points
    /// Patch parameters it covers: a little more than its share, so that no ray slips through
    /// between neighbours, nor between sewn faces.
    Box2 domain;
    /// Patch parameters beyond [0, 1] by which rounding alone may carry a hit; what lies farther
    /// out can only be a seam hit.
    Vec2 slip{0};
    /// Bound of the face's seam reach in patch parameters anywhere on the sub-patch; infinite where
    /// mm say nothing about parameters, as at a pole.
    Vec2 seam_reach{0};
    /// Unit; the surface's own unit normal, of either sense, is nowhere on the sub-patch farther
    /// from it than `normal_spread`, infinite where that is not known.
    Vec3 normal{0};
    double normal_spread = 0; ///< length of the difference of the two unit vectors
    Vec3 center{0};           ///< part coordinates
    double radius = 0;        ///< mm, of the ball about the centre that holds the control points
    double weight = 1;        ///< largest weight
    /// Bound of what making the sub-patch moved a control point by, mm.
    double coefficient_error = 0;

    /// Patch parameters of a place of the sub-patch's own [0, 1]^2.
    Vec2 patch_parameters(const Vec2& uv) const { return domain.lower + domain.extent() * uv; }
};

/// The sub-patches of one part, in part coordinates.
struct SubPatchSet {
    std::vector<SubPatch> sub_patches; ///< by rising patch
    /// Homogeneous control points relative to the sub-patch's centre, (w (p - centre), w): in world
    /// coordinates the terms w * centre would drown the derivatives that the proof needs.
    std::vector<Vec4> points;
    /// One a sub-patch; polynomials as SubPatchPolynomial, entry for entry beside the points. Both
    /// are 0 for sub-patches without a regular frame.
    std::vector<SubPatchFrame> frames;
    std::vector<std::array<double, 4>> polynomials; ///< one entry a control point
    std::vector<std::array<double, 4>> roundings;   ///< of the polynomials, one a sub-patch
    std::size_t trimmed_away = 0; ///< pieces that hold no material, and patches without area

    /// Control points of a sub-patch of this set, relative to its centre; valid while `points` is.
    BezierPatchView view(const SubPatch& sub_patch) const;
};

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

/// Adds the sub-patches of `more` behind those of `all`.
void append(SubPatchSet& all, SubPatchSet more);

/// Splits the patches of a face into sub-patches, cropped to the face's material and without those
/// that hold none of it within `reach` mm, as the patch's mean edge lengths tell. Halves them until
/// SubPatchFrame::contraction is at most `flat_enough`, up to four times along one parameter.
SubPatchSet subdivide(const SurfaceModel& model, const Face& face, const TrimRegion& region,
                      double reach, double flat_enough);

} // namespace keiko
