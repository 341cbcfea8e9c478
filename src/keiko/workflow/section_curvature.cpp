#include "keiko/workflow/section_curvature.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/bezier/differential_geometry.h"

#include <limits>
#include <optional>
#include <vector>

namespace keiko {
namespace {

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

float section_curvature(const Hit& hit, const Ray& ray, const Vec3& plane) {
    constexpr double touching = 1e-6; // sine of the angle between the normals of plane and surface
    const SurfaceDerivatives derivatives = derivatives_of(hit);
    const Vec3 along = plane.cross(hit.normal);
    if (!(along.length() > touching) || !has_reliable_curvatures(derivatives, hit.normal))
        return unknown;
    const Vec3 seen = hit.normal.dot(ray.direction) > 0 ? -hit.normal : hit.normal;
    return static_cast<float>(normal_curvature(derivatives, seen, along));
}

} // namespace

Image section_curvatures(const Tracer& body, const Camera& camera, const Vec3& plane,
                         const Job& job) {
    const Vec3 normal = plane.normalized();
    Image curvatures(camera.width, camera.height, 1, unknown);
    parallel_for(static_cast<std::size_t>(camera.height), job, "sections", [&](std::size_t row) {
        const int y = static_cast<int>(row);
        std::vector<Ray> rays;
        for (int x = 0; x < camera.width; ++x) rays.push_back(camera.ray(x + 0.5, y + 0.5));
        const std::vector<std::optional<Hit>> hits = body.nearest(rays);
        for (std::size_t i = 0; i < rays.size(); ++i)
            if (hits[i])
                *curvatures.pixel(static_cast<int>(i), y) =
                    section_curvature(*hits[i], rays[i], normal);
    });
    return curvatures;
}

} // namespace keiko
