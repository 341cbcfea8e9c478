#include "keiko/compare/outlines/outline_body.h"

#include <cmath>
#include <limits>

namespace keiko {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

FaceFilter faces_named(const OutlineBody& body, std::size_t name) {
    return [&body, name](std::uint32_t face) { return body.placed_names[face] == name; };
}

/// The place of a hit on the material of its face.
Vec3 material_place(const OutlineBody& body, const Hit& hit, std::size_t name, double reach) {
    if (!has(hit.flags, HitFlags::seam)) return hit.position;
    return body.feet.border_foot(hit.position, reach, faces_named(body, name))
        .value_or(hit.position);
}

bool is_ground(const OutlineBody& body, const Hit& hit) {
    return body.ground && hit.face + 1 == body.visible_names.size();
}

} // namespace

double distance_to_same(const OutlineBody& body, const Hit& hit, const OutlineBody& other,
                        double reach) {
    if (is_ground(body, hit))
        return other.ground ? std::abs(hit.position.z - *other.ground) : infinity;
    const std::size_t name = body.visible_names[hit.face];
    const Vec3 place = material_place(body, hit, name, reach);
    const auto foot = other.feet.foot(place, reach, faces_named(other, name));
    return foot ? foot->distance : infinity;
}

} // namespace keiko
