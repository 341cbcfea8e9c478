#pragma once

#include "keiko/base/export.h"
#include "keiko/math/rgb.h"

#include <filesystem>

namespace KEIKO_API keiko {

/// A picture of the surroundings at infinity, which mirrors show and which lights by its low orders
/// (docs/theory/maps.md#environments). World z is up.
struct EnvironmentSpec {
    /// How directions lie in the picture.
    enum class Layout {
        lat_long, ///< columns by azimuth from +x anticlockwise, rows by the angle to the zenith
        cube      ///< six squares side by side or below each other: +x, -x, +y, -y, +z, -z
    };

    std::filesystem::path file{};     ///< picture, linear in .exr and .hdr, sRGB else
    Layout layout = Layout::lat_long; ///< of the picture
    Rgb luminance{1};                 ///< cd/m2 that the value 1 stands for
    double azimuth = 0;               ///< degrees by which it is turned about z, anticlockwise
    bool visible = true;              ///< whether the camera sees it too
    bool lights = true;               ///< whether it lights surfaces

    bool operator==(const EnvironmentSpec&) const = default;
};

} // namespace keiko
