#pragma once

#include "keiko/import/worker/load_model.h"
#include "keiko/inspect/model_facts.h"

#include <filesystem>

namespace keiko {

struct FactsOptions {
    LoadOptions load;
    double join = 0.5;    ///< mm, within which two borders count as a seam
    bool tracing = false; ///< builds the tracer too, and reports its statistics
};

/// Reads a model file and summarises it.
ModelFacts model_info(const std::filesystem::path& file, const FactsOptions& options = {},
                      const Job& job = {});

} // namespace keiko
