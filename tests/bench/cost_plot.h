#pragma once

#include <string>
#include <utility>
#include <vector>

namespace keiko::bench {

/// What something costs by the size of the task.
struct CostLine {
    std::string name{};
    std::vector<std::pair<double, double>> points{}; ///< both above 0
};

struct CostPanel {
    std::string title{}, across{};
    std::vector<CostLine> lines{};
};

/// SVG of panels side by side, both axes logarithmic and the cost axis, named `up`, shared.
std::string cost_plot_svg(const std::vector<CostPanel>& panels, const std::string& up);

} // namespace keiko::bench
