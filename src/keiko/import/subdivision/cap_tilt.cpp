#include "keiko/import/subdivision/limit_table.h"

#include <algorithm>
#include <array>

namespace keiko::subdivision {
namespace {

/// Aslant, so that symmetric cages do not put many points at one place along it.
const Vec3 direction(0.5377, 0.7141, 0.4482);

/// 1 and level at 0, 0 and level at 1.
double ease(double x) {
    return (1 - x) * (1 - x) * (1 + 2 * x);
}

/// 0 with slope 1 at 0, 0 and level at 1.
double rise(double x) {
    return x * (1 - x) * (1 - x);
}

} // namespace

Vec3 CapTilt::offset(double u, double v, bool triangle) const {
    if (corner < 0) return Vec3(0);
    const auto c = static_cast<std::size_t>(corner);
    if (triangle) {
        const std::array<double, 3> weights{1 - u - v, u, v};
        const double z = weights[c], x = weights[(c + 1) % 3], y = weights[(c + 2) % 3];
        return normal * (-(slope_x * x + slope_y * y) * z * z);
    }
    const std::array<Vec2, 4> places{Vec2(u, v), {v, 1 - u}, {1 - u, 1 - v}, {1 - v, u}};
    const double x = places[c].x, y = places[c].y;
    return normal * -(slope_x * rise(x) * ease(y) + slope_y * rise(y) * ease(x));
}

IrregularPoints::IrregularPoints(const std::vector<IrregularPoint>& points) {
    for (const IrregularPoint& p : points) sorted_.emplace_back(p.position.dot(direction), p);
    std::stable_sort(sorted_.begin(), sorted_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
}

const IrregularPoint* IrregularPoints::find(const Vec3& place, const Vec3& normal,
                                            double reach) const {
    const double at = place.dot(direction);
    auto entry = std::lower_bound(sorted_.begin(), sorted_.end(), at - reach,
                                  [](const auto& p, double value) { return p.first < value; });
    const IrregularPoint* best = nullptr;
    for (; entry != sorted_.end() && entry->first <= at + reach; ++entry) {
        const IrregularPoint& p = entry->second;
        if ((p.position - place).length() > reach) continue;
        if (!best || p.normal.dot(normal) > best->normal.dot(normal)) best = &p;
    }
    return best;
}

} // namespace keiko::subdivision
