#include "keiko/base/error.h"
#include "keiko/base/parallel.h"
#include "keiko/geometry/bezier/bezier.h"
#include "keiko/import/subdivision/limit_patches.h"
#include "keiko/import/subdivision/limit_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

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

/// Largest deviation of a cap from the limit surface that counts as none.
struct CapTolerance {
    double distance = 0, angle = 0; ///< as CapError
};

/// Tolerances of caps: a share of the cage's size, and radians.
constexpr double cap_distance_tolerance = 1e-6, cap_angle_tolerance = 1e-5;

/// Places of a cap around each of its corners, halving the distance: one of the corners is
/// the irregular point.
std::vector<Vec2> probes(bool triangle) {
    constexpr int halvings = 4;
    constexpr std::array shares{0.1, 0.5, 0.9};
    std::vector<Vec2> places;
    double radius = 0.95;
    for (int k = 0; k < halvings; ++k, radius /= 2)
        for (const double share : shares) {
            const double other = triangle ? radius * (1 - share) : radius;
            const Vec2 a(other, radius * share);
            if (triangle) {
                const double rest = 1 - a.x - a.y;
                places.insert(places.end(), {a, {rest, a.x}, {a.y, rest}});
                continue;
            }
            for (const Vec2& p : {a, Vec2(a.y, a.x)})
                places.insert(places.end(),
                              {p, {1 - p.x, p.y}, {p.x, 1 - p.y}, {1 - p.x, 1 - p.y}});
        }
    return places;
}

/// Surface of the model at a cap, by the cap's own parameters.
using CapSurface = std::function<LimitPoint(const Vec2& uv)>;

CapSurface cap_triangle(const LimitTable& table, LimitTable::Index index) {
    return [at = triangle_surface(table, index)](const Vec2& uv) {
        constexpr double step = 1e-4; // of a polynomial of degree 4
        return LimitPoint{at(uv.x, uv.y),
                          (at(uv.x + step, uv.y) - at(uv.x - step, uv.y)) / (2 * step),
                          (at(uv.x, uv.y + step) - at(uv.x, uv.y - step)) / (2 * step)};
    };
}

CapSurface cap_quad(const LimitTable& table, LimitTable::Index index) {
    const LimitPatch patch = quad_patches(table, index).front();
    std::vector<Vec4> points;
    for (const Vec3& p : patch.points) points.emplace_back(p.x, p.y, p.z, 1);
    return [degree = patch.degree, points = std::move(points)](const Vec2& uv) {
        const SurfaceDerivatives s = keiko::evaluate({degree, degree, points}, uv, 1);
        return LimitPoint{s.position(), s.du(), s.dv()};
    };
}

CapError error_of(const LimitTable& table, LimitTable::Index index, const LimitTable& deeper,
                  const std::vector<Vec2>& places) {
    const PatchPlace place = table.place(index);
    const CapSurface cap = table.triangular() ? cap_triangle(table, index) : cap_quad(table, index);
    CapError worst;
    for (const Vec2& uv : places) {
        const Vec2 base = place.base(uv.x, uv.y);
        const auto truth = deeper.smooth_patch_at(place.face, base);
        if (!truth) continue;
        const Vec2 local = deeper.place(*truth).local(base);
        const LimitPoint limit = deeper.evaluate(*truth, local.x, local.y);
        const LimitPoint found = cap(uv);
        const Vec3 off = found.position - limit.position, normal = limit.normal();
        worst.extend(
            {off.length(), std::abs(off.dot(normal)), angle_between(found.normal(), normal)});
    }
    return worst;
}

/// The largest errors of the caps of `table` against the exact patches of `deeper`, by base face.
std::vector<CapError> cap_errors(const LimitTable& table, const LimitTable& deeper,
                                 std::size_t base_faces, const Job& job) {
    const std::vector<LimitTable::Index> caps = table.caps();
    const std::vector<Vec2> places = probes(table.triangular());
    std::vector<CapError> errors(caps.size());
    constexpr std::size_t chunk = 256;
    parallel_for((caps.size() + chunk - 1) / chunk, job, "", [&](std::size_t task) {
        const std::size_t end = std::min(caps.size(), (task + 1) * chunk);
        for (std::size_t i = task * chunk; i < end; ++i)
            errors[i] = error_of(table, caps[i], deeper, places);
    });
    std::vector<CapError> worst(base_faces);
    for (std::size_t i = 0; i < caps.size(); ++i)
        worst[table.place(caps[i]).face].extend(errors[i]);
    return worst;
}

/// Whether all caps keep within a tolerance; stops at the first that does not.
bool caps_within(const LimitTable& table, const LimitTable& deeper, const CapTolerance& tolerance) {
    const std::vector<Vec2> places = probes(table.triangular());
    for (const LimitTable::Index cap : table.caps()) {
        const CapError error = error_of(table, cap, deeper, places);
        if (!(error.distance <= tolerance.distance && error.angle <= tolerance.angle)) return false;
    }
    return true;
}

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

/// Points of a cage refined to `level`, estimated from its first levels: around an irregular point
/// each level has as many, along a crease of blended sharpness twice as many as the one before.
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

void CapError::extend(const CapError& other) {
    distance = std::max(distance, other.distance);
    height = std::max(height, other.height);
    angle = std::max(angle, other.angle);
}

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
