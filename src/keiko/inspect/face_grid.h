#pragma once

#include "keiko/inspect/placed_patch.h"
#include "keiko/patch/trim_region.h"

#include <optional>
#include <vector>

namespace keiko {

/// A place of a placed face that was looked at.
struct FaceSample {
    Vec3 position{0}; ///< world, mm
    Vec3 normal{0};   ///< outward
    /// 1/mm, normal curvature along the lines of constant v and of constant u; positive where the
    /// surface bends towards the normal.
    double bend_u = 0, bend_v = 0;
    double area = 0; ///< mm2 that it stands for
    bool material = false;
};

/// A placed face over all its knot spans, sampled evenly. Places of it are (u, v), their whole
/// parts count spans, the rest runs over one from 0 to 1.
class FaceGrid {
public:
    /// `spacing`: about how far samples lie apart, mm.
    FaceGrid(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face, double spacing);

    std::size_t columns() const { return u_.size(); } ///< along u
    std::size_t rows() const { return v_.size(); }    ///< along v
    const FaceSample& sample(std::size_t column, std::size_t row) const {
        return samples_[row * u_.size() + column];
    }
    Vec2 place(std::size_t column, std::size_t row) const { return {u_[column], v_[row]}; }

    /// The surface at a place, with its first derivatives by (u, v), order 2 with its second,
    /// world, mm; nothing where there is no material.
    std::optional<SurfaceDerivatives> evaluate(const Vec2& place, int order) const;
    /// -1 where the outward normal is -(du x dv).
    double sign() const { return sign_; }

private:
    void arrange(std::uint32_t instance);
    void choose_places(double spacing);
    FaceSample sampled(const Vec2& place) const;
    /// Into patches_; no_index beyond the face.
    std::uint32_t patch_at(const Vec2& place) const;

    const SurfaceModel& model_;
    const Face& face_;
    TrimRegion trims_;
    double sign_;
    std::vector<PlacedPatch> patches_;
    std::vector<double> spans_u_, spans_v_; ///< where spans begin, in face parameters
    std::vector<std::uint32_t> table_;      ///< into patches_, v outer
    std::vector<double> u_, v_;             ///< of the samples
    std::vector<double> width_u_, width_v_; ///< that they stand for
    std::vector<FaceSample> samples_;       ///< v outer
};

} // namespace keiko
