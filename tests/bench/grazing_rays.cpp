#include "tests/bench/grazing_rays.h"

#include "keiko/geometry/bezier/bezier.h"
#include "keiko/geometry/trim/trim_region.h"

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

namespace keiko::bench {
namespace {

constexpr double least_angle = 1e-4, greatest_angle = 1e-1; // rad

struct SurfacePoint {
    Vec3 position{0}, normal{0}, tangent{0}; ///< unit vectors
};

/// Draws points of the material of a placed model, about evenly by area.
class PointSource {
public:
    explicit PointSource(const SurfaceModel& model) : model_(model) {
        regions_.reserve(model.faces.size());
        for (const Face& face : model.faces) regions_.emplace_back(model, face);
        std::vector<double> weights;
        for (std::uint32_t i = 0; i < model.instances.size(); ++i)
            for (std::uint32_t p = 0; p < model.patches.size(); ++p) {
                if (model.faces[model.patches[p].face].part != model.instances[i].part) continue;
                const double size = hull_bounds(model.patch(p)).size();
                places_.push_back({i, p});
                weights.push_back(size * size);
            }
        choose_ = std::discrete_distribution<std::size_t>(weights.begin(), weights.end());
    }

    SurfacePoint draw(std::mt19937_64& random) {
        constexpr int most_tries = 1000000;
        for (int i = 0; i < most_tries; ++i) {
            const Place& place = places_[choose_(random)];
            const double u = unit_(random), v = unit_(random);
            const Vec2 uv(u, v);
            const std::uint32_t face = model_.patches[place.patch].face;
            if (!regions_[face].contains(model_.face_parameters(place.patch, uv))) continue;
            const SurfacePoint point = at(place, uv);
            if (is_finite(point.normal) && is_finite(point.tangent)) return point;
        }
        throw std::runtime_error("no point of the material found");
    }

private:
    struct Place {
        std::uint32_t instance, patch;
    };

    SurfacePoint at(const Place& place, const Vec2& uv) const {
        const SurfaceDerivatives s = evaluate(model_.patch(place.patch), uv, 1);
        const Affine& map = model_.instances[place.instance].transform;
        const Vec3 du = map.vector(s.du()), dv = map.vector(s.dv());
        // Poles give vectors that are not finite or mean nothing: draw() takes others.
        const Vec3 normal = du.cross(dv);
        if (!(normal.length() > 1e-9 * du.length() * dv.length()))
            return {.normal = Vec3(std::numeric_limits<double>::quiet_NaN())};
        return {map.point(s.position()), normal.normalized(), du.normalized()};
    }

    const SurfaceModel& model_;
    std::vector<TrimRegion> regions_; ///< one a face
    std::vector<Place> places_;
    std::discrete_distribution<std::size_t> choose_;
    std::uniform_real_distribution<double> unit_{0, 1};
};

} // namespace

RaySet grazing_rays(const SurfaceModel& model, const Box3& bounds, std::size_t count) {
    PointSource points(model);
    std::mt19937_64 random(2003);
    std::uniform_real_distribution<double> turn(0, 2 * std::numbers::pi);
    std::uniform_real_distribution<double> exponent(std::log(least_angle),
                                                    std::log(greatest_angle));
    RaySet set{.name = "grazing"};
    while (set.rays.size() < count) {
        const SurfacePoint point = points.draw(random);
        const double around = turn(random), angle = std::exp(exponent(random));
        const Vec3 along =
            point.tangent * std::cos(around) + point.normal.cross(point.tangent) * std::sin(around);
        const double side = random() % 2 == 0 ? 1 : -1;
        Ray ray;
        ray.direction =
            (along * std::cos(angle) + point.normal * (side * std::sin(angle))).normalized();
        const double distance = 1.5 * bounds.size();
        ray.origin = point.position - ray.direction * distance;
        set.rays.push_back(ray);
        set.known.push_back({distance, point.normal});
    }
    return set;
}

} // namespace keiko::bench
