#pragma once

#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace keiko {

/// The shortest decimal that reads back as the same double, in TOML's syntax. Requires a finite
/// number.
std::string toml_number(double value);

// Values and lines of the TOML files that Keiko writes. All throw Error for numbers that are not
// finite, which no file can hold.

/// The shortest decimal that reads back as the same double.
std::string toml_value(double value);
std::string toml_value(const Vec3& vector);
std::string toml_value(std::span<const double> numbers);
/// One number for grey, else three.
std::string toml_value(const Rgb& color);
/// In quotes, with the characters escaped that a TOML string must not hold.
std::string toml_string(std::string_view text);
/// "key = value # comment", with a line end.
std::string toml_line(std::string_view key, const std::string& value,
                      std::string_view comment = "");

/// How a TOML file in `folder` names a file; as it is where the folder is empty.
std::string named_from(const std::filesystem::path& folder, const std::filesystem::path& file);

} // namespace keiko
