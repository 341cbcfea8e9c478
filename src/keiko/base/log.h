#pragma once

#include <span>
#include <string>
#include <string_view>

namespace keiko {

/// Least severity of the lines that reach stderr.
enum class LogLevel {
    quiet,  ///< warnings and errors
    normal, ///< the same lines: the library logs nothing between a warning and a detail
    verbose ///< details as well
};

/// Sets how much a front end lets through to stderr; the library itself logs at verbose only.
void set_log_level(LogLevel level);

/// Logs a line that only --verbose shows.
void log_detail(std::string_view message);
/// Logs something that the user should know, printed even with --quiet.
void log_warning(std::string_view message);
/// Logs each message as a warning, in their order.
void log_warnings(std::span<const std::string> messages);
/// Puts a name before every warning of this thread while it lives: "warning: hood: face 3 ...". One
/// inside another replaces its name.
class WarningSubject {
public:
    explicit WarningSubject(std::string_view name);
    ~WarningSubject();
    WarningSubject(const WarningSubject&) = delete;
    WarningSubject& operator=(const WarningSubject&) = delete;

private:
    std::string before_; ///< the name that it replaces
};
/// Logs the one clear line of a failure.
void log_error(std::string_view message);

} // namespace keiko
