#pragma once

namespace keiko {

/// How good lamps on one plane are for a picture: the factors of the objective, each 0 to 1.
struct PlacementScore {
    double coverage = 0;    ///< share of the picture's weight that these lamps newly serve
    double stripes = 0;     ///< weighted mean over the faces of min(1, stripes on it / 5)
    double uniformity = 0;  ///< exp(-standard deviation of ln |grad v|): 1 for even stripes
    double in_range = 0;    ///< share of what is served whose stripe spacing is in the wanted range
    double crossing = 0;    ///< how squarely stripes cross features; 1 where there are none
    double compactness = 0; ///< 1 for lamps as small as what is seen, 0.5 at 8 times its size

    /// The product to make large. `crossing` has no part in it: it would cost coverage, see
    /// docs/decisions/0006-placement.md.
    double objective() const;
};

/// The stripes a picture should show, in pixels of a picture 540 high; scaled to others.
struct StripeSpacing {
    double least = 12, wanted = 24, most = 60;

    StripeSpacing for_height(int height) const {
        const double scale = height / 540.0;
        return {least * scale, wanted * scale, most * scale};
    }
};

} // namespace keiko
