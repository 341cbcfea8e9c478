#include "keiko/render/shared_light.h"

#include <algorithm>
#include <utility>

namespace keiko {
namespace {

/// Those of `spots` that show one smooth surface with its first, which are taken off them.
std::vector<LitSpot> surface_of_first(std::vector<LitSpot>& spots) {
    std::vector<LitSpot> surface{spots[0]}, rest(spots.begin() + 1, spots.end());
    for (std::size_t i = 0; i < surface.size(); ++i) {
        const SurfacePlace place = surface[i].place;
        const auto joins = [&](const LitSpot& spot) { return continues(place, spot.place); };
        const auto others = std::stable_partition(rest.begin(), rest.end(), joins);
        surface.insert(surface.end(), rest.begin(), others);
        rest.erase(rest.begin(), others);
    }
    spots = std::move(rest);
    return surface;
}

/// The spot nearest to the mean place of all, by their shares.
const LitSpot& amid(const std::vector<LitSpot>& surface, const std::vector<PixelPart>& parts) {
    Vec3 sum(0);
    double shares = 0;
    for (const LitSpot& spot : surface) {
        sum += spot.place.position * parts[spot.sample].share;
        shares += parts[spot.sample].share;
    }
    const Vec3 mean = sum / shares;
    const auto off = [&](const LitSpot& spot) { return (spot.place.position - mean).length2(); };
    return *std::min_element(surface.begin(), surface.end(),
                             [&](const auto& a, const auto& b) { return off(a) < off(b); });
}

} // namespace

void add_shared_light(const Integrator& integrator, RefinedPixels& refined) {
    std::vector<LitSpot>& spots = refined.spots;
    const auto group = [&](const LitSpot& spot) {
        return std::pair(refined.parts[spot.sample].pixel, spot.depth);
    };
    std::stable_sort(spots.begin(), spots.end(), [&](const LitSpot& a, const LitSpot& b) {
        return std::pair(group(a), a.sample) < std::pair(group(b), b.sample);
    });
    for (auto begin = spots.begin(); begin != spots.end();) {
        const auto end = std::find_if(
            begin, spots.end(), [&](const LitSpot& spot) { return group(spot) != group(*begin); });
        std::vector<LitSpot> of_pixel(begin, end);
        while (!of_pixel.empty()) {
            const std::vector<LitSpot> surface = surface_of_first(of_pixel);
            const SpotLight light = integrator.light_on(amid(surface, refined.parts));
            for (const LitSpot& spot : surface)
                integrator.add_light(spot, light, refined.parts[spot.sample].sample);
        }
        begin = end;
    }
}

} // namespace keiko
