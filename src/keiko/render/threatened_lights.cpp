#include "keiko/render/threatened_lights.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace keiko {
namespace {

bool is_whole(const SeenLight& seen) {
    return seen.share == 1 && seen.cap == 1 && seen.axis == IntervalSet::whole();
}

/// The normal of the plane that places lie in, which is that at the first; nothing where they do
/// not lie in one.
std::optional<Vec3> plane_of(std::span<const Vec3> places, const Vec3& normal) {
    constexpr double flat = 1e-9;
    for (const Vec3& place : places)
        if (std::abs(normal.dot(place - places[0])) > flat * (place - places[0]).length())
            return std::nullopt;
    return normal;
}

} // namespace

Lights threatened_lights(const Integrator& integrator, const SpotGrid& grid,
                         const GridLights& found, const Rectangle& r, const Lights& lights) {
    std::vector<Pixel> pixels;
    for (const Pixel& p : r.corners()) pixels.push_back(p);
    for (const Pixel& p : r.middles()) pixels.push_back(p);
    std::vector<Vec3> places;
    for (const Pixel& p : pixels) places.push_back(grid.at(p.x, p.y)->place.position);
    const auto facing = plane_of(places, grid.at(r.x0, r.y0)->place.normal);
    Lights threatened;
    for (const std::size_t light : lights) {
        const auto whole = [&](const Pixel& p) { return is_whole(found.seen(p.x, p.y, light)); };
        if (std::all_of(pixels.begin(), pixels.end(), whole) &&
            integrator.may_come_between(places, integrator.lights()[light], facing))
            threatened.push_back(light);
    }
    return threatened;
}

} // namespace keiko
