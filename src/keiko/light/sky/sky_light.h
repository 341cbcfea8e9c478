#pragma once

#include "keiko/base/export.h"
#include "keiko/light/fog/window_beam.h"
#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"

#include <vector>

namespace KEIKO_API keiko {

/// Distributions of luminance over the sky (docs/theory/sky.md#luminance).
enum class SkyModel {
    uniform,  ///< alike in all directions
    overcast, ///< of the CIE [MoonSpencer1942]: three times as bright at the zenith as below
    gradient, ///< linear in the sine of the elevation
    clear     ///< of the CIE, around the sun [Kittler1967]
};

/// The sky above a level horizon and the ground below it, both at infinity. The z axis points up.
struct SkyLight {
    SkyModel model = SkyModel::overcast; ///< distribution of the luminance
    Rgb luminance{10000};                ///< cd/m2 at the zenith, colour included
    /// Luminance at the horizon of a gradient, as a share of that at the zenith, 0 or more.
    double horizon = 1;
    Vec3 sun{0, 0, 1}; ///< direction towards the sun, above the horizon: of a clear sky
    Rgb ground{0};     ///< cd/m2 of the ground below the horizon, the same in all directions
    std::vector<Window> windows{}; ///< openings that show it; empty: nothing but bodies hides it

    bool operator==(const SkyLight&) const = default;
};

/// Luminance of a sky by direction, as a share of that at the zenith.
class SkyDistribution {
public:
    /// Reads the model, the horizon and the sun of a sky.
    explicit SkyDistribution(const SkyLight& sky);

    /// Share in a unit direction. One below the horizon has that of the horizon.
    double operator()(const Vec3& towards) const;
    /// True if the share is level() + rise() times the sine of the elevation.
    bool is_linear() const { return model_ != SkyModel::clear; }
    /// Share at the horizon, of a linear distribution.
    double level() const { return level_; }
    /// Difference of the shares at zenith and horizon, of a linear distribution.
    double rise() const { return 1 - level_; }
    /// Unit vector towards the sun, around which a clear sky is brightest.
    const Vec3& sun() const { return sun_; }

private:
    SkyModel model_;
    double level_;
    Vec3 sun_;
    double scale_; ///< 1 over the clear sky's product at the zenith
};

} // namespace keiko
