#include "keiko/base/log.h"

#include "keiko/base/text.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <utility>

namespace keiko {
namespace {

spdlog::logger& logger() {
    static const auto instance = [] {
        auto created = spdlog::stderr_logger_mt("keiko");
        created->set_pattern("keiko: %v");
        return created;
    }();
    return *instance;
}

/// Name before the warnings of a thread, with ": ".
std::string& warning_subject() {
    thread_local std::string subject;
    return subject;
}

} // namespace

void set_log_level(LogLevel level) {
    switch (level) {
        case LogLevel::quiet:
            logger().set_level(spdlog::level::warn);
            break;
        case LogLevel::normal:
            logger().set_level(spdlog::level::info);
            break;
        case LogLevel::verbose:
            logger().set_level(spdlog::level::debug);
            break;
    }
}

void log_detail(std::string_view message) {
    logger().debug(one_line(message));
}
void log_warning(std::string_view message) {
    logger().warn("warning: {}{}", warning_subject(), one_line(message));
}

WarningSubject::WarningSubject(std::string_view name)
    : before_(std::exchange(warning_subject(), one_line(name) + ": ")) {}

WarningSubject::~WarningSubject() {
    warning_subject() = std::move(before_);
}

void log_warnings(std::span<const std::string> messages) {
    for (const std::string& message : messages) log_warning(message);
}
void log_error(std::string_view message) {
    logger().error(one_line(message));
}

} // namespace keiko
