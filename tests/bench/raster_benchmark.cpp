#include "tests/bench/raster_benchmark.h"

#include "keiko/api/model.h"
#include "keiko/api/scene.h"
#include "keiko/raster/scan_line.h"
#include "keiko/raster/z_buffer.h"

#include "tests/bench/cpu_clock.h"
#include "tests/bench/progress.h"
#include "tests/support/paths.h"

#include <algorithm>
#include <array>
#include <limits>

namespace keiko::bench {
namespace {

constexpr int most_rounds = 9; // the least counts: the rest is other programs on the machine

/// Seconds of a piece of work.
struct Seconds {
    double wall = std::numeric_limits<double>::infinity(); ///< on the clock
    double processor = 0;                                  ///< of all threads
};

/// The soonest of several rounds.
template <class Work>
Seconds least_seconds(const Work& work, int rounds = most_rounds) {
    Seconds least;
    for (int i = 0; i < rounds; ++i) {
        const double begin = seconds_on(CLOCK_MONOTONIC);
        const double processor = process_seconds(work);
        const double wall = seconds_on(CLOCK_MONOTONIC) - begin;
        if (wall < least.wall) least = {wall, processor};
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
    MeshOptions asked;
    asked.deviation = options.deviation, asked.mesher = Mesher::spans;
    SurfaceMesh mesh;
    const Seconds meshing = least_seconds([&] { mesh = surface_mesh(scene, asked); }, 1);
    Table table{.head = {"work", "triangles", "wall ms", "processor ms", "wanted ms"}};
    const auto add = [&](const std::string& what, const Seconds& seconds,
                         const std::string& target) {
        table.rows.push_back({what, std::to_string(mesh.triangles.size()),
                              digits(seconds.wall * ms), digits(seconds.processor * ms), target});
    };
    add("the mesh, by spans, with its normals", meshing, "");
    add("z-buffer", least_seconds([&] { z_buffer(mesh, *scene.camera); }), digits(wanted));
    add("z-buffer, one thread",
        least_seconds([&] { z_buffer(mesh, *scene.camera, {.threads = 1}); }), "");
    add("scan line", least_seconds([&] { scan_line(mesh, *scene.camera); }), "");
    return table;
}

} // namespace keiko::bench
