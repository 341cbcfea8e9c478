#include "tests/support/ray_class.h"

#include <cmath>
#include <cstdio>
#include <numbers>

namespace keiko::test {
namespace {

/// A direction in the tangent plane tilted towards the surface.
Vec3 tilted(const Mark& mark, const Vec3& tangent, Random& random) {
    const double angle = std::pow(10, -uniform(random, 1, 8));
    const double side = random() % 2 == 0 ? 1 : -1;
    return tangent * std::cos(angle) + mark.normal * (side * std::sin(angle));
}

Vec3 axis(Random& random) {
    Vec3 direction(random() % 2 == 0 ? 0.0 : -0.0);
    direction[static_cast<unsigned>(random() % 3)] = random() % 2 == 0 ? 1 : -1;
    return direction;
}

Vec3 direction_for(const Mark& mark, RayClass kind, Random& random) {
    switch (kind) {
        case RayClass::near_normal:
            return (random_direction(random) * 0.1 - mark.normal).normalized();
        case RayClass::grazing: {
            const double turn = uniform(random, 0, 2 * std::numbers::pi);
            const Vec3 across = mark.normal.cross(mark.tangent_u);
            return tilted(mark, mark.tangent_u * std::cos(turn) + across * std::sin(turn), random);
        }
        case RayClass::iso_line:
            return tilted(mark, random() % 2 == 0 ? mark.tangent_u : mark.tangent_v, random);
        case RayClass::axis_parallel:
            return axis(random);
        default:
            return random_direction(random);
    }
}

} // namespace

Ray ray_at(const Mark& mark, RayClass kind, double distance, Random& random) {
    Ray ray;
    ray.direction = direction_for(mark, kind, random);
    ray.origin = mark.position - ray.direction * distance;
    if (kind != RayClass::axis_parallel && random() % 4 == 0) ray.direction *= distance;
    return ray;
}

std::string exact_text(const Ray& ray) {
    char text[256];
    std::snprintf(text, sizeof text, "origin {%a, %a, %a} direction {%a, %a, %a}", ray.origin.x,
                  ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z);
    return text;
}

} // namespace keiko::test
