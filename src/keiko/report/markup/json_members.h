#pragma once

#include "keiko/report/markup/json_text.h"

#include <initializer_list>
#include <string>

namespace keiko {

/// Throws Error with a key and a reason unless a condition holds.
void require(bool holds, const std::string& key, const std::string& reason);

/// Throws Error unless a value is an object without other keys than these.
void require_known_keys(const Json& json, std::initializer_list<const char*> known);

/// The value at a key of an object. Throws Error if the key is missing.
const Json& value_at(const Json& json, const char* key);

/// The text at a key, which may be missing only if it is optional; it is then empty. Throws Error
/// for an empty text and for another value.
std::string text_at(const Json& json, const char* key, bool optional = false);

/// The point at a key. Throws Error unless it is three finite numbers.
Vec3 place_at(const Json& json, const char* key);

/// The array at a key; an empty one if the key is missing. Throws Error for another value.
Json list_at(const Json& json, const char* key);

} // namespace keiko
