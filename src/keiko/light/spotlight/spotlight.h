#pragma once

#include "keiko/base/export.h"
#include "keiko/light/spotlight/beam_direction.h"
#include "keiko/light/spotlight/photometric_web.h"
#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"

#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace KEIKO_API keiko {

/// Falloff of the intensity towards the rim of the beam [NishitaSpots, eq. 4 to 6].
enum class BeamEdge {
    sharp, ///< 1 up to the rim
    soft,  ///< falls to 0 at the rim
    mixed  ///< falls to q at the rim
};

/// Edges of the paper: with s = (cos theta - cos g) / (1 - cos g), 1, s, or (1 - q) s + q.
struct EdgeProfile {
    BeamEdge edge = BeamEdge::soft; ///< form of the falloff
    double q = 0.5;                 ///< share of the sharp edge if the edge is mixed

    bool operator==(const EdgeProfile&) const = default;
};

/// Power of the cosine, cos^c theta [Warn1983], for comparison; 0 beyond 90 degrees.
struct CosinePower {
    double exponent = 1; ///< the power c, 0 or more

    bool operator==(const CosinePower&) const = default;
};

/// c0 + c1 cos theta + c2 cos^2 theta ..., not below 0.
struct CosinePolynomial {
    std::vector<double> coefficients; ///< c0, c1, c2, ...

    bool operator==(const CosinePolynomial&) const = default;
};

/// A table over theta (V) and phi (H).
using TableProfile = std::shared_ptr<const IntensityTable>;

/// Intensity relative to the lamp's given one, by direction.
using BeamProfile = std::variant<EdgeProfile, CosinePower, CosinePolynomial, TableProfile>;

/// Value of the polynomial at x, not below 0.
double polynomial_value(const CosinePolynomial& polynomial, double x);

/// Value of the profile into a direction: 0 beyond the rim (docs/theory/spotlights.md#profiles).
/// `phi` is that of the direction in radians plus the lamp's spin, `rim` the versine of the beam's
/// half angle there.
double profile_share(const BeamProfile& profile, const BeamDirection& direction, double phi,
                     double rim);

/// Petals k(phi) [NishitaSpots, eq. 11], bright at multiples of 360 degrees / count, dark between
/// them.
struct Petals {
    int count = 12; ///< in a full turn
    double q = 0;   ///< below 1: their least brightness, if not negative; a smaller q makes them
                    ///< narrower

    bool operator==(const Petals&) const = default;
};

/// Readings of the polka dots of [NishitaSpots, eq. 12].
enum class DotReading {
    centred, ///< each dot is bright in its middle (docs/theory/spotlights.md#patterns)
    rounded, ///< [x] of the paper is the nearest integer: dots about multiples of the periods
    literal  ///< as printed: each dot falls into two opposite quarters
};

/// Polka dots: every second cell of a grid in phi and theta.
struct Dots {
    double dphi = 30, dtheta = 4;             ///< degrees; dphi divides 360 an even number of times
    double q_phi = 0, q_theta = 0;            ///< below 1; smaller ones make smaller dots
    DotReading reading = DotReading::centred; ///< how the formula is read

    bool operator==(const Dots&) const = default;
};

/// A polynomial in cos phi, not below 0.
struct PhiPolynomial {
    CosinePolynomial in_cosine; ///< the polynomial in cos phi

    bool operator==(const PhiPolynomial&) const = default;
};

/// Factor on a beam's profile, by direction.
using BeamPattern = std::variant<std::monostate, Petals, Dots, PhiPolynomial>;

/// Share of the profile that is left under angles in radians, phi from 0 to 2 pi.
double pattern_share(const BeamPattern& pattern, double theta, double phi);

/// Mean of k over a period [NishitaSpots, eq. 10]: (1 + q) / 2, or 1 / (2 (1 - q)) below q = 0.
double mean_of_k(double q);

/// HSV(phi / 360 degrees, 1, 1) as linear colour; phi in radians, 0 to 2 pi.
Rgb hue_color(double phi);

/// A spotlight without extent.
struct Spotlight {
    Vec3 position{0};       ///< mm
    Vec3 aim{0, 0, -1};     ///< a point on the axis, mm
    double half_angle = 20; ///< degrees from the axis to the rim
    BeamProfile profile{};  ///< over theta, and phi if it is a table; 0 beyond the rim
    Rgb intensity{1000};    ///< cd for a profile of 1, colour included
    Vec3 reference{1, 0,
                   0}; ///< direction of phi = 0, of any length; its part along the axis is dropped
    double spin = 0;   ///< degrees added to phi
    /// Degrees, of an elliptic beam: from the axis to the rim under phi = 90 degrees, while
    /// half_angle is that under 0; both below 90.
    std::optional<double> half_angle_across{};
    BeamPattern pattern{}; ///< none by default
    bool hue = false;      ///< the colour goes around the circle of hues with phi
    bool shaft = true;     ///< it lights the medium
};

/// Unit vector along the beam; NaN, which lights nothing, if aim and position coincide.
inline Vec3 beam_axis(const Spotlight& light) {
    const Vec3 axis = light.aim - light.position;
    return axis / axis.length();
}

/// Intensity of a spotlight, prepared for many directions; keeps a reference to it.
class BeamIntensity {
public:
    /// Intensity of a spotlight, which must outlive it.
    explicit BeamIntensity(const Spotlight& light);

    /// cd towards a point in mm; 0 at the lamp itself.
    Rgb operator()(const Vec3& point) const;
    /// cd in a direction of the lamp's own frame.
    Rgb towards(const BeamDirection& direction) const;
    /// Axis of the lamp and the direction of phi = 0.
    const BeamFrame& frame() const { return frame_; }
    /// Versine of the half angle at an angle phi in radians, without spin: 0 to 2.
    double rim(double phi) const;

private:
    const Spotlight& light_;
    BeamFrame frame_;
    double rim_;
};

/// Intensity in cd towards a point in mm; 0 at the lamp itself.
Rgb intensity_towards(const Spotlight& light, const Vec3& point);

} // namespace keiko
