#pragma once

#include "keiko/base/export.h"
#include "keiko/base/memory.h"
#include "keiko/math/rgb.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

/// Pixels in rows from the top, channels interleaved.
struct Image {
    int width = 0, height = 0, channels = 0; ///< pixels, and numbers a pixel
    /// Row by row from the top, channel by channel in a pixel.
    std::vector<float, ZeroedAllocator<float>> values;

    Image() = default;
    /// Black.
    Image(int w, int h, int c)
        : width(w),
          height(h),
          channels(c),
          values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) *
                 static_cast<std::size_t>(c)) {}
    /// Image of w x h pixels of c channels, all of one value.
    Image(int w, int h, int c, float fill) : Image(w, h, c) {
        std::fill(values.begin(), values.end(), fill);
    }

    /// The channels of a pixel, from the upper left.
    float* pixel(int x, int y) { return values.data() + offset(x, y); }
    /// The channels of a pixel, from the upper left.
    const float* pixel(int x, int y) const { return values.data() + offset(x, y); }

private:
    std::size_t offset(int x, int y) const {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(channels);
    }
};

/// Layer that a picture can hold beside its colour, of each pixel's first hit; no hit: 0, ids -1,
/// depth infinity. Illuminance is what `keiko illuminance` reports of the place: the direct light
/// in lx, in the mean over the pixel like luminance. Curvatures, 1/mm and 1/mm2, are positive where
/// the surface bends towards the normal that the layer `normal` has; no number where rounding
/// leaves none, as beside poles.
enum class Aov {
    luminance,   ///< cd/m2, the colour in one channel
    normal,      ///< unit, as Hit::normal
    uv,          ///< patch parameters, 0 to 1
    face,        ///< index of the face in the model
    patch,       ///< index of the patch in the model
    depth,       ///< mm along the camera ray
    c_plane_uv,  ///< mm on the C-plane that the reflected ray meets
    illuminance, ///< lx, direct
    curvature    ///< 1/mm and 1/mm2
};

/// All of them, in the order of their declaration.
const std::vector<Aov>& every_aov();

/// Name as used on the command line ("c_plane_uv") and its channel names ("u", "v").
std::string_view name_of(Aov aov);
/// Names of an AOV's channels in files: "X", "Y", "Z" of a normal.
std::vector<std::string> channel_names(Aov aov);
/// Throws Error for a name that is no AOV, listing those there are.
Aov aov_by_name(std::string_view name);

/// A rendered picture: linear colour in cd/m2, its coverage, and AOVs.
struct Film {
    Image color;               ///< 3 channels
    Image alpha;               ///< 1 channel, share of the pixel that shows the model
    std::map<Aov, Image> aovs; ///< those that were requested
};

} // namespace keiko
