#pragma once

#include "keiko/base/error.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace keiko {

/// How two normal curvatures across a seam are compared; both printed beside their value.
enum class CurvatureFormula {
    alias, ///< |R1 - R2| / (R1 + R2), 100 % where the sides bend opposite ways
    catia  ///< |C1 - C2| / max(|C1|, |C2|), up to 200 % where they bend opposite ways
};

struct CurvatureLimit {
    CurvatureFormula formula = CurvatureFormula::alias;
    double limit = 0.1; ///< share of 1
};

/// What a surface is held to. Limits are practice, not a standard; `source` says whose.
struct CriteriaPreset {
    std::string name = "class-a-outer";
    std::string source = "class A as quoted in trade forums; practice, not a standard";
    double gap = 0.01;                                          ///< mm, G0
    double angle = 0.1;                                         ///< degrees, G1
    std::optional<CurvatureLimit> curvature = CurvatureLimit{}; ///< G2; nothing: not judged
    double feature_angle = 5;            ///< degrees; a seam with more is a crease, no finding
    double flat_radius = 50000;          ///< mm; where both radii exceed it ...
    double flat_curvature_change = 2e-6; ///< 1/mm ... the curvatures may differ by this
};

/// The presets that come with Keiko.
inline std::span<const CriteriaPreset> built_in_presets() {
    using enum CurvatureFormula;
    static const std::array<CriteriaPreset, 6> presets{
        CriteriaPreset{},
        CriteriaPreset{"class-a-strict", "CATIA Connect Checker defaults; practice, not a standard",
                       0.001, 0.01, CurvatureLimit{catia, 0.02}},
        CriteriaPreset{"class-b", "class B as quoted in trade forums; practice, not a standard",
                       0.02, 0.2, std::nullopt},
        CriteriaPreset{"engineering", "class C as quoted in trade forums; practice, not a standard",
                       0.05, 0.5, std::nullopt},
        CriteriaPreset{"vda-4955", "defaults printed for VDA 4955 in Creo ModelCHECK", 0.02, 0.1,
                       CurvatureLimit{alias, 0.1}},
        CriteriaPreset{"supplier-nissan", "CADdoctor settings for a supplier", 0.01, 3,
                       std::nullopt}};
    return presets;
}

/// Throws Error for a name that no built-in preset has, listing those there are.
inline const CriteriaPreset& preset_by_name(std::string_view name) {
    std::string known;
    for (const CriteriaPreset& preset : built_in_presets()) {
        if (preset.name == name) return preset;
        known += (known.empty() ? "" : ", ") + preset.name;
    }
    throw Error("", "", "unknown preset '" + std::string(name) + "'; there are " + known);
}

} // namespace keiko
