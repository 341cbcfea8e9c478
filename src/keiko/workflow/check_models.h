#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/files/scene/preset_file.h"
#include "keiko/import/worker/load_model.h"
#include "keiko/inspect/combs/comb_curves.h"
#include "keiko/inspect/inspection.h"
#include "keiko/inspect/model_facts.h"
#include "keiko/inspect/seams/seam_profile.h"
#include "keiko/report/content/combs_text.h"
#include "keiko/report/content/profiles_text.h"
#include "keiko/scene/criteria_preset.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Curves with their curvature all along, prepared for files.
struct Combs {
    std::vector<CombCurve> curves;     ///< sections by plane, then iso-curves by face
    std::vector<std::string> remarks;  ///< on planes that miss the body, touch it or contain faces
    std::string json, csv;             ///< text of the two files
    std::vector<CombPicture> pictures; ///< one a plane, then one of the iso-curves
};

/// True if the options request any curve.
bool has_curves(const CombOptions& options);
/// The sections and iso-curves of a body.
Combs combs_of(const SurfaceModel& model, const CombOptions& options, const Job& job = {});

/// The profiles of stretches of an inspection of the body, indices into Inspection::seams.
std::vector<SeamProfile> profiles_of(const SurfaceModel& model, const Inspection& inspection,
                                     std::span<const std::uint32_t> seams, const Job& job = {});

/// Options of check_models.
struct CheckOptions {
    LoadOptions load;                                   ///< of the model files
    CriteriaPreset preset = standard_presets().front(); ///< limits of the criteria
    double join = 0.5;                                  ///< mm
    CombOptions combs{};          ///< sections and iso-curves; none unless requested
    bool profiles = false;        ///< of every stretch of a seam
    bool joints = false;          ///< of panels that stand apart, too
    AcceptanceList acceptances{}; ///< findings that have no part in the verdict
    Scope scope{};                ///< part of the body that is judged
};

/// Result of a check.
struct CheckResult {
    Inspection inspection;        ///< seams, faces and their verdicts
    std::optional<Combs> combs{}; ///< if any were requested
    /// By the stretches of the inspection; empty unless requested.
    std::vector<SeamProfile> profiles{};
};

/// Reads models, which together form one body, or one scene file (.toml), and judges their geometry
/// by criteria, without lamps or pictures. Throws Error for input that cannot be read.
CheckResult check_models(std::span<const std::filesystem::path> inputs,
                         const CheckOptions& options = {}, const Job& job = {});

/// Likewise for a body that has been read: without `load` of the options.
CheckResult check_body(const SurfaceModel& model, const CheckOptions& options = {},
                       const Job& job = {});

/// Options of model_info.
struct FactsOptions {
    LoadOptions load;     ///< of the model file; not of a body that has been read
    double join = 0.5;    ///< mm, within which two borders count as a seam
    bool tracing = false; ///< builds the tracer too, and reports its statistics
};

/// Summary of a body that has been read.
ModelFacts body_info(const SurfaceModel& model, const FactsOptions& options = {},
                     const Job& job = {});

/// Reads a model file and summarises it.
ModelFacts model_info(const std::filesystem::path& file, const FactsOptions& options = {},
                      const Job& job = {});

} // namespace keiko
