#include "keiko/workflow/analysis_scale.h"

#include <algorithm>
#include <cmath>

namespace keiko {

std::vector<double> body_values(const FilmSight& sight, const PixelValues& values) {
    std::vector<double> of_body;
    for (int y = 0; y < sight.height(); ++y)
        for (int x = 0; x < sight.width(); ++x)
            if (sight.is_body(x, y) && std::isfinite(values.at(x, y)))
                of_body.push_back(values.at(x, y));
    return of_body;
}

double quantile(std::vector<double> values, double percent) {
    if (values.empty()) return 0;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(
                                         percent / 100 * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

double quantile_of_sizes(std::vector<double> values, double percent) {
    for (double& value : values) value = std::abs(value);
    return quantile(std::move(values), percent);
}

} // namespace keiko
