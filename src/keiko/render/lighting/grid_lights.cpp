#include "keiko/render/lighting/grid_lights.h"

#include <numeric>

namespace keiko {
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

template <class Keep>
void GridLights::ask_for(std::span<const std::size_t> lights, const Keep& keep) {
    asked_.clear(), asked_lamps_.clear();
    for (const std::size_t light : lights) {
        if (!keep(light)) continue;
        asked_.push_back(light);
        asked_lamps_.push_back(integrator_.lights()[light]);
    }
}

void GridLights::find(int x, int y, std::span<const std::size_t> lights) {
    if (lights.empty()) return;
    ask_for(lights, [&here = spot(x, y)](std::size_t i) { return !here[i].is_seen; });
    look(x, y);
    light_up(x, y, lights);
}

void GridLights::find_for_sure(int x, int y, std::span<const std::size_t> lights) {
    if (lights.empty()) return;
    ask_for(lights, [&here = spot(x, y)](std::size_t i) { return !here[i].is_sure; });
    look(x, y);
    light_up(x, y, lights);
}

void GridLights::look(int x, int y) {
    if (asked_.empty()) return;
    std::vector<SeenLight> seen = integrator_.seen_from(*grid_.at(x, y), asked_lamps_);
    Spot& here = spot(x, y);
    for (std::size_t i = 0; i < asked_.size(); ++i)
        here[asked_[i]] = {true, true, false, std::move(seen[i]), {}};
}

void GridLights::light_up(int x, int y, std::span<const std::size_t> lights) {
    Spot& here = spot(x, y);
    ask_for(lights, [&](std::size_t i) { return !here[i].is_lit; });
    if (asked_.empty()) return;
    std::vector<SeenLight> seen;
    seen.reserve(asked_.size());
    for (const std::size_t light : asked_) seen.push_back(here[light].seen);
    const std::vector<SpotLight> brought =
        integrator_.light_on(*grid_.at(x, y), asked_lamps_, std::move(seen));
    for (std::size_t i = 0; i < asked_.size(); ++i) {
        here[asked_[i]].light = brought[i];
        here[asked_[i]].is_lit = true;
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
