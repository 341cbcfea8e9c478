#include "keiko/cli/option_values.h"

#include "keiko/base/error.h"

#include <cmath>
#include <cstdio>

namespace keiko::cli {

Vec3 direction(const std::string& option, const std::string& text) {
    Vec3 d(0);
    int end = 0;
    if (std::sscanf(text.c_str(), "%lf,%lf,%lf%n", &d.x, &d.y, &d.z, &end) != 3 ||
        static_cast<std::size_t>(end) != text.size() || !std::isfinite(d.length()) ||
        !(d.length() > 0))
        throw Error("", option, "'" + text + "' is not a direction X,Y,Z of some length");
    return d.normalized();
}

std::optional<ValueRange> value_range(const std::string& text) {
    ValueRange range;
    int end = 0;
    if (std::sscanf(text.c_str(), "%lf:%lf%n", &range.low, &range.high, &end) != 2 ||
        static_cast<std::size_t>(end) != text.size() || !std::isfinite(range.high - range.low) ||
        !(range.low < range.high))
        return std::nullopt;
    return range;
}

void add_mesher(CLI::App& command, std::string& name) {
    command
        .add_option("--mesher", name,
                    "opencascade, as viewports have it, its deviation measured; or spans, a grid "
                    "in each knot span, its deviation and that of trims proved each")
        ->check(CLI::IsMember({"opencascade", "spans"}))
        ->option_text("NAME")
        ->capture_default_str();
}

} // namespace keiko::cli
