#pragma once

#include "keiko/base/error.h"
#include "keiko/inspect/model_facts.h"

#include <nlohmann/json.hpp>

#include <concepts>
#include <utility>

namespace keiko {

/// JSON that keeps its keys in the order in which they were set.
using Json = nlohmann::ordered_json;

/// Text of JSON. Names come from CAD files in any encoding: bytes that are not UTF-8 are replaced
/// and never cause an exception.
std::string text_of(const Json& json);

/// Error for a value that is not a whole number of the required kind; names its key unless that is
/// empty.
Error not_whole(const Json& json, const char* kind, const std::string& key = "");

/// [x, y, z]
Json point(const Vec3& p);
/// Inverse of point. Throws Json::exception.
Vec3 point_from(const Json& json);

/// A number, or a word for one that JSON does not have: "inf", "-inf", "nan".
Json real_json(double value);
/// Inverse of real_json. Throws Json::exception, and Error for another word.
double real_from(const Json& json);

/// A whole number from 0 to the largest Count. Throws Error for all other values: the library
/// itself would cut 1.5, wrap -1, and leave 1e300 undefined.
template <std::integral Count>
Count count_from(const Json& json, const std::string& key = "") {
    const auto* count = json.get_ptr<const Json::number_unsigned_t*>();
    if (!count || !std::in_range<Count>(*count)) throw not_whole(json, "count", key);
    return static_cast<Count>(*count);
}
/// Count at a key, which the Error names.
template <std::integral Count>
Count count_at(const Json& object, const std::string& key) {
    return count_from<Count>(object.at(key), key);
}
/// Integer at a key, which may be negative.
inline int int_at(const Json& object, const std::string& key) {
    const Json& json = object.at(key);
    const auto* number =
        json.get_ptr<const Json::number_integer_t*>(); // holds for unsigned ones, too
    if (!number || !std::in_range<int>(*number)) throw not_whole(json, "whole number", key);
    return static_cast<int>(*number);
}

/// [{severity, entity, message}]
Json diagnostics_json(const Diagnostics& diagnostics);

/// The keys of facts_json except `format` and `face_list`.
Json model_json(const ModelFacts& facts);

} // namespace keiko
