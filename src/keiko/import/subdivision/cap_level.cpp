#include "keiko/import/subdivision/cap_level.h"

#include "keiko/base/error.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace keiko::subdivision {
namespace {

/// Every sharpness has worn off at this level.
int last_sharp_level(const Cage& cage) {
    double most = 0;
    const auto take = [&](double sharpness) {
        if (sharpness < infinite_sharpness) most = std::max(most, sharpness);
    };
    for (const CageCrease& crease : cage.creases) take(crease.sharpness);
    for (const CageCorner& corner : cage.sharp_corners) take(corner.sharpness);
    return static_cast<int>(std::ceil(most));
}

/// Levels that make so few patches that they are worth a try.
constexpr int first_try = 4;

/// Points of a cage refined to `level`, told from its first levels: around an irregular point each
/// level has as many, along a crease of blended sharpness twice as many as the one before.
double expected_points(const Cage& cage, int level) {
    const std::vector<int> counts = LimitTable::points_by_level(cage, first_try + 1);
    const double total = std::accumulate(counts.begin(), counts.end(), 0.0);
    const double last = counts[first_try + 1], growth = last - counts[first_try];
    const int more = level - (first_try + 1);
    return total + more * (last - 2 * growth) + growth * (std::exp2(more + 2) - 4);
}

/// A few lines of a file may ask for more patches than any memory holds.
void require_affordable(const Cage& cage, int sharp_level) {
    if (sharp_level <= first_try || expected_points(cage, sharp_level) <= most_refined_points)
        return;
    throw Error("", "",
                "its semi-sharp creases need more than " + std::to_string(most_refined_points) +
                    " points; make them fewer or less sharp");
}

} // namespace

std::uint32_t base_faces(const Cage& cage, const CageFace& face) {
    return cage.scheme == Scheme::loop || face.corner_count == 4 ? 1 : face.corner_count;
}

CapChoice choose_caps(const Cage& cage, const Job& job) {
    std::size_t count = 0;
    for (const CageFace& face : cage.faces) count += base_faces(cage, face);
    const CapTolerance tolerance{cap_distance_tolerance * cage.size(), cap_angle_tolerance};
    const int first = std::max(first_try, last_sharp_level(cage));
    require_affordable(cage, first);
    auto table = std::make_unique<LimitTable>(cage, first);
    if (table->caps().empty()) return {std::move(table), first, std::vector<CapError>(count)};

    auto deepest = std::make_unique<LimitTable>(cage, deepest_level);
    job.check();
    constexpr int bounding_level = deepest_level - 2;
    for (int level = first; level < bounding_level; level += 2) {
        if (level != first) table = std::make_unique<LimitTable>(cage, level);
        job.check();
        if (!caps_within(*table, *deepest, tolerance)) continue;
        std::vector<CapError> errors = cap_errors(*table, *deepest, count, job);
        return {std::move(table), level, std::move(errors)};
    }
    table = std::make_unique<LimitTable>(cage, bounding_level);
    std::vector<CapError> errors = cap_errors(*table, *deepest, count, job);
    return {std::move(deepest), deepest_level, std::move(errors)};
}

} // namespace keiko::subdivision
