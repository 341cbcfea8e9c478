#include "keiko/light/rig/multiple_scattering.h"

#include "keiko/light/fog/transmittance.h"
#include "keiko/light/spotlight/point_light.h"

#include <algorithm>

namespace keiko {
namespace {

/// Optical depth from a source to a place; nothing of one that does not light the medium.
struct DepthTo {
    const Medium& medium;
    const Vec3& place;

    std::optional<Rgb> operator()(const CPlane&) const { return std::nullopt; }
    template <PointLight Light>
    std::optional<Rgb> operator()(const Light& light) const {
        if (!light.shaft) return std::nullopt;
        return optical_depth(medium, {light.position, place});
    }
    std::optional<Rgb> operator()(const Sun& sun) const {
        if (!sun.shaft || sun.windows.empty()) return std::nullopt;
        return Rgb(0);
    }
};

} // namespace

double scatterings_by_way_of(const LightRig& rig, const Vec3& place, const Vec3& eye) {
    double most = 0;
    if (!rig.medium) return most;
    const Rgb to_eye = optical_depth(*rig.medium, {place, eye});
    for (const LightSource& source : rig.sources)
        if (const auto depth = std::visit(DepthTo{*rig.medium, place}, source))
            most = std::max(most, max_channel((*depth + to_eye) * rig.medium->albedo));
    return most;
}

} // namespace keiko
