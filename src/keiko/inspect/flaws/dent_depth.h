#pragma once

#include "keiko/inspect/flaws/face_adjacency.h"

#include <array>
#include <optional>
#include <span>

namespace keiko {

// The form around a place of a surface, and the depth of a dent below it.

/// A place of a surface beside a tangent plane, mm, and its weight.
struct FormHeight {
    double x = 0;      ///< mm, in the plane from its origin
    double y = 0;      ///< mm, in the plane, square to x
    double z = 0;      ///< mm, from the plane along its normal
    double weight = 1; ///< factor of its square in the fit's sum
};

/// Smooth forms of a ReferenceForm, by what is a polynomial of the place in the plane.
enum class BaseKind {
    flat, ///< the height z
    bent ///< z - b z² / 2, with the larger curvature b at the origin: exact for spheres, cylinders
};

/// Domains of the heights of a ReferenceForm.
enum class BaseDomain {
    disc, ///< around the origin
    line  ///< on the x axis; their y does not count
};

/// The form under a dent: a polynomial of total degree 4 over the plane through most heights.
/// Outliers do not count. It is fitted by iteratively reweighted least squares, first to the
/// smallest sum of distances, then with Tukey's biweight [HollandWelsch1977], as [ISO16610-31] does
/// for profiles.
class ReferenceForm {
public:
    /// Number of terms x^i y^j of total degree 0 to 4; on a line the first 5 are those of x.
    static constexpr std::size_t term_count = 15;

    /// The form of the heights within `reach` of the origin, mm; nullopt if they are fewer than
    /// twice the terms or, on a disc, too close to a line.
    static std::optional<ReferenceForm> fit(std::span<const FormHeight> heights, double reach,
                                            BaseKind kind = BaseKind::flat,
                                            BaseDomain domain = BaseDomain::disc);

    /// mm: deviation of a height from the form, along the normal of the plane near the origin.
    double offset(const FormHeight& height) const;
    /// mm: height of the form above the plane at the origin.
    double at_origin() const { return terms_[0]; }
    double reach() const { return reach_; } ///< mm
    /// mm: estimated error of the form's height at the origin. It is the root of the mean square
    /// distance of the heights that count, times the fit's Lebesgue constant, which is large where
    /// a gap or a side has no heights.
    double origin_bound() const { return origin_bound_; }

private:
    double levelled(double z) const { return z - bend_ / 2 * z * z; }

    double reach_ = 1, origin_bound_ = 0;
    double bend_ = 0; ///< 1/mm, 0 of a flat one
    BaseDomain domain_ = BaseDomain::disc;
    std::array<double, term_count> terms_{};
};

/// Deviation of a surface from the form around a place.
struct DentDepth {
    double offset = 0;      ///< mm, positive outwards: of a bump
    double bound = 0;       ///< mm, an estimate
    SheetPoint at;          ///< where the deviation is largest
    Vec3 position{0};       ///< world, mm
    bool one_sided = false; ///< a border is so near that some quarter around has no form
    bool alone = false; ///< less than a quarter of the surroundings deviates half as much, unlike
                        ///< waves
};

/// Climbs from a place to the largest deviation of the surface from the form around it, which is
/// fitted in windows about `reach` mm to either side (docs/theory/inspection.md). The climb
/// crosses smooth seams and stays on one side of a border. nullopt if the surroundings are too
/// small.
std::optional<DentDepth> dent_depth(const FaceAdjacency& faces, const SheetPoint& begin,
                                    double reach);

} // namespace keiko
