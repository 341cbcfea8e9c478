#include "keiko/workflow/analysis_mode.h"

#include "keiko/base/error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

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
                           ModeName{AnalysisMode::distortion, "distortion"},
                           ModeName{AnalysisMode::isoparms, "isoparms"},
                           ModeName{AnalysisMode::patches, "patches"}};

AnalysisMode mode_by_name(const std::string& name) {
    std::vector<std::string> known{"lamps"};
    for (const AnalysisMode mode : every_look()) {
        if (name_of(mode) == name) return mode;
        known.emplace_back(name_of(mode));
    }
    throw FieldError("look", "no look is called '" + name + "'; there are " + comma_list(known) +
                                 did_you_mean(name, known));
}

double full_curvature(AnalysisMode mode, const std::string& text) {
    double full = 0;
    const char* end = text.data() + text.size();
    const auto [rest, fault] = std::from_chars(text.data(), end, full);
    if (!is_curvature(mode) || fault != std::errc() || rest != end || !(full > 0) ||
        !std::isfinite(full))
        throw FieldError("look", "'" + std::string(name_of(mode)) + "=" + text +
                                     "' is not curvature:KIND=C with the curvature C > 0 of full "
                                     "colour");
    return full;
}

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

StatedLook look_from(const std::string& text) {
    const std::size_t sign = std::min(text.find('='), text.size());
    StatedLook look{mode_by_name(text.substr(0, sign))};
    if (sign < text.size()) look.full = full_curvature(look.mode, text.substr(sign + 1));
    return look;
}

bool is_curvature(AnalysisMode look) {
    return name_of(look).starts_with("curvature:");
}

bool has_scale(AnalysisMode look) {
    return is_curvature(look) || look == AnalysisMode::draft || look == AnalysisMode::radius ||
           look == AnalysisMode::distortion;
}

} // namespace keiko
