#pragma once

#include "keiko/light/luminance/clear_coat.h"
#include "keiko/light/tubes/c_plane.h"
#include "keiko/light/tubes/cylinder_irradiance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace keiko {

/// One of few half-planes that represent the width of a lamp.
struct AcrossNode {
    double x = 0;      ///< wedge angle in half widths of the lamp, -1 to 1
    double weight = 0; ///< all together 2
    /// Distance of the near side, and with it of the rims at the ends, from the axis, in radii. It
    /// is the circle at x, scaled so that the mean over the rule is the circle's, pi / 4. Unscaled,
    /// Gauss's rules of so few nodes miss that by up to a quarter, an error of first order in d /
    /// D.
    double rim = 0;
};

/// Gauss's rule of 1, 2 or 4 nodes.
std::span<const AcrossNode> width_quadrature(int nodes);

/// Outline of a lamp that counts.
enum class TubeOutline {
    lateral,  ///< the lateral surface alone: caps are dark
    capped,   ///< the lateral surface and the luminous caps
    rectangle ///< the rectangle through the axis that faces the point
};

/// A part of a lamp cut by half-planes through the line parallel to its axis through the point, at
/// wedge angles psi from the direction of the axis towards `sideways`
/// (docs/theory/luminance.md#a-tube).
class TubeSlices {
public:
    /// Slices of a part of a lamp; a reference to the view is kept.
    TubeSlices(const TubeView& view, const VisiblePart& part, TubeOutline outline)
        : view_(view), part_(part), outline_(outline) {}

    /// View of the lamp.
    const TubeView& view() const { return view_; }
    /// Part of the lamp that is cut.
    const VisiblePart& part() const { return part_; }
    /// Half of the angle that the lamp covers, to either side of its axis.
    double half_angle() const {
        return outline_ == TubeOutline::rectangle ? std::atan(view_.radius / view_.distance)
                                                  : std::asin(view_.radius / view_.distance);
    }
    /// Nearness of the lamp to the horizon: the dip of half its width towards the tangent plane
    /// over the height of its axis, where the part is lowest. For a part that the plane cuts
    /// across, it is four times the ratio where the part is highest. The visible part of a lamp
    /// changes across it by about that share where light grazes. Infinite if the plane may cut it
    /// lengthwise.
    double dip() const {
        const double dips = view_.radius * std::abs(view_.n_sideways);
        if (whole()) return dips / std::min(height(part_.begin), height(part_.end));
        const double highest = std::max(height(part_.begin), height(part_.end));
        return std::abs(height(0)) > dips && highest > view_.radius
                   ? 4 * dips / highest
                   : std::numeric_limits<double>::infinity();
    }
    /// True if all of the part is certainly above the horizon.
    bool whole() const { return std::min(height(part_.begin), height(part_.end)) > view_.radius; }
    /// Unit vector of the half-plane, across the axis.
    Vec3 across(double psi) const {
        return view_.sideways * std::sin(psi) - view_.towards * std::cos(psi);
    }
    /// Elevations towards end b that the part occupies in the half-plane, above the horizon; empty
    /// (begin >= end) if there are none.
    ParameterInterval elevations(double psi) const {
        const double across = view_.distance * std::sin(psi);
        return elevations(
            psi, std::sqrt(std::max(0.0, (view_.radius - across) * (view_.radius + across))));
    }
    /// Elevations for a near side that is `rim` mm in front of the axis, and a far side as much
    /// behind it.
    ParameterInterval elevations(double psi, double rim) const {
        const ParameterInterval lit = lit_ends(psi, rim);
        return {2 * std::atan(lit.begin), 2 * std::atan(lit.end)};
    }
    /// Elevations above the horizon as tangents of half the angles, which are found without angles.
    ParameterInterval lit_ends(double psi, double rim) const {
        const double level = view_.n_lamp * std::cos(psi) + view_.n_sideways * std::sin(psi);
        return above_horizon(level, view_.n_along, ends(psi, rim));
    }
    /// Elevations regardless of the horizon, as tangents of half the elevations.
    ParameterInterval ends(double psi, double rim) const {
        const double cosine = std::cos(psi), cut = view_.distance / cosine;
        double near = cut, far = cut;
        if (outline_ != TubeOutline::rectangle) {
            near = view_.distance * cosine - rim;
            far = outline_ == TubeOutline::capped ? view_.distance * cosine + rim : near;
        }
        return {part_.begins
                    ? std::min(half_tangent(part_.begin, near), half_tangent(part_.begin, far))
                    : half_tangent(part_.begin, cut),
                part_.ends ? std::max(half_tangent(part_.end, near), half_tangent(part_.end, far))
                           : half_tangent(part_.end, cut)};
    }

private:
    /// Height of the axis over the tangent plane, mm.
    double height(double x) const { return view_.n_lamp * view_.distance + view_.n_along * x; }

    const TubeView& view_;
    VisiblePart part_;
    TubeOutline outline_;
};

/// Share of the light of a lamp's part that enters a coat, 0 to 1. It is the mean over the visible
/// part, weighted by the illuminance of each piece; 0 if all of it lies below the horizon. If
/// `model` is automatic or cylinder it is accurate to 1e-5. Else it takes few half-planes, accurate
/// to 2.3e-3, in the mean to 1e-4. The error is 4e-3 where a short lamp ends at the horizon, and
/// 1e-2 where little of it is left.
double entering_share(const ClearCoat& coat, const TubeSlices& slices,
                      TubeModel model = TubeModel::automatic);

} // namespace keiko
