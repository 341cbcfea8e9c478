#include "keiko/io/subdivision/cap_level.h"

#include <algorithm>
#include <cmath>

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

} // namespace

std::uint32_t base_faces(const Cage& cage, const CageFace& face) {
    return cage.scheme == Scheme::loop || face.corner_count == 4 ? 1 : face.corner_count;
}

CapChoice choose_caps(const Cage& cage, const Job& job) {
    std::size_t count = 0;
    for (const CageFace& face : cage.faces) count += base_faces(cage, face);
    const CapTolerance tolerance{cap_distance_tolerance * cage.size(), cap_angle_tolerance};
    // Levels that make so few patches that they are worth a try.
    const int first = std::max(4, last_sharp_level(cage));
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
