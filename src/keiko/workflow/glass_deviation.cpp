#include "keiko/workflow/glass_deviation.h"

#include "keiko/base/parallel.h"
#include "keiko/intersect/hit/local_surface.h"
#include "keiko/intersect/hit/refract_ray.h"
#include "keiko/math/refract.h"
#include "keiko/render/shading/picture.h"

#include <limits>
#include <optional>

namespace keiko {
namespace {

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

/// The direction behind a pane, which is bent like the face that it stands for: its far side is
/// the face's parallel surface. nullopt where the reflection there is total.
std::optional<Vec3> behind_pane(const Vec3& direction, const Hit& hit, double n, double thickness) {
    if (!hit.second || !is_regular(hit)) return direction;
    Hit facing = hit;
    if (facing.normal.dot(direction) > 0) facing.normal = -facing.normal;
    const Vec3& normal = facing.normal;
    const Vec3 inside = *refract(direction, normal, 1 / n);
    const double along = -inside.dot(normal);
    const Vec3 shift = (inside + normal * along) * (thickness / along);
    const Vec3 far_normal = (normal + LocalSurface(facing).normal_change(shift)).normalized();
    return refract(inside, far_normal, n);
}

/// Follows one line of sight through all glass.
class SightLine {
public:
    explicit SightLine(const Ray& ray) : ray_(ray) { ray_.direction.normalize(); }

    const Ray& ray() const { return ray_; }
    bool met_glass() const { return met_glass_; }
    bool is_inside() const { return index_.has_value(); }

    /// Passes a surface of glass; false where the reflection is total.
    bool pass(const Hit& hit, const Material& material) {
        met_glass_ = true;
        const double n = material.refractive_index, pane = material.glass->pane;
        const double eta = pane > 0 ? 1 : index_ ? *index_ : 1 / n;
        auto on = refract_ray(ray_, hit, eta);
        if (!on) return false;
        if (pane > 0) {
            const auto behind = behind_pane(ray_.direction, hit, n, pane);
            if (!behind) return false;
            on->direction = *behind;
        } else {
            index_ = index_ ? std::nullopt : std::optional(n);
        }
        ray_ = *on;
        return true;
    }

private:
    Ray ray_;
    std::optional<double> index_; ///< of the solid glass that it is in
    bool met_glass_ = false;
};

/// The direction behind all glass; nullopt where none is met, and where there is no way through.
std::optional<Vec3> direction_behind(const Tracer& seen, std::span<const Material> materials,
                                     const Ray& ray) {
    SightLine line(ray);
    for (int crossing = 0; crossing <= PictureOptions().max_crossings; ++crossing) {
        const auto hit = seen.nearest(line.ray());
        if (!hit || !materials[hit->face].glass)
            return line.met_glass() && !line.is_inside() ? std::optional(line.ray().direction)
                                                         : std::nullopt;
        if (!line.pass(*hit, materials[hit->face])) return {};
    }
    return {};
}

} // namespace

Image glass_deviations(const Tracer& seen, std::span<const Material> materials,
                       const Camera& camera, const Job& job) {
    Image deviations(camera.width, camera.height, 3, unknown);
    const CameraAxes axes = camera.axes();
    const PreparedCamera eye(camera);
    parallel_for(static_cast<std::size_t>(camera.height), job, "glass", [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < camera.width; ++x) {
            const Ray ray = eye.ray(x + 0.5, y + 0.5);
            const auto behind = direction_behind(seen, materials, ray);
            if (!behind) continue;
            const double depth = behind->dot(axes.forward);
            float* pixel = deviations.pixel(x, y);
            pixel[0] = static_cast<float>(1e3 * angle_between(ray.direction, *behind));
            pixel[1] = static_cast<float>(behind->dot(axes.right) / depth);
            pixel[2] = static_cast<float>(behind->dot(axes.up) / depth);
        }
    });
    return deviations;
}

} // namespace keiko
