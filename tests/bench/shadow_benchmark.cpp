#include "tests/bench/shadow_benchmark.h"

#include "keiko/raster/light_cone.h"
#include "keiko/raster/mesh_shadows.h"

#include "tests/bench/cpu_clock.h"
#include "tests/bench/progress.h"
#include "tests/bench/sphere_cluster.h"
#include "tests/support/hand_mesh.h"
#include "tests/support/picture_interior.h"
#include "tests/support/sphere_points.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace keiko::bench {
namespace {

constexpr int spheres = 12, side = 256;
constexpr double floor_z = -190;
const Job one_thread{.threads = 1};
const Vec3 lamp(150, -200, 400);

struct ShadowAlgorithm {
    const char* name;
    MeshShadows by;
};
constexpr std::array every_algorithm{
    ShadowAlgorithm{"rays, in a tree", MeshShadows::ray},
    ShadowAlgorithm{"edges on spans of scan lines", MeshShadows::scan_line},
    ShadowAlgorithm{"map of 2048 x 2048", MeshShadows::map},
    ShadowAlgorithm{"polygons on triangles", MeshShadows::polygons},
    ShadowAlgorithm{"volumes before pixels", MeshShadows::volumes}};

SurfaceMesh over_floor(const SphereCluster& cluster, int cells) {
    SurfaceMesh mesh = cluster.mesh(cells);
    constexpr double far = 600;
    const Vec3 a(-far, -far, floor_z), b(far, -far, floor_z), c(far, far, floor_z),
        d(-far, far, floor_z);
    test::add_triangle(mesh, {a, b, c}, 0);
    test::add_triangle(mesh, {a, c, d}, 0);
    return mesh;
}

/// Pixels that differ, everywhere and off the edges of shadows.
struct Differences {
    std::size_t all = 0, inside = 0;

    Differences(const Image& truth, const Image& other) {
        for (int y = 1; y + 1 < side; ++y)
            for (int x = 1; x + 1 < side; ++x) {
                if (*truth.pixel(x, y) == *other.pixel(x, y)) continue;
                ++all, inside += test::is_inside(truth, x, y) ? 1 : 0;
            }
    }
};

/// Pixels of the floor whose light is other than past the exact spheres.
std::size_t wrong_on_floor(const MeshView& view, const SphereCluster& cluster, const Image& lit) {
    std::size_t wrong = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const auto place = view.at(x, y);
            if (!place || std::abs(place->position.z - floor_z) > 1e-6) continue;
            Ray ray;
            ray.origin = place->position, ray.direction = (lamp - ray.origin).normalized();
            const bool dark = cluster.first(ray).has_value();
            wrong += dark != (*lit.pixel(x, y) == 0) ? 1 : 0;
        }
    return wrong;
}

/// Root of the mean square of differences where a picture has penumbrae.
double rms_in_penumbra(const Image& truth, const Image& other) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < truth.values.size(); ++i) {
        const double share = double{truth.values[i]}, off = double{other.values[i]} - share;
        if (share > 0 && share < 1) sum += off * off, ++count;
    }
    return std::sqrt(sum / count);
}

void add_sharp(const SphereCluster& cluster, int cells, Table& table) {
    const SurfaceMesh mesh = over_floor(cluster, cells);
    const Camera camera = SphereCluster::camera(side);
    const MeshView view(mesh, camera);
    const ShadowCasters casters(mesh);
    const Viewpoint light = Viewpoint::at(lamp);
    const Image truth = lit_pixels(view, casters, light, MeshShadows::ray);
    for (const ShadowAlgorithm& algorithm : every_algorithm) {
        tell(algorithm.name, std::to_string(mesh.triangles.size()) + " triangles");
        Image lit;
        const double seconds = process_seconds(
            [&] { lit = lit_pixels(view, casters, light, algorithm.by, one_thread); });
        const Differences off(truth, lit);
        table.rows.push_back({algorithm.name, std::to_string(mesh.triangles.size()),
                              digits(seconds * 1000), std::to_string(off.all),
                              std::to_string(off.inside),
                              std::to_string(wrong_on_floor(view, cluster, lit)), "–"});
    }
}

void add_area(const SphereCluster& cluster, int cells, bool brief, Table& table) {
    const SurfaceMesh mesh = over_floor(cluster, cells);
    const Camera camera = SphereCluster::camera(side);
    const MeshView view(mesh, camera);
    const ShadowCasters casters(mesh);
    const LightSphere sphere{lamp, 40};
    tell("sphere of light", "cones and points");
    const Image truth = lit_by_cones(view, casters, sphere, {}, brief ? 32 : 256);
    const auto add = [&](const std::string& name, const auto& find) {
        Image lit;
        const double seconds = process_seconds([&] { lit = find(); });
        table.rows.push_back({name, std::to_string(mesh.triangles.size()), digits(seconds * 1000),
                              "–", "–", "–", digits(rms_in_penumbra(truth, lit))});
    };
    for (const int chords : {4, 16})
        add("cone to a sphere, " + std::to_string(chords) + " lines",
            [&] { return lit_by_cones(view, casters, sphere, one_thread, chords); });
    for (const int count : {16, 64, 256}) {
        if (brief && count > 16) continue;
        add("sphere by " + std::to_string(count) + " points, rays", [&] {
            return lit_pixels(view, casters, test::points_of(sphere, count), MeshShadows::ray,
                              one_thread);
        });
    }
}

} // namespace

Table shadow_table(bool brief) {
    Table table{.head = {"shadows by", "triangles", "ms", "pixels unlike rays", "off edges",
                         "wrong on the floor", "RMS in penumbrae"}};
    const SphereCluster cluster(spheres);
    for (const int cells : brief ? std::vector{3} : std::vector{6, 24})
        add_sharp(cluster, cells, table);
    add_area(cluster, brief ? 3 : 12, brief, table);
    return table;
}

} // namespace keiko::bench
