#pragma once

#include <span>
#include <string>
#include <string_view>

namespace keiko {

enum class LogLevel { quiet, normal, verbose };

/// What a front end lets through to stderr; the library itself logs at verbose only.
void set_log_level(LogLevel level);

/// A line for whoever asked for --verbose.
void log_detail(std::string_view message);
/// Something the user should know, printed even with --quiet.
void log_warning(std::string_view message);
void log_warnings(std::span<const std::string> messages);
/// The one clear line of a failure.
void log_error(std::string_view message);

} // namespace keiko
