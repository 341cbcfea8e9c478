#pragma once

#include "keiko/inspect/model_facts.h"

#include <string>

namespace keiko {

/// Summary of a model file for a terminal: one fact a line.
std::string facts_text(const ModelFacts& facts);

} // namespace keiko
