#include "keiko/render/lighting/light_samples.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace keiko {

LightSamples::LightSamples(const Integrator& integrator, const ShadingGrid& grid)
    : integrator_(integrator), grid_(grid), spots_(grid.size(), &memory_) {}

LightSamples::Spot& LightSamples::point(int x, int y) {
    Spot& point = spots_[grid_.index(x, y)];
    if (point.empty()) point.resize(integrator_.lights().size());
    return point;
}

template <class Keep>
void LightSamples::ask_for(std::span<const std::size_t> lights, const Keep& keep) {
    asked_.clear(), asked_lamps_.clear();
    for (const std::size_t light : lights) {
        if (!keep(light)) continue;
        asked_.push_back(light);
        asked_lamps_.push_back(integrator_.lights()[light]);
    }
}

void LightSamples::find(int x, int y, std::span<const std::size_t> lights) {
    if (lights.empty()) return;
    ask_for(lights, [&here = point(x, y)](std::size_t i) { return !here[i].is_seen; });
    look(x, y);
    light_up(x, y, lights);
}

void LightSamples::find_for_sure(int x, int y, std::span<const std::size_t> lights) {
    if (lights.empty()) return;
    ask_for(lights, [&here = point(x, y)](std::size_t i) { return !here[i].is_sure; });
    look(x, y);
    light_up(x, y, lights);
}

void LightSamples::look(int x, int y) {
    if (asked_.empty()) return;
    std::vector<LightVisibility> seen = integrator_.light_visibility(*grid_.at(x, y), asked_lamps_);
    Spot& here = point(x, y);
    for (std::size_t i = 0; i < asked_.size(); ++i)
        here[asked_[i]] = {true, true, false, std::move(seen[i]), {}};
}

void LightSamples::light_up(int x, int y, std::span<const std::size_t> lights) {
    Spot& here = point(x, y);
    ask_for(lights, [&](std::size_t i) { return !here[i].is_lit; });
    if (asked_.empty()) return;
    std::vector<LightVisibility> seen;
    seen.reserve(asked_.size());
    for (const std::size_t light : asked_) seen.push_back(here[light].seen);
    const std::vector<DirectLight> brought =
        integrator_.direct_light(*grid_.at(x, y), asked_lamps_, std::move(seen));
    for (std::size_t i = 0; i < asked_.size(); ++i) {
        here[asked_[i]].light = brought[i];
        here[asked_[i]].is_lit = true;
    }
}

void LightSamples::take(int x, int y, std::size_t light, const LightVisibility& seen) {
    point(x, y)[light] = {true, false, false, seen, {}};
}

DirectLight LightSamples::sum(int x, int y, std::span<const std::size_t> lights) const {
    DirectLight sum;
    for (const std::size_t number : lights) sum += light(x, y, number);
    return sum;
}

DirectLight LightSamples::if_seen(int x, int y, std::size_t light,
                                  const LightVisibility& seen) const {
    const LightId asked = integrator_.lights()[light];
    return integrator_.direct_light(*grid_.at(x, y), {&asked, 1}, {seen})[0];
}

std::optional<LightVisibility> seen_between_corners(const LightSamples& lights,
                                                    const ShadingGrid& grid,
                                                    const LinearlySeen& linear, const Pixel& p) {
    const auto [a, b, c, d] = linear.between.corners();
    const auto at = [&](const Pixel& corner) {
        return lights.seen(corner.x, corner.y, linear.light);
    };
    const Vec2 share = grid.share(linear.between, p);
    const auto upper = between(at(a), at(b), share.x), lower = between(at(c), at(d), share.x);
    return upper && lower ? between(*upper, *lower, share.y) : std::nullopt;
}

void find(const UnresolvedLights& open, const ShadingGrid& grid, const Pixel& p,
          LightSamples& lights) {
    lights.find_for_sure(p.x, p.y, open.seen);
    for (const LinearlySeen& linear : open.linearly_seen) {
        if (!holds(open.lit, linear.light) || lights.is_seen(p.x, p.y, linear.light)) continue;
        if (const auto seen = seen_between_corners(lights, grid, linear, p))
            lights.take(p.x, p.y, linear.light, *seen);
    }
    lights.find(p.x, p.y, open.lit);
}

namespace {

bool is_whole(const LightVisibility& seen) {
    return seen.share == 1 && seen.cap == 1 && seen.axis == IntervalSet::whole();
}

/// The normal of the plane of places, which is that at the first; nullopt if they do not lie in one
/// plane.
std::optional<Vec3> plane_of(std::span<const Vec3> places, const Vec3& normal) {
    constexpr double flat = 1e-9;
    for (const Vec3& place : places)
        if (std::abs(normal.dot(place - places[0])) > flat * (place - places[0]).length())
            return std::nullopt;
    return normal;
}

/// Outline of shading points whose hull contains those of the rectangle, if they lie in a plane and
/// are viewed without curved mirrors; otherwise nearly.
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

Lights fully_visible_lights(const LightSamples& found, const Rectangle& r, const Lights& lights) {
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
