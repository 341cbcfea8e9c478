#include "tests/bench/peer_rays.h"

#include "keiko/intersect/traversal/tracer.h"
#include "keiko/raster/z_buffer.h"

#include "tests/bench/cpu_clock.h"
#include "tests/bench/progress.h"
#include "tests/bench/sphere_cluster.h"
#include "tests/bench/uniform_grid.h"
#include "tests/bench/whitted_patches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace keiko::bench {
namespace {

constexpr double microsecond = 1e6, millisecond = 1e3;

/// Lengths along rays to their first hits.
using FirstLengths = std::vector<std::optional<double>>;

/// Findings of a peer, and its cost.
struct PeerRays {
    std::string name;
    double seconds = 0;
    FirstLengths found{};
};

template <class First>
PeerRays measured(const std::string& name, const std::vector<Ray>& rays, const First& first) {
    PeerRays peer{name};
    peer.found.resize(rays.size());
    peer.seconds = process_seconds([&] {
        for (std::size_t i = 0; i < rays.size(); ++i) peer.found[i] = first(rays[i]);
    });
    return peer;
}

std::vector<std::string> row_of(int spheres, const PeerRays& peer, const FirstLengths& truth) {
    double error = 0;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < truth.size(); ++i)
        if (truth[i] && peer.found[i])
            error = std::max(error, std::abs(*truth[i] - *peer.found[i]));
        else if (truth[i].has_value() != peer.found[i].has_value())
            ++wrong;
    const auto count = static_cast<double>(truth.size());
    return {peer.name, std::to_string(spheres), digits(peer.seconds / count * microsecond),
            digits(error), share(wrong, truth.size())};
}

std::vector<Ray> rays_of(int side) {
    const PreparedCamera camera(SphereCluster::camera(side));
    std::vector<Ray> rays;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) rays.push_back(camera.ray(x + 0.5, y + 0.5));
    return rays;
}

void add_peers(int spheres, int side, Table& table) {
    tell(std::to_string(spheres) + " spheres", "rays");
    const SphereCluster cluster(spheres);
    const SurfaceModel model = cluster.model();
    const Tracer tracer(model);
    const WhittedPatches patches(model, 1e-3);
    const SurfaceMesh mesh = cluster.mesh(24);
    const UniformGrid grid(mesh);
    const std::vector<Ray> rays = rays_of(side);
    const auto quadratic = measured("quadratic of each sphere", rays, [&](const Ray& ray) {
        const auto met = cluster.first(ray);
        return met ? std::optional(met->t) : std::nullopt;
    });
    const auto traced = measured("Keiko, one ray at a time", rays, [&](const Ray& ray) {
        const auto hit = tracer.nearest(ray);
        return hit ? std::optional(hit->t) : std::nullopt;
    });
    const auto divided = measured("patches in four, to spheres of 1e-3 mm", rays,
                                  [&](const Ray& ray) { return patches.first(ray); });
    const auto crossed =
        measured("uniform grid, " + std::to_string(mesh.triangles.size()) + " triangles", rays,
                 [&](const Ray& ray) { return grid.first(ray); });
    for (const PeerRays& peer : {quadratic, traced, divided, crossed})
        table.rows.push_back(row_of(spheres, peer, quadratic.found));
}

/// The least time on the clock, with a number of threads.
template <class Work>
double wall_seconds(const Work& work, int threads) {
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 9; ++round) {
        const double begin = seconds_on(CLOCK_MONOTONIC);
        work(Job{.threads = threads});
        least = std::min(least, seconds_on(CLOCK_MONOTONIC) - begin);
    }
    return least;
}

} // namespace

Table peer_ray_table(bool brief) {
    Table table{
        .head = {"rays by", "spheres", "µs a ray", "largest error, mm", "hit or miss is wrong"}};
    for (const int spheres : {12, 96}) add_peers(spheres, brief ? 16 : 96, table);
    return table;
}

Table thread_table(bool brief) {
    const SurfaceMesh mesh = SphereCluster(12).mesh(brief ? 12 : 96);
    const Camera camera = SphereCluster::camera(brief ? 64 : 1024);
    const auto work = [&](const Job& job) { z_buffer(mesh, camera, job); };
    Table table{.head = {"z-buffer, threads", "triangles", "wall ms", "speed-up"}};
    const double one = wall_seconds(work, 1);
    for (const int threads : {1, 2}) {
        const double seconds = threads == 1 ? one : wall_seconds(work, threads);
        table.rows.push_back({std::to_string(threads), std::to_string(mesh.triangles.size()),
                              digits(seconds * millisecond), digits(one / seconds)});
    }
    return table;
}

} // namespace keiko::bench
