#include "keiko/placement/candidate_planes.h"

#include <algorithm>
#include <array>
#include <optional>

namespace keiko {

namespace {

double reach(const OrientedBox& box, const Vec3& direction) {
    return std::abs(box.axes[0].dot(direction)) * box.half.x +
           std::abs(box.axes[1].dot(direction)) * box.half.y +
           std::abs(box.axes[2].dot(direction)) * box.half.z;
}

bool separates(const Vec3& axis, const OrientedBox& a, const OrientedBox& b) {
    return std::abs((b.center - a.center).dot(axis)) > reach(a, axis) + reach(b, axis);
}

} // namespace

OrientedBox oriented(const Box3& box) {
    return {.center = box.center(), .half = box.extent() / 2};
}

OrientedBox oriented(const CPlane& plane) {
    const Vec3 u = plane.u.normalized(), v = plane.v.normalized();
    return {.center = plane.origin + (plane.u + plane.v) / 2,
            .axes = {u, v, u.cross(v)},
            .half = {plane.u.length() / 2, plane.v.length() / 2, plane.diameter / 2}};
}

bool overlap(const OrientedBox& a, const OrientedBox& b) {
    for (const Vec3& axis : a.axes)
        if (separates(axis, a, b)) return false;
    for (const Vec3& axis : b.axes)
        if (separates(axis, a, b)) return false;
    for (const Vec3& one : a.axes)
        for (const Vec3& other : b.axes) // of parallel edges the product is 0 and separates nothing
            if (separates(one.cross(other), a, b)) return false;
    return true;
}

namespace {

constexpr std::array<double, 4> distances{0.8, 1.5, 2.5, 4}; ///< in sizes of the visible part
constexpr double neighbourhood = 0.5; ///< cosine to a direction of those gathered around it
constexpr int rounds = 8;             ///< of the mean shift
constexpr double same = 0.985;        ///< cosine of directions that count as the same

/// Mean direction of the uncovered reflected rays within the neighbourhood of `around`, or of all.
std::optional<Vec3> mean_direction(const LampField& field, const std::optional<Vec3>& around) {
    Vec3 sum(0);
    for (std::size_t i = 0; i < field.samples().size(); ++i) {
        const ViewSample& s = field.samples()[i];
        if (!field.waits(i)) continue;
        if (around && !(s.mirror.direction.dot(*around) > neighbourhood)) continue;
        sum += s.mirror.direction * s.weight;
    }
    if (!(sum.length() > 1e-6 * field.total_weight())) return {};
    return sum.normalized();
}

/// Local maximum of the density of reflected directions by mean shift.
std::optional<Vec3> gathered(const LampField& field, const Vec3& start) {
    std::optional<Vec3> direction = start;
    for (int round = 0; round < rounds && direction; ++round)
        direction = mean_direction(field, direction);
    return direction;
}

std::vector<Vec3> directions(const LampField& field) {
    std::vector<Vec3> found{{0, 0, 1}, {0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}};
    const auto add = [&](const std::optional<Vec3>& direction) {
        if (direction && std::none_of(found.begin(), found.end(), [&](const Vec3& other) {
                return other.dot(*direction) > same;
            }))
            found.push_back(*direction);
    };
    add(mean_direction(field, {}));
    for (const double z : {1, 0, -1})
        for (const double y : {-1, 0, 1})
            for (const double x : {-1, 0, 1})
                if (x != 0 || y != 0 || z != 0) add(gathered(field, Vec3(x, y, z).normalized()));
    return found;
}

PlaneFrame facing(const Vec3& center, const Vec3& direction, double distance) {
    const Vec3 forward(1, 0, 0), sideways(0, 1, 0);
    const Vec3& along = std::abs(direction.x) < 0.9 ? forward : sideways;
    const Vec3 u = (along - direction * direction.dot(along)).normalized();
    return {center + direction * distance, u, direction.cross(u)};
}

/// Directions for a mirror: each one along it projected to it, and each one that faces aside moved
/// to one side.
std::vector<Vec3> folded(const std::vector<Vec3>& directions, const MirrorPlane& mirror) {
    constexpr double aside = 0.2;       // sine from which lamps are placed in pairs
    constexpr double along_least = 0.5; // cosine down to which lamps on the mirror may suffice
    std::vector<Vec3> found;
    const auto add = [&](const Vec3& direction) {
        if (std::none_of(found.begin(), found.end(),
                         [&](const Vec3& other) { return other.dot(direction) > same; }))
            found.push_back(direction);
    };
    for (Vec3 direction : directions) {
        double& off = direction[mirror.axis];
        off = std::abs(off);
        if (off > aside) add(direction);
        off = 0;
        if (direction.length() > along_least) add(direction.normalized());
    }
    return found;
}

std::vector<PlaneFrame> planes_around(const Vec3& center, double size,
                                      const std::vector<Vec3>& directions) {
    std::vector<PlaneFrame> planes;
    for (const Vec3& direction : directions)
        for (const double distance : distances)
            planes.push_back(facing(center, direction, distance * size));
    return planes;
}

} // namespace

std::vector<PlaneFrame> candidate_planes(const LampField& field, const PlaneChoice& choice) {
    if (!choice.frames.empty()) return choice.frames;
    return planes_around(field.centroid(), field.size(),
                         choice.towards.empty() ? directions(field) : choice.towards);
}

std::vector<PlaneFrame> candidate_planes(const LampField& field, const PlaneChoice& choice,
                                         const MirrorPlane& mirror) {
    Vec3 center = field.centroid();
    center[mirror.axis] = mirror.offset;
    const std::vector<Vec3> all = choice.towards.empty() ? directions(field) : choice.towards;
    return planes_around(center, field.size(), folded(all, mirror));
}

} // namespace keiko
