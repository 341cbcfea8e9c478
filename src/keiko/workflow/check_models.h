#pragma once

#include "keiko/files/scene/preset_file.h"
#include "keiko/import/worker/load_model.h"
#include "keiko/inspect/inspection.h"
#include "keiko/scene/criteria_preset.h"
#include "keiko/workflow/body_combs.h"

#include <filesystem>
#include <optional>
#include <span>

namespace keiko {

struct CheckOptions {
    LoadOptions load;
    CriteriaPreset preset = standard_presets().front();
    double join = 0.5; ///< mm
    CombOptions combs{};
};

/// Result of a check.
struct CheckResult {
    Inspection inspection;
    std::optional<Combs> combs{}; ///< if any were requested
};

/// Reads models, which together form one body, or one scene file (.toml), and judges their geometry
/// by criteria, without lamps or pictures. Throws Error for input that cannot be read.
CheckResult check_models(std::span<const std::filesystem::path> inputs,
                         const CheckOptions& options = {}, const Job& job = {});

} // namespace keiko
