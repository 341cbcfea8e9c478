#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace keiko::bench {

/// One panel of curves over logarithmic axes; all values are positive.
struct LogPlot {
    struct Curve {
        std::string name{};
        std::vector<std::array<double, 2>> points{};
        std::optional<std::size_t> colour{}; ///< of six; by its place among the curves if unstated
    };
    std::string x{}, y{}; ///< what stands at the axes
    std::vector<Curve> curves{};
};

/// Panels side by side, as an SVG file. Throws Error where it cannot be written.
void write_svg(const std::filesystem::path& file, const std::vector<LogPlot>& panels);

} // namespace keiko::bench
