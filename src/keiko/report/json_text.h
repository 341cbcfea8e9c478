#pragma once

#include "keiko/inspect/model_facts.h"

#include <nlohmann/json.hpp>

namespace keiko {

/// Keeps its keys in the order in which they were set.
using Json = nlohmann::ordered_json;

/// Names come from CAD files in any encoding: what is no UTF-8 is replaced, never thrown at.
std::string text_of(const Json& json);

/// [x, y, z]
Json point(const Vec3& p);

/// The keys of facts_json but for `format` and `face_list`.
Json model_json(const ModelFacts& facts);

} // namespace keiko
