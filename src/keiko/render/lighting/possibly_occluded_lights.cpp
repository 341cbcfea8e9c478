#include "keiko/render/lighting/possibly_occluded_lights.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace keiko {
namespace {

bool is_whole(const LightVisibility& seen) {
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

/// Of shading points whose hull holds those of the rectangle, if they lie in a plane and are seen
/// without curved mirrors; else nearly.
struct Outline {
    std::vector<Vec3> places;
    std::optional<Vec3> facing;

    Outline(const ShadingGrid& grid, const Rectangle& r) {
        const auto add = [&](const Pixel& p) {
            places.push_back(grid.at(p.x, p.y)->place.position);
        };
        places.reserve(9);
        for (const Pixel& p : r.corners()) add(p);
        for (const Pixel& p : r.middles()) add(p);
        facing = plane_of(places, grid.at(r.x0, r.y0)->place.normal);
        if (facing) places.resize(r.corners().size());
    }
};

} // namespace

Lights classify_prisms(const LightSamples& found, const Rectangle& r, const Lights& lights) {
    const auto corners = r.corners();
    const auto middles = r.middles();
    Lights whole;
    for (const std::size_t light : lights) {
        const auto sees = [&](const Pixel& p) { return is_whole(found.seen(p.x, p.y, light)); };
        if (std::all_of(corners.begin(), corners.end(), sees) &&
            std::all_of(middles.begin(), middles.end(), sees))
            whole.push_back(light);
    }
    return whole;
}

Lights possibly_occluded_lights(const Integrator& integrator, const ShadingGrid& grid,
                                const Rectangle& r, const Lights& lights) {
    if (lights.empty()) return {};
    const Outline outline(grid, r);
    Lights threatened;
    for (const std::size_t light : lights)
        if (integrator.may_occlude(outline.places, integrator.lights()[light], outline.facing))
            threatened.push_back(light);
    return threatened;
}

} // namespace keiko
