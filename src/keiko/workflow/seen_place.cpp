#include "keiko/workflow/seen_place.h"

#include <algorithm>

namespace keiko {

std::optional<Hit> seen_place(const Scene& scene, const Camera& camera, const Vec3& place) {
    const auto pixel = project(camera, place);
    if (!pixel || pixel->x < 0 || pixel->y < 0 || pixel->x >= camera.width ||
        pixel->y >= camera.height)
        return std::nullopt;
    const double near = 1e-3 * scene.tracer.bounds().size();
    // Borders lie at the rim of what can be hit: rays beside them are tested, too.
    for (const Vec2& beside : {Vec2(0, 0), Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
        const Ray ray = camera.ray(pixel->x + beside.x, pixel->y + beside.y);
        auto hit = scene.tracer.nearest(ray);
        const double depth = (place - ray.origin).dot(ray.direction);
        if (hit && hit->t > depth - std::max(near, 0.02 * depth)) return hit;
    }
    return std::nullopt;
}

} // namespace keiko
