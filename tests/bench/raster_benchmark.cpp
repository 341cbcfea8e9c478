#include "tests/bench/raster_benchmark.h"

#include "keiko/api/model.h"
#include "keiko/api/scene.h"
#include "keiko/raster/painter.h"
#include "keiko/raster/patch_subdivision.h"
#include "keiko/raster/scan_line.h"
#include "keiko/raster/z_buffer.h"

#include "tests/bench/cpu_clock.h"
#include "tests/bench/progress.h"
#include "tests/support/paths.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>

namespace keiko::bench {
namespace {

constexpr int most_rounds = 9; // the least counts: the rest is other programs on the machine

/// The least wall-clock time of several rounds, s.
template <class Work>
double least_seconds(const Work& work, int rounds = most_rounds) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < rounds; ++i) {
        const double begin = seconds_on(CLOCK_MONOTONIC);
        work();
        least = std::min(least, seconds_on(CLOCK_MONOTONIC) - begin);
    }
    return least;
}

} // namespace

Table run_raster_benchmark(const RasterOptions& options) {
    constexpr double ms = 1000, wanted = 50;
    const std::array inputs{test::repository("surfaces/concept-car-scene.toml")};
    Scene scene = open_scene(inputs);
    scene.set_picture_size(options.width, options.width * 9 / 16);
    tell("concept-car", "mesh");
    const double begin = seconds_on(CLOCK_MONOTONIC);
    MeshOptions asked;
    asked.deviation = options.deviation;
    asked.load.timeout = std::chrono::hours(1);
    const SurfaceMesh mesh = surface_mesh(scene, asked);
    const double meshing = seconds_on(CLOCK_MONOTONIC) - begin;
    Table table{.head = {"work", "triangles", "wall ms", "of the meshing, %", "wanted ms"}};
    const auto add = [&](const std::string& what, double seconds, const std::string& target) {
        table.rows.push_back({what, std::to_string(mesh.triangles.size()), digits(seconds * ms),
                              digits(100 * seconds / meshing), target});
    };
    add("OpenCASCADE makes the mesh", meshing, "");
    add("z-buffer", least_seconds([&] { z_buffer(mesh, *scene.camera); }), digits(wanted));
    add("z-buffer, one thread",
        least_seconds([&] { z_buffer(mesh, *scene.camera, {.threads = 1}); }), "");
    add("scan line", least_seconds([&] { scan_line(mesh, *scene.camera); }), "");
    add("painter", least_seconds([&] { painted_triangles(mesh, *scene.camera); }, 3), "");
    tell("concept-car", "subdivision");
    add("exact patches, subdivided to the pixel",
        least_seconds([&] { subdivided_faces(scene.model, *scene.camera); }, 1), "");
    return table;
}

} // namespace keiko::bench
