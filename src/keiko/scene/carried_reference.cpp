#include "keiko/scene/carried_reference.h"

#include "keiko/light/spotlight/beam_direction.h"

namespace keiko {
namespace {

/// What the shortest turn from one unit axis to another does to a vector across the first.
Vec3 turned(const Vec3& across, const Vec3& from, const Vec3& to) {
    const double both = 1 + from.dot(to);
    constexpr double opposite = 1e-12;
    return both > opposite ? across - (from + to) * (across.dot(to) / both) : across;
}

} // namespace

Vec3 carried_reference(const Vec3& reference, std::span<const Vec3> ways) {
    Vec3 axis = ways.front().normalized();
    Vec3 across = beam_frame(axis, reference).across;
    for (const Vec3& way : ways.subspan(1)) {
        const Vec3 next = way.normalized();
        across = turned(across, axis, next).normalized();
        axis = next;
    }
    return across;
}

} // namespace keiko
