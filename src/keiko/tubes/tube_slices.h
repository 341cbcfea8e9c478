#pragma once

#include "keiko/tubes/cylinder_irradiance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {

/// What of a lamp counts: the lateral surface, that and the luminous caps, or the facing rectangle.
enum class TubeOutline { lateral, capped, rectangle };

/// A part of a lamp cut by half-planes through the line parallel to its axis through the point, at
/// wedge angles psi from the direction of the axis towards `sideways` (physics 2.4).
class TubeSlices {
public:
    TubeSlices(const TubeView& view, const VisiblePart& part, TubeOutline outline)
        : view_(view), part_(part), outline_(outline) {}

    const TubeView& view() const { return view_; }
    /// The lamp lies within +- this angle.
    double half_angle() const {
        return outline_ == TubeOutline::rectangle ? std::atan(view_.radius / view_.distance)
                                                  : std::asin(view_.radius / view_.distance);
    }
    /// Whether the tangent plane cuts the axis within the part.
    bool crosses_horizon() const {
        const double foot = view_.n_lamp * view_.distance;
        return (foot + view_.n_along * part_.begin) * (foot + view_.n_along * part_.end) < 0;
    }
    /// Unit vector of the half-plane, across the axis.
    Vec3 across(double psi) const {
        return view_.sideways * std::sin(psi) - view_.towards * std::cos(psi);
    }
    /// Elevations towards end b that the part takes in the half-plane, above the horizon; empty
    /// (begin >= end) where there are none.
    ParameterInterval elevations(double psi) const {
        const double cosine = std::cos(psi), across = view_.distance * std::sin(psi);
        const double middle = view_.distance * cosine;
        double near = view_.distance / cosine, far = near;
        const double cut = near;
        if (outline_ != TubeOutline::rectangle) {
            const double half =
                std::sqrt(std::max(0.0, (view_.radius - across) * (view_.radius + across)));
            near = middle - half;
            far = outline_ == TubeOutline::capped ? middle + half : near;
        }
        const double low =
            part_.begins ? std::min(std::atan2(part_.begin, near), std::atan2(part_.begin, far))
                         : std::atan2(part_.begin, cut);
        const double high = part_.ends
                                ? std::max(std::atan2(part_.end, near), std::atan2(part_.end, far))
                                : std::atan2(part_.end, cut);
        const double level = view_.n_lamp * cosine + view_.n_sideways * std::sin(psi);
        const double zenith = std::atan2(view_.n_along, level);
        return {std::max(low, zenith - std::numbers::pi / 2),
                std::min(high, zenith + std::numbers::pi / 2)};
    }

private:
    const TubeView& view_;
    VisiblePart part_;
    TubeOutline outline_;
};

} // namespace keiko
