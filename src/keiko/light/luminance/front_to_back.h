#pragma once

#include "keiko/math/rgb.h"

namespace keiko {

/// Sum of layers one behind the other, accumulated from the front to the back: the operator over
/// [PorterDuff1984] (docs/theory/luminance.md#rows-behind-each-other).
struct FrontToBack {
    Rgb light;          ///< of the layers so far
    double opacity = 0; ///< of all of them, 0 to 1

    /// The next layer behind, with its own light and opacity.
    void add(const Rgb& own_light, double own_opacity) {
        const double share = (1 - opacity) * own_opacity;
        light += own_light * share;
        opacity += share;
    }
    /// Layers behind, already summed up.
    void add(const FrontToBack& behind) {
        light += behind.light * (1 - opacity);
        opacity += (1 - opacity) * behind.opacity;
    }
};

} // namespace keiko
