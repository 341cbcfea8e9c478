#include "keiko/cli/number_check.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace keiko::cli {

CLI::Validator number_between(double low, double high) {
    std::array<char, 64> range{};
    std::snprintf(range.data(), range.size(), "%g to %g", low, high);
    const std::string allowed = range.data();
    const auto reason = [low, high, allowed](const std::string& text) -> std::string {
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        const bool whole = !text.empty() && end == text.c_str() + text.size();
        // CLI::Range lets NaN pass.
        if (whole && value >= low && value <= high) return {};
        return "'" + text + "' is not a number from " + allowed;
    };
    return CLI::Validator(reason, allowed);
}

} // namespace keiko::cli
