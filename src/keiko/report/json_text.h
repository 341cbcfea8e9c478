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
/// What point made. Throws Json::exception.
Vec3 point_from(const Json& json);

/// A number, or a word for what JSON has no number: "inf", "-inf", "nan".
Json real_json(double value);
/// What real_json made. Throws Json::exception, and std::exception for another word.
double real_from(const Json& json);

/// The keys of facts_json but for `format` and `face_list`.
Json model_json(const ModelFacts& facts);

} // namespace keiko
