#pragma once

#include "keiko/geometry/bernstein/bernstein_field.h"
#include "keiko/geometry/bezier/bezier.h"
#include "keiko/math/bounds.h"

namespace keiko {

/// Height of places along a direction, mm: a linear function of them.
struct Height {
    Vec3 slope{0};     ///< mm of height in a mm of place, along each axis
    double offset = 0; ///< mm, height of the origin

    /// Height of a place, mm.
    double of(const Vec3& place) const { return slope.dot(place) + offset; }
    /// The largest height in the box; -infinity for an empty one.
    double most(const Box3& box) const {
        if (box.empty()) return -Box3::infinity;
        double sum = offset;
        for (unsigned k = 0; k < 3; ++k)
            sum += std::max(slope[k] * box.lower[k], slope[k] * box.upper[k]);
        return sum;
    }
};

/// The height of a patch over a box of its parameters, which may be a line or a point: a rational
/// function whose Bernstein coefficients bound it. Local parameters x, y in [0, 1] run over the
/// box. Weights must be positive.
class PatchHeight {
public:
    /// The height over the whole patch.
    PatchHeight(const BezierPatchView& patch, const Height& height);

    /// The box, in parameters of the patch.
    const Box2& uv() const { return uv_; }
    /// An upper bound, to within rounding: the largest coefficient, and at most the bound of the
    /// larger box that this one was cut from.
    double upper() const { return upper_; }
    /// The heights of the four corners of the box: (0, 0), (1, 0), (0, 1), (1, 1).
    std::array<double, 4> corners() const;
    /// True if the gradient may vanish anywhere in the box. For a line, only the slope along it
    /// counts.
    bool may_be_level() const;
    /// True if its coefficients vary at least as much along u as along v.
    bool varies_by_u() const;
    /// Either half; `by_u`: cut across u.
    std::array<PatchHeight, 2> halves(bool by_u) const;
    /// The height over a box within this one.
    PatchHeight over(const Box2& part) const;

    /// Ranges over the box of the derivatives by x and y.
    struct Slopes {
        Interval x;  ///< first derivative by x, mm
        Interval y;  ///< first derivative by y, mm
        Interval xx; ///< second derivative by x, mm
        Interval xy; ///< mixed derivative, mm
        Interval yy; ///< second derivative by y, mm
    };
    /// The ranges of the derivatives. Those by a parameter in which the box has no extent are 0.
    Slopes slopes() const;

private:
    PatchHeight(BernsteinField height, BernsteinField weight, const Box2& uv, double upper);
    PatchHeight narrowed(unsigned axis, double lower, double upper) const;
    double weight(int i, int j) const;
    double at(int i, int j) const;
    double variation(bool by_u) const;
    BernsteinField centered() const;

    BernsteinField height_; ///< times weight
    BernsteinField weight_; ///< of degree 0 if all weights are equal
    Box2 uv_;
    double upper_;
};

} // namespace keiko
