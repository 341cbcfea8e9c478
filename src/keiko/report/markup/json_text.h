#pragma once

#include "keiko/base/error.h"
#include "keiko/inspect/model_facts.h"

#include <nlohmann/json.hpp>

#include <concepts>
#include <utility>

namespace keiko {

/// Keeps its keys in the order in which they were set.
using Json = nlohmann::ordered_json;

/// Names come from CAD files in any encoding: what is no UTF-8 is replaced, never thrown at.
std::string text_of(const Json& json);

/// Says what stands where a whole number of some kind should, and under which key if that is told.
Error not_whole(const Json& json, const char* kind, const std::string& key = "");

/// [x, y, z]
Json point(const Vec3& p);
/// What point made. Throws Json::exception.
Vec3 point_from(const Json& json);

/// A number, or a word for what JSON has no number: "inf", "-inf", "nan".
Json real_json(double value);
/// What real_json made. Throws Json::exception, and Error for another word.
double real_from(const Json& json);

/// A whole number from 0 to the largest Count. Throws Error for all else: the library itself would
/// cut 1.5, wrap -1, and leave 1e300 undefined.
template <std::integral Count>
Count count_from(const Json& json, const std::string& key = "") {
    const auto* count = json.get_ptr<const Json::number_unsigned_t*>();
    if (!count || !std::in_range<Count>(*count)) throw not_whole(json, "count", key);
    return static_cast<Count>(*count);
}
/// The same of the value of a key, which the Error names.
template <std::integral Count>
Count count_at(const Json& object, const std::string& key) {
    return count_from<Count>(object.at(key), key);
}
/// The same of one that may be negative.
inline int int_at(const Json& object, const std::string& key) {
    const Json& json = object.at(key);
    const auto* number = json.get_ptr<const Json::number_integer_t*>(); // of unsigned ones, too
    if (!number || !std::in_range<int>(*number)) throw not_whole(json, "whole number", key);
    return static_cast<int>(*number);
}

/// [{severity, entity, message}]
Json diagnostics_json(const Diagnostics& diagnostics);

/// The keys of facts_json but for `format` and `face_list`.
Json model_json(const ModelFacts& facts);

} // namespace keiko
