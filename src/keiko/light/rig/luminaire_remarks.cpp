#include "keiko/light/rig/luminaire_remarks.h"

#include "keiko/light/spotlight/luminous_flux.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <set>
#include <string>
#include <utility>

namespace keiko {

namespace {

constexpr double agreement = 0.01; ///< of the flux that the header states

std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", value);
    return text.data();
}

std::string percent(double share) {
    return number(100 * share) + " %";
}

Diagnostic contradiction(const std::string& file, const std::string& stated,
                         const std::string& found) {
    return {Severity::warning, file,
            "the header states " + stated + ", but its intensities add up to " + found};
}

} // namespace

Diagnostics flux_contradictions(const std::string& file, const PhotometricWeb& web) {
    const double flux = luminous_flux(web);
    const auto& [ratio, reference, downward] = web.stated;
    Diagnostics found;
    if (!(flux > 0)) return found;
    if (ratio && !(std::abs(flux - *ratio * reference) <= agreement * *ratio * reference))
        found.push_back(
            contradiction(file, "a light output ratio of " + percent(*ratio),
                          percent(flux / reference) + " of its " + number(reference) + " lm"));
    if (!ratio && web.lamp_flux > 0 && flux > (1 + agreement) * web.lamp_flux)
        found.push_back(
            contradiction(file, "lamps of " + number(web.lamp_flux) + " lm", number(flux) + " lm"));
    if (!downward) return found;
    const double share = downward_flux(web) / flux;
    if (!(std::abs(share - *downward) <= agreement))
        found.push_back(contradiction(file, "a downward flux fraction of " + percent(*downward),
                                      percent(share)));
    return found;
}

Diagnostics luminaire_remarks(const LightRig& rig) {
    Diagnostics remarks;
    std::set<std::string> files;
    for (const LightSource& source : rig.sources) {
        const auto* lamp = std::get_if<Luminaire>(&source);
        if (!lamp || !files.insert(lamp->file).second) continue;
        for (Diagnostic& remark : flux_contradictions(lamp->file, *lamp->web))
            remarks.push_back(std::move(remark));
    }
    return remarks;
}

} // namespace keiko
