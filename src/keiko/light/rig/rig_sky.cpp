#include "keiko/light/rig/rig_sky.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Share of a pixel in which a linear function is positive, from its value at the centre and its
/// changes from side to side: the pixel is a unit square.
double positive_share(double centre, double across, double up) {
    const double wide = std::max(std::abs(across), std::abs(up));
    const double narrow = std::min(std::abs(across), std::abs(up));
    const double off = std::abs(centre), reach = (wide + narrow) / 2;
    const double beyond = off >= reach ? 0
                          : off <= reach - narrow
                              ? 0.5 - off / wide
                              : (reach - off) * (reach - off) / (2 * wide * narrow);
    return centre > 0 ? 1 - beyond : beyond;
}

} // namespace

RigSky::RigSky(const LightRig& rig) {
    for (const LightSource& source : rig.sources)
        if (const auto* sky = std::get_if<SkyLight>(&source)) sky_ = *sky;
    if (!sky_) return;
    for (const Window& window : sky_->windows)
        windows_.emplace_back(PolygonLight{window.corners, Rgb(1), true});
}

MirroredLight RigSky::beyond(const Vec3& origin, const Vec3& direction,
                             const std::optional<RayDifferentials>& spread) const {
    if (!sky_) return {};
    if (windows_.empty()) return {luminance(direction, spread), 1};
    double hidden = 1; // by the walls around all windows
    for (const PanelOutline& window : windows_)
        if (const auto hit = area_hit(window, origin, direction, spread))
            hidden *= 1 - hit->coverage;
    return {luminance(direction, spread) * (1 - hidden), 1 - hidden};
}

Rgb RigSky::luminance(const Vec3& direction, const std::optional<RayDifferentials>& spread) const {
    const double across = spread ? spread->direction_dx.z : 0;
    const double up = spread ? spread->direction_dy.z : 0;
    const double above = positive_share(direction.z, across, up);
    return sky_->luminance * (SkyDistribution(*sky_)(direction.normalized()) * above) +
           sky_->ground * (1 - above);
}

} // namespace keiko
