#include "keiko/raster/row_section.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace keiko {
namespace {

/// Depth of the nearest place as a share of that of the farthest one.
constexpr double nearest_share = 1e-6;

} // namespace

RowSection::RowSection(const std::array<Vec3, 3>& triangle, const PictureMap& picture, double row) {
    std::array<double, 3> below; // the row, times the weight
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 corner = picture.at(triangle[i]);
        below[i] = corner.y - row * corner.z;
    }
    std::size_t found = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        if ((below[i] >= 0) == (below[j] >= 0)) continue;
        ends_[found++] =
            triangle[i] + (triangle[j] - triangle[i]) * (below[i] / (below[i] - below[j]));
    }
    if (found == 0) {
        const auto next = std::min_element(below.begin(), below.end(), [](double a, double b) {
            return std::abs(a) < std::abs(b);
        });
        ends_.fill(triangle[static_cast<std::size_t>(next - below.begin())]);
    }
    seen_ = {picture.at(ends_[0]), picture.at(ends_[1])};
    move_before_eye();
}

void RowSection::move_before_eye() {
    const std::size_t far = seen_[0].z >= seen_[1].z ? 0 : 1, near = 1 - far;
    const double first = nearest_share * seen_[far].z, depth = seen_[near].z;
    if (depth >= first) return;
    const double share = (first - depth) / (seen_[far].z - depth);
    ends_[near] += (ends_[far] - ends_[near]) * share;
    seen_[near] += (seen_[far] - seen_[near]) * share;
}

double RowSection::share_at(double x) const {
    const double a = seen_[0].x - x * seen_[0].z, b = seen_[1].x - x * seen_[1].z;
    if ((a > 0) != (b > 0)) return a / (a - b);
    return std::abs(a / seen_[0].z) <= std::abs(b / seen_[1].z) ? 0 : 1;
}

} // namespace keiko
