#pragma once

#include "keiko/base/export.h"
#include "keiko/import/worker/load_model.h"
#include "keiko/inspect/model_facts.h"

#include <filesystem>

namespace KEIKO_API keiko {

/// Options of model_info.
struct FactsOptions {
    LoadOptions load;     ///< of the model file
    double join = 0.5;    ///< mm, within which two borders count as a seam
    bool tracing = false; ///< builds the tracer too, and reports its statistics
};

/// Reads a model file and summarises it.
ModelFacts model_info(const std::filesystem::path& file, const FactsOptions& options = {},
                      const Job& job = {});

} // namespace keiko
