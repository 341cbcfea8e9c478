#include "keiko/volumes/cloud_light.h"

#include "keiko/base/parallel.h"
#include "keiko/light/fog/medium.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/math/quadrature.h"
#include "keiko/math/trilinear.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double darkness = 20; ///< optical depth that no light counts beyond
/// Nodes of the grids of the sun, whose shadows have edges, and of each part of the surroundings.
constexpr double sun_nodes = 1 << 21, surroundings_nodes = 1 << 15;

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
                       const Job& job)
    : volume_(volume), mean_extinction_(volume.mean_extinction()) {
    const DistantLights lights = distant_lights(rig);
    for (const ParallelLight& sun : lights.suns) beams_.push_back(beam(scene, sun, sun_nodes, job));
    for (const ParallelLight& light : lights.surroundings)
        beams_.push_back(beam(scene, light, surroundings_nodes, job));
}

CloudLight::Beam CloudLight::beam(const SceneVolumes& scene, const ParallelLight& light,
                                  double most, const Job& job) const {
    Beam beam{light, volume_.nodes()};
    const auto& [columns, rows, layers] = volume_.nodes();
    const double steps = std::max(1.0, std::cbrt(1.0 * columns * rows * layers / most));
    for (unsigned axis = 0; axis < 3; ++axis) {
        const int cells = volume_.nodes()[axis] - 1;
        beam.nodes[axis] = static_cast<int>(std::ceil(cells / steps)) + 1;
        beam.steps[axis] = 1.0 * cells / (beam.nodes[axis] - 1);
    }
    const auto row = static_cast<std::size_t>(beam.nodes[0]);
    const std::size_t layer = row * static_cast<std::size_t>(beam.nodes[1]);
    const auto high = static_cast<std::size_t>(beam.nodes[2]);
    beam.depths.resize(layer * high);
    parallel_for(high, job, "", [&](std::size_t z) {
        for (std::size_t i = 0; i < layer; ++i) {
            const Vec3 node(static_cast<double>(i % row), static_cast<double>(i / row),
                            static_cast<double>(z));
            const Vec3 place = volume_.scene_place(node * beam.steps);
            beam.depths[z * layer + i] = static_cast<float>(depth(scene, place, light.towards));
        }
    });
    return beam;
}

double CloudLight::depth(const SceneVolumes& scene, const Vec3& place, const Vec3& towards) const {
    const Segment way{place, place + towards * scene.reach_from(place)};
    if (!volume_.spec().scattering->uniform_leg) return scene.optical_depth(way, darkness);
    const auto crossing = volume_.crossing(way);
    return crossing ? mean_extinction_ * (crossing->end - crossing->begin) : 0;
}

Rgb CloudLight::luminance(const Vec3& place, const Vec3& to_viewer) const {
    const VolumeScattering& scattering = *volume_.spec().scattering;
    Rgb sum;
    for (const Beam& beam : beams_) {
        const GridCell cell = grid_cell(place / beam.steps, beam.nodes);
        const auto row = static_cast<std::size_t>(beam.nodes[0]);
        const std::size_t layer = row * static_cast<std::size_t>(beam.nodes[1]);
        const std::size_t first = cell.node[0] + row * cell.node[1] + layer * cell.node[2];
        const double depth = trilinear(cell.t, [&](std::size_t x, std::size_t y, std::size_t z) {
            return static_cast<double>(beam.depths[first + x + row * y + layer * z]);
        });
        const double cosine = -beam.light.towards.dot(to_viewer);
        sum += beam.light.illuminance * (phase(scattering.phase, cosine) * std::exp(-depth));
    }
    return sum * scattering.albedo;
}

} // namespace keiko
