#include "keiko/render/grid_lights.h"

#include <numeric>

namespace keiko {
namespace {

template <class Keep>
std::vector<std::size_t> those_that(std::span<const std::size_t> numbers, const Keep& keep) {
    std::vector<std::size_t> kept;
    for (const std::size_t number : numbers)
        if (keep(number)) kept.push_back(number);
    return kept;
}

} // namespace

GridLights::GridLights(const Integrator& integrator, const SpotGrid& grid)
    : integrator_(integrator),
      grid_(grid),
      numbers_(integrator.lights().size()),
      spots_(grid.size(), &memory_) {
    std::iota(numbers_.begin(), numbers_.end(), std::size_t{0});
}

GridLights::Spot& GridLights::spot(int x, int y) {
    Spot& spot = spots_[grid_.index(x, y)];
    if (spot.empty()) spot.resize(numbers_.size());
    return spot;
}

std::vector<RigLight> GridLights::lights_of(std::span<const std::size_t> numbers) const {
    std::vector<RigLight> lights;
    for (const std::size_t number : numbers) lights.push_back(integrator_.lights()[number]);
    return lights;
}

void GridLights::find(int x, int y, std::span<const std::size_t> lights) {
    Spot& here = spot(x, y);
    look(x, y, those_that(lights, [&](std::size_t i) { return !here[i].is_seen; }));
    light_up(x, y, lights);
}

void GridLights::find_for_sure(int x, int y, std::span<const std::size_t> lights) {
    Spot& here = spot(x, y);
    look(x, y, those_that(lights, [&](std::size_t i) { return !here[i].is_sure; }));
    light_up(x, y, lights);
}

void GridLights::look(int x, int y, std::span<const std::size_t> lights) {
    if (lights.empty()) return;
    const std::vector<SeenLight> seen = integrator_.seen_from(*grid_.at(x, y), lights_of(lights));
    Spot& here = spot(x, y);
    for (std::size_t i = 0; i < lights.size(); ++i)
        here[lights[i]] = {true, true, false, seen[i], {}};
}

void GridLights::light_up(int x, int y, std::span<const std::size_t> asked) {
    Spot& here = spot(x, y);
    const auto lights = those_that(asked, [&](std::size_t i) { return !here[i].is_lit; });
    if (lights.empty()) return;
    std::vector<SeenLight> seen;
    for (const std::size_t light : lights) seen.push_back(here[light].seen);
    const std::vector<SpotLight> brought =
        integrator_.light_on(*grid_.at(x, y), lights_of(lights), std::move(seen));
    for (std::size_t i = 0; i < lights.size(); ++i) {
        here[lights[i]].light = brought[i];
        here[lights[i]].is_lit = true;
    }
}

void GridLights::take(int x, int y, std::size_t light, const SeenLight& seen) {
    spot(x, y)[light] = {true, false, false, seen, {}};
}

SpotLight GridLights::sum(int x, int y, std::span<const std::size_t> lights) const {
    SpotLight sum;
    for (const std::size_t number : lights) sum += light(x, y, number);
    return sum;
}

SpotLight GridLights::if_seen(int x, int y, std::size_t light, const SeenLight& seen) const {
    const RigLight asked = integrator_.lights()[light];
    return integrator_.light_on(*grid_.at(x, y), {&asked, 1}, {seen})[0];
}

} // namespace keiko
