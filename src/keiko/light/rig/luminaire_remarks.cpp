#include "keiko/light/rig/luminaire_remarks.h"

#include "keiko/light/spotlight/stated_flux.h"

#include <set>
#include <string>
#include <utility>

namespace keiko {

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
