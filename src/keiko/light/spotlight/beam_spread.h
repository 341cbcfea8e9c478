#pragma once

#include "keiko/base/export.h"
#include "keiko/light/spotlight/photometric_web.h"

#include <optional>

namespace KEIKO_API keiko {

/// Edge of a beam to one side of its axis, in a plane through it.
struct SpreadEdge {
    /// Degrees from the axis; negative if the whole beam lies on the other side of the axis.
    double angle = 0;
    /// False if the intensity does not fall to the limit: `angle` is then the end of the tabulated
    /// range.
    bool reached = true;

    bool operator==(const SpreadEdge&) const = default;
};

/// Angular extent of a beam in a plane through its axis.
struct BeamSpread {
    SpreadEdge positive; ///< towards off_axis(type, 90, plane)
    SpreadEdge negative; ///< towards off_axis(type, -90, plane)
    /// True if the axis is the direction opposite to web_axis, as for uplights.
    bool opposite = false;

    /// Full angle in degrees between both edges; empty unless both are reached.
    std::optional<double> full_angle() const;

    bool operator==(const BeamSpread&) const = default;
};

/// Spread of a luminaire's beam in a plane, between its outermost directions with at least `share`
/// of the largest intensity in that plane. A share of 0.5 gives the beam angle, one of 0.1 the
/// field angle [LS-1]. The axis is web_axis, or its opposite if the largest intensity is nearer to
/// that. Directions over 90 degrees from the axis belong to the beam only if the intensity does not
/// fall below the limit up to them. A larger share never gives a wider spread.
///
/// `plane` is a C angle in degrees for type C. Types A and B have 0 (through H at V = 0) and 90
/// (through V at H = 0). Empty if the plane is dark.
std::optional<BeamSpread> beam_spread(const PhotometricWeb& web, double share, double plane);

/// Spreads of a beam in the planes 0 and 90; empty if the plane is dark.
struct PrincipalSpreads {
    /// Spreads in the C planes 0 and 90, or the other types' two.
    std::optional<BeamSpread> plane_0{}, plane_90{};

    bool operator==(const PrincipalSpreads&) const = default;
};

/// The beam_spread of both principal planes.
PrincipalSpreads principal_spreads(const PhotometricWeb& web, double share);

} // namespace keiko
