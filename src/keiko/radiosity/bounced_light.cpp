#include "keiko/radiosity/bounced_light.h"

#include "keiko/base/error.h"
#include "keiko/base/parallel.h"

#include <algorithm>
#include <utility>

namespace keiko {
namespace {

/// Faces in a piece of work.
constexpr std::size_t at_once = 256;

double power(std::span<const double> areas, std::span<const Rgb> radiosity) {
    Rgb sum;
    for (std::size_t i = 0; i < areas.size(); ++i) sum += radiosity[i] * areas[i];
    return max_channel(sum);
}

void sweep(const ElementRows& rows, std::span<const Rgb> radiosity, std::vector<Rgb>& arriving,
           const Job& job) {
    parallel_for((arriving.size() + at_once - 1) / at_once, job, "", [&](std::size_t piece) {
        const std::size_t end = std::min(arriving.size(), (piece + 1) * at_once);
        for (std::size_t face = piece * at_once; face < end; ++face)
            arriving[face] = rows.arriving(face, radiosity);
    });
}

} // namespace

BouncedLight bounced_light(const ElementRows& rows, std::span<const double> areas,
                           std::span<const Rgb> reflectances, std::vector<Rgb> exitance,
                           double allowed, const Job& job) {
    double most = 0;
    for (const Rgb& rho : reflectances) most = std::max(most, max_channel(rho));
    const double still = most / (1 - most); // what all later reflections bring, of the last one
    BouncedLight light;
    light.arriving.resize(areas.size());
    light.radiosity = exitance;
    std::vector<Rgb> next = light.radiosity, added = light.radiosity, arriving = light.arriving;
    double all = power(areas, added);
    light.remaining = all > 0 ? still : 0;
    try {
        while (light.remaining > allowed) {
            sweep(rows, light.radiosity, arriving, job);
            for (std::size_t i = 0; i < areas.size(); ++i) {
                next[i] = exitance[i] + reflectances[i] * arriving[i];
                added[i] = next[i] - light.radiosity[i];
            }
            std::swap(light.radiosity, next), light.arriving = arriving, ++light.sweeps;
            light.remaining = still * power(areas, added) / power(areas, light.radiosity);
        }
    } catch (const Cancelled&) { // keeps the last whole sweep
    }
    light.exitance = std::move(exitance);
    return light;
}

} // namespace keiko
