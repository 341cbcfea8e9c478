#include "keiko/render/lighting/light_samples.h"

#include <numeric>

namespace keiko {
LightSamples::LightSamples(const Integrator& integrator, const ShadingGrid& grid)
    : integrator_(integrator),
      grid_(grid),
      numbers_(integrator.lights().size()),
      spots_(grid.size(), &memory_) {
    std::iota(numbers_.begin(), numbers_.end(), std::size_t{0});
}

LightSamples::Spot& LightSamples::point(int x, int y) {
    Spot& point = spots_[grid_.index(x, y)];
    if (point.empty()) point.resize(numbers_.size());
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

} // namespace keiko
