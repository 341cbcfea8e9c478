#pragma once

#include <string>
#include <string_view>

namespace keiko {

/// The shortest text that reads back as the same number.
std::string csv_number(double value);

/// A field in quotes, those in it doubled [RFC4180].
std::string csv_quoted(std::string_view text);

} // namespace keiko
