#include "keiko/radiosity/reflected_light.h"

#include "keiko/radiosity/interpolated_radiosity.h"

#include <bit>
#include <cstdint>
#include <utility>

namespace keiko {
namespace {

/// A quantity of all lamps at their levels.
std::vector<BothSides> at_levels(const RadiositySolution& solution, std::span<const Rgb> levels,
                                 std::vector<BothSides> LampSolution::*what) {
    std::vector<BothSides> sum(what == &LampSolution::arriving ? solution.corners.size()
                                                               : solution.elements);
    for (std::size_t lamp = 0; lamp < solution.lamps.size(); ++lamp)
        for (std::size_t i = 0; i < sum.size(); ++i)
            for (const std::size_t side : {0, 1})
                sum[i][side] += (solution.lamps[lamp].*what)[i][side] * levels[lamp];
    return sum;
}

/// Reflectances of all fronts, then of all backs.
std::vector<Rgb> of_faces(const RadiositySolution& solution, std::span<const Rgb> reflectances) {
    std::vector<Rgb> all(2 * solution.elements);
    for (const SolvedTriangle& triangle : solution.triangles)
        all[triangle.element] = reflectances[triangle.face];
    for (std::size_t e = 0; e < solution.elements; ++e) all[solution.elements + e] = all[e];
    return all;
}

std::vector<Rgb> fronts_then_backs(std::span<const BothSides> both) {
    std::vector<Rgb> faces;
    for (const std::size_t side : {0, 1})
        for (const BothSides& of : both) faces.push_back(of[side]);
    return faces;
}

/// A number that places have of their own, the same in every run.
std::uint64_t seed_of(const Vec3& place) {
    constexpr std::uint64_t first = 0x9e3779b97f4a7c15U, second = 0xc2b2ae3d27d4eb4fU;
    return std::bit_cast<std::uint64_t>(place.x) + first * std::bit_cast<std::uint64_t>(place.y) +
           second * std::bit_cast<std::uint64_t>(place.z);
}

} // namespace

ReflectedLight::ReflectedLight(const RadiositySolution& solution, std::span<const Rgb> levels,
                               std::span<const Rgb> reflectances, SurfaceModel model, Tracer tracer)
    : model_(std::move(model)),
      tracer_(std::move(tracer)),
      near_(solution.element_size),
      corners_(solution.corners),
      triangles_(solution.triangles),
      locator_(model_, corners_, triangles_),
      rays_(tracer_, locator_, triangles_, solution.elements),
      arriving_(at_levels(solution, levels, &LampSolution::arriving)),
      exitance_(fronts_then_backs(at_levels(solution, levels, &LampSolution::exitance))),
      reflectances_(of_faces(solution, reflectances)) {}

std::optional<Rgb> ReflectedLight::on_surface(const Root& place, const Vec3& normal) const {
    const Vec2 uv = unit_square.nearest(place.uv.center());
    const auto found = locator_.at(place.instance, place.patch, uv);
    if (!found) return std::nullopt;
    const SurfaceDerivatives s = evaluate(model_.patch(place.patch), uv, 2);
    const Affine& placed = model_.instances[place.instance].transform;
    const Vec3 across = placed.vector(s.du()).cross(placed.vector(s.dv()));
    const bool front =
        (across.dot(normal) >= 0) == locator_.front_is_normal(place.instance, place.patch);
    const std::size_t side = front ? 0 : 1;
    return interpolated(arriving_, triangles_[found->triangle], found->shares, side);
}

Rgb ReflectedLight::gathered(const LightPoint& point, int rays) const {
    constexpr int rays_near = 16; // from each place that is near
    const InterpolatedRadiosity radiosity(triangles_, arriving_, exitance_, reflectances_);
    const std::uint64_t seed = seed_of(point.position);
    Rgb sum;
    std::uint64_t number = seed;
    for (const MetElement& met : rays_.met({&point, 1}, rays, seed)) {
        ++number;
        if (!met.reflects()) continue;
        const bool is_near = met.distance < near_;
        sum += is_near
                   ? radiosity.at(met, radiosity.mean(rays_.met({&met.at, 1}, rays_near, number)))
                   : radiosity.at(met);
    }
    return sum / rays;
}

} // namespace keiko
