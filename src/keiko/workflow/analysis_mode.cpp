#include "keiko/workflow/analysis_mode.h"

#include <algorithm>
#include <array>

namespace keiko {
namespace {

struct ModeName {
    AnalysisMode mode;
    std::string_view name;
};

constexpr std::array names{ModeName{AnalysisMode::zebra, "zebra"},
                           ModeName{AnalysisMode::isophote, "isophote"},
                           ModeName{AnalysisMode::highlight, "highlight"},
                           ModeName{AnalysisMode::draft, "draft"},
                           ModeName{AnalysisMode::gauss, "curvature:gauss"},
                           ModeName{AnalysisMode::mean, "curvature:mean"},
                           ModeName{AnalysisMode::k1, "curvature:k1"},
                           ModeName{AnalysisMode::k2, "curvature:k2"},
                           ModeName{AnalysisMode::absolute, "curvature:absolute"},
                           ModeName{AnalysisMode::section, "curvature:section"},
                           ModeName{AnalysisMode::radius, "radius"},
                           ModeName{AnalysisMode::below_radius, "below-radius"},
                           ModeName{AnalysisMode::isoparms, "isoparms"},
                           ModeName{AnalysisMode::patches, "patches"}};

} // namespace

std::string_view name_of(AnalysisMode look) {
    return std::find_if(names.begin(), names.end(),
                        [&](const ModeName& n) { return n.mode == look; })
        ->name;
}

const std::vector<AnalysisMode>& every_look() {
    static const std::vector<AnalysisMode> all = [] {
        std::vector<AnalysisMode> modes;
        for (const ModeName& known : names) modes.push_back(known.mode);
        return modes;
    }();
    return all;
}

bool is_curvature(AnalysisMode look) {
    return name_of(look).starts_with("curvature:");
}

bool has_scale(AnalysisMode look) {
    return is_curvature(look) || look == AnalysisMode::draft || look == AnalysisMode::radius;
}

} // namespace keiko
