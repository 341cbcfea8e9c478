#pragma once

#include "keiko/base/export.h"
#include "keiko/film/film.h"

#include <optional>

namespace KEIKO_API keiko {

/// Exposure and curve by which luminance becomes a picture (docs/theory/tone-mapping.md). Linear by
/// default: a local or curved mapping would hide what stripes are judged by.
struct ToneMapping {
    /// Curve from luminance to display values.
    enum class Curve {
        linear,      ///< proportional to luminance
        logarithmic, ///< proportional to its logarithm
        reinhard     ///< compresses what is bright [Reinhard2002]
    };
    Curve curve = Curve::linear; ///< that is used
    std::optional<double> ev;    ///< exposure value EV100; none: white is the picture's own
    double white = 4;            ///< Reinhard: multiple of the exposure that becomes white
};

/// sRGB transfer function [IEC61966-2-1] of a linear value, clamped to [0, 1].
double srgb_oetf(double linear);

/// Linear value of one encoded by srgb_oetf(), its inverse; of a negative value 0.
double srgb_eotf(double encoded);

/// Derivative of srgb_oetf() by the linear value, to its left from 1 on: 0.44 at 1, 12.92 near 0.
double srgb_slope(double linear);

/// Luminance in cd/m2 that an exposure of `ev` shows as 1: 1.2 * 2^EV (saturation of a camera at
/// ISO 100 [ISO12232]).
double saturation_luminance(double ev);

/// Value of x = L / white luminance under the curve x (1 + x / w^2) / (1 + x) [Reinhard2002, eq.
/// 4].
double reinhard(double x, double white);

/// Value of x = L / white luminance under a logarithmic curve log(1 + 100 x) / log 101, which lifts
/// what is dark; 1 stays 1.
double logarithmic(double x);

/// Automatic exposure: the 99 % quantile in cd/m2 of the luminance of the covered pixels (alpha
/// at least 1/2; all pixels if none is); 1 where that is not positive.
double white_luminance(const Film& film);

/// sRGB encoded picture with values in [0, 1]: 3 channels, or 4 with the film's alpha (1
/// where it has none). Colours
/// keep their ratio under curves. Values that are no numbers become black.
Image tone_mapped(const Film& film, const ToneMapping& mapping = {}, bool with_alpha = false);

} // namespace keiko
