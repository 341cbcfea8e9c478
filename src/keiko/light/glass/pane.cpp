#include "keiko/light/glass/pane.h"

#include "keiko/light/fog/transmittance.h"
#include "keiko/light/luminance/fresnel.h"

#include <cmath>

namespace keiko {

PaneShares pane_shares(double cosine, double n, const Rgb& absorption, double thickness) {
    const double mirrored = fresnel_dielectric(cosine, n), entering = 1 - mirrored;
    if (entering == 0) return {Rgb(1), Rgb(0)};
    const double inner_cosine = std::sqrt(1 - (1 - cosine * cosine) / (n * n));
    const Rgb left = transmittance(absorption * (thickness / inner_cosine));
    PaneShares shares;
    const auto channel = [&](double crossing, double& back, double& through) {
        const double echo = mirrored * crossing;
        through = entering * entering * crossing / (1 - echo * echo);
        back = mirrored + through * echo;
    };
    channel(left.r, shares.mirrored.r, shares.passed.r);
    channel(left.g, shares.mirrored.g, shares.passed.g);
    channel(left.b, shares.mirrored.b, shares.passed.b);
    return shares;
}

} // namespace keiko
