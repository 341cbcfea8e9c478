#include "keiko/volumes/cloud_light.h"

#include "keiko/light/fog/medium.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/math/quadrature.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi;
/// Places of the depths of the sun, whose shadows have edges, and of each part of the surroundings.
constexpr double sun_places = 1 << 21, surroundings_places = 1 << 15;

/// cd/m2 of the surroundings of a rig in a unit direction.
Rgb surroundings_in(const LightRig& rig, const Vec3& towards) {
    Rgb sum = even_luminance(rig.ambient);
    for (const LightSource& source : rig.sources) {
        const auto* sky = std::get_if<SkyLight>(&source);
        if (!sky || !sky->windows.empty()) continue;
        sum += towards.z > 0 ? sky->luminance * SkyDistribution(*sky)(towards) : sky->ground;
    }
    return sum;
}

/// Adds the surroundings above or below the horizon.
void add_surroundings(const LightRig& rig, double side, std::vector<ParallelLight>& lights) {
    constexpr int elevations = 3, azimuths = 6;
    for (const QuadratureNode& node : gauss_legendre(elevations))
        for (int i = 0; i < azimuths; ++i) {
            const double z = side * (1 + node.x) / 2, azimuth = 2 * pi * (i + 0.5) / azimuths;
            const double across = std::sqrt(1 - z * z);
            const Vec3 towards(across * std::cos(azimuth), across * std::sin(azimuth), z);
            const double solid_angle = 2 * pi / azimuths * node.weight / 2;
            const Rgb luminance = surroundings_in(rig, towards);
            if (luminance != Rgb(0)) lights.push_back({towards, luminance * solid_angle});
        }
}

} // namespace

DistantLights distant_lights(const LightRig& rig) {
    DistantLights lights;
    for (const LightSource& source : rig.sources)
        if (const auto* sun = std::get_if<Sun>(&source); sun && sun->windows.empty())
            lights.suns.push_back({sun->towards(), sun->illuminance});
    add_surroundings(rig, 1, lights.surroundings);
    add_surroundings(rig, -1, lights.surroundings);
    return lights;
}

CloudLight::CloudLight(const SceneVolumes& scene, const Volume& volume, const LightRig& rig,
                       const StopOfLight& stops, const Job& job)
    : volume_(volume), mean_extinction_(volume.mean_extinction()) {
    DistantLights lights = distant_lights(rig);
    suns_ = std::move(lights.suns), surroundings_ = std::move(lights.surroundings);
    for (const ParallelLight& sun : suns_)
        sun_depths_.push_back(depths_towards(scene, sun, sun_places, stops, job));
    if (!surroundings_.empty()) find_surroundings(scene, stops, job);
}

BeamDepths CloudLight::depths_towards(const SceneVolumes& scene, const ParallelLight& light,
                                      double most, const StopOfLight& stops, const Job& job) const {
    if (volume_.spec().scattering->uniform_leg)
        return BeamDepths::uniform(volume_, light.towards, mean_extinction_);
    return {scene, volume_, light.towards, most, stops, job};
}

void CloudLight::find_surroundings(const SceneVolumes& scene, const StopOfLight& stops,
                                   const Job& job) {
    const auto& [columns, rows, layers] = volume_.nodes();
    const double step =
        std::max(1.0, std::cbrt(1.0 * columns * rows * layers / surroundings_places));
    for (unsigned axis = 0; axis < 3; ++axis) {
        const int cells = volume_.nodes()[axis] - 1;
        nodes_[axis] = static_cast<int>(std::ceil(cells / step)) + 1;
        steps_[axis] = 1.0 * cells / (nodes_[axis] - 1);
    }
    const auto row = static_cast<std::size_t>(nodes_[0]);
    const std::size_t layer = row * static_cast<std::size_t>(nodes_[1]);
    const std::size_t count = layer * static_cast<std::size_t>(nodes_[2]);
    passed_.resize(count * surroundings_.size());
    for (std::size_t i = 0; i < surroundings_.size(); ++i) {
        const BeamDepths depths =
            depths_towards(scene, surroundings_[i], surroundings_places, stops, job);
        for (std::size_t node = 0; node < count; ++node) {
            const Vec3 place(static_cast<double>(node % row),
                             static_cast<double>(node % layer / row),
                             static_cast<double>(node / layer));
            passed_[node * surroundings_.size() + i] =
                static_cast<float>(std::exp(-depths(place * steps_)));
        }
    }
}

CloudView::CloudView(const CloudLight& light, const Vec3& to_viewer) : light_(&light) {
    const VolumeScattering& scattering = *light.volume_.spec().scattering;
    const auto scattered = [&](const ParallelLight& from) {
        return from.illuminance * scattering.albedo *
               phase(scattering.phase, -from.towards.dot(to_viewer));
    };
    for (const ParallelLight& sun : light.suns_) of_suns_.push_back(scattered(sun));
    for (const ParallelLight& part : light.surroundings_)
        of_surroundings_.push_back(scattered(part));
    cell_.fill(std::numeric_limits<std::size_t>::max());
    logarithms_.fill(Vec3(0));
}

void CloudView::sum_surroundings(const GridCell& cell) {
    const auto row = static_cast<std::size_t>(light_->nodes_[0]);
    const std::size_t layer = row * static_cast<std::size_t>(light_->nodes_[1]);
    const std::size_t lights = of_surroundings_.size();
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const std::size_t node = cell.node[0] + corner % 2 + row * (cell.node[1] + corner / 2 % 2) +
                                 layer * (cell.node[2] + corner / 4);
        const float* passed = &light_->passed_[node * lights];
        Rgb sum;
        for (std::size_t i = 0; i < lights; ++i)
            sum += of_surroundings_[i] * static_cast<double>(passed[i]);
        constexpr double dark = 1e-30; // cd/m2: of a channel without light
        logarithms_[corner] = Vec3(std::log(std::max(sum.r, dark)), std::log(std::max(sum.g, dark)),
                                   std::log(std::max(sum.b, dark)));
    }
    cell_ = cell.node;
}

Rgb CloudView::luminance(const Vec3& place) {
    Rgb sum;
    for (std::size_t i = 0; i < of_suns_.size(); ++i)
        sum += of_suns_[i] * std::exp(-light_->sun_depths_[i](place));
    if (of_surroundings_.empty()) return sum;
    const GridCell cell = grid_cell(place / light_->steps_, light_->nodes_);
    if (cell.node != cell_) sum_surroundings(cell);
    const Vec3 at = trilinear(cell.t, [&](std::size_t x, std::size_t y, std::size_t z) {
        return logarithms_[x + 2 * y + 4 * z];
    });
    return sum + Rgb(std::exp(at.x), std::exp(at.y), std::exp(at.z));
}

} // namespace keiko
