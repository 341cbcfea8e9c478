#include "tests/bench/hidden_benchmark.h"

#include "keiko/raster/painter.h"
#include "keiko/raster/patch_subdivision.h"
#include "keiko/raster/scan_line.h"
#include "keiko/raster/z_buffer.h"

#include "tests/bench/cpu_clock.h"
#include "tests/bench/heap_peak.h"
#include "tests/bench/hidden_peers.h"
#include "tests/bench/progress.h"
#include "tests/bench/sphere_cluster.h"
#include "tests/support/picture_interior.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>

namespace keiko::bench {
namespace {

constexpr int spheres = 12, middle_cells = 6, middle_side = 256;
const Job one_thread{.threads = 1};

/// Spheres and a camera.
struct HiddenScene {
    SurfaceMesh mesh{};
    SurfaceModel model{};
    Camera camera{};
    ItemBuffer truth; ///< the sphere of each pixel
};

/// An algorithm: the sphere of each pixel; nullopt if it finds no pixels.
struct Algorithm {
    const char* name;
    const char* kind;
    std::function<std::optional<ItemBuffer>(const HiddenScene&)> run;
    std::size_t most_work; ///< triangles times triangles or pixels that it is given
    bool takes_triangles = true;
};

/// Algorithm of a function that finds the triangles of pixels.
template <class Find>
auto by_triangles(const Find& find) {
    return [find](const HiddenScene& scene) -> std::optional<ItemBuffer> {
        return faces_of(scene.mesh, find(scene.mesh, scene.camera, one_thread));
    };
}

std::vector<Algorithm> algorithms() {
    const auto edges = [](const HiddenScene& scene) -> std::optional<ItemBuffer> {
        visible_edges(scene.mesh, scene.camera);
        return std::nullopt;
    };
    const auto cast = [](const SurfaceMesh& mesh, const Camera& camera, const Job&) {
        return cast_triangles(mesh, camera);
    };
    const auto subdivide = [](const HiddenScene& scene) -> std::optional<ItemBuffer> {
        return subdivided_faces(scene.model, scene.camera, one_thread);
    };
    constexpr std::size_t any = std::numeric_limits<std::size_t>::max(), few = 500'000'000;
    return {{"edges against triangles", "object space", edges, 50'000'000},
            {"rays against triangles", "image space", by_triangles(cast), few},
            {"z-buffer", "image space", by_triangles(z_buffer), any},
            {"scan line", "image space", by_triangles(scan_line), any},
            {"patches divided to the pixel", "image space", subdivide, any, false},
            {"painter, by a tree", "list priority", by_triangles(painted_triangles), any}};
}

HiddenScene scene_of(int cells, int side) {
    const SphereCluster cluster(spheres);
    const Camera camera = SphereCluster::camera(side);
    return {cluster.mesh(cells), cluster.model(), camera, cluster.seen(camera)};
}

HiddenCost cost_of(const Algorithm& algorithm, const HiddenScene& scene) {
    HiddenCost cost{scene.mesh.triangles.size(), scene.camera.width};
    cost.seconds = std::numeric_limits<double>::infinity();
    std::optional<ItemBuffer> seen;
    cost.bytes = static_cast<double>(heap_peak([&] { seen = algorithm.run(scene); }));
    for (int round = 0; round < 3; ++round)
        cost.seconds = std::min(cost.seconds, process_seconds([&] { algorithm.run(scene); }));
    if (seen) cost.wrong = test::wrong_inside(scene.truth, *seen);
    return cost;
}

bool suits(const Algorithm& algorithm, const HiddenScene& scene) {
    const std::size_t n = scene.mesh.triangles.size(), pixels = scene.truth.shown.size();
    const bool by_pixels = std::string(algorithm.kind) != "object space";
    return n * (by_pixels ? pixels : n) <= algorithm.most_work;
}

/// The power of x that y grows with, from the first point to the last.
double power(const std::vector<std::array<double, 2>>& points) {
    if (points.size() < 2) return std::numeric_limits<double>::quiet_NaN();
    const auto &a = points.front(), &b = points.back();
    return std::log(b[1] / a[1]) / std::log(b[0] / a[0]);
}

std::vector<std::array<double, 2>> points_of(const std::vector<HiddenCost>& costs, bool pixels,
                                             double HiddenCost::*value) {
    std::vector<std::array<double, 2>> points;
    for (const HiddenCost& cost : costs)
        points.push_back({pixels ? static_cast<double>(cost.side) * cost.side
                                 : static_cast<double>(cost.triangles),
                          cost.*value});
    return points;
}

LogPlot plot_of(const std::vector<HiddenSeries>& series, bool pixels, double HiddenCost::*value,
                const std::string& what) {
    LogPlot plot{pixels ? "pixels" : "triangles", what, {}};
    for (std::size_t i = 0; i < series.size(); ++i) {
        const auto& costs = pixels ? series[i].over_pixels : series[i].over_triangles;
        if (costs.size() > 1)
            plot.curves.push_back({series[i].name, points_of(costs, pixels, value), i});
    }
    return plot;
}

} // namespace

std::vector<HiddenSeries> run_hidden_benchmark(const HiddenOptions& options) {
    const std::vector<Algorithm> all = algorithms();
    std::vector<HiddenSeries> series;
    for (const Algorithm& algorithm : all) series.push_back({algorithm.name, algorithm.kind});
    const auto measure = [&](int cells, int side, std::vector<HiddenCost> HiddenSeries::*list) {
        tell("spheres", std::to_string(cells) + " cells, " + std::to_string(side) + " pixels");
        const HiddenScene scene = scene_of(cells, side);
        for (std::size_t i = 0; i < all.size(); ++i)
            if (suits(all[i], scene)) (series[i].*list).push_back(cost_of(all[i], scene));
    };
    std::vector<int> cells{3, 6, 12, 24, 48}, sides{64, 128, 256, 512, 1024};
    if (options.brief) cells.resize(2), sides.resize(2);
    for (const int n : cells) measure(n, middle_side, &HiddenSeries::over_triangles);
    for (const int side : sides) measure(middle_cells, side, &HiddenSeries::over_pixels);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!all[i].takes_triangles) series[i].over_triangles.resize(1);
        if (std::string(all[i].kind) == "object space") series[i].over_pixels.clear();
    }
    return series;
}

Table hidden_table(const std::vector<HiddenSeries>& series) {
    constexpr double ms = 1000, megabyte = 1e6;
    Table table{.head = {"algorithm", "class", "triangles", "ms", "MB", "wrong pixels",
                         "time grows with triangles to the", "with pixels to the"},
                .left = 2};
    for (const HiddenSeries& one : series) {
        const HiddenCost& cost = one.over_triangles[one.over_triangles.size() > 1 ? 1 : 0];
        const auto grows = [&](bool pixels) {
            return digits(power(points_of(pixels ? one.over_pixels : one.over_triangles, pixels,
                                          &HiddenCost::seconds)));
        };
        const bool has_pixels = !one.over_pixels.empty();
        table.rows.push_back({one.name, one.kind,
                              one.over_triangles.size() > 1 ? std::to_string(cost.triangles) : "–",
                              digits(cost.seconds * ms), digits(cost.bytes / megabyte),
                              has_pixels ? std::to_string(cost.wrong) : "–", grows(false),
                              has_pixels ? grows(true) : "–"});
    }
    return table;
}

std::vector<LogPlot> hidden_plots(const std::vector<HiddenSeries>& series) {
    return {plot_of(series, false, &HiddenCost::seconds, "processor seconds"),
            plot_of(series, true, &HiddenCost::seconds, "processor seconds"),
            plot_of(series, false, &HiddenCost::bytes, "bytes"),
            plot_of(series, true, &HiddenCost::bytes, "bytes")};
}

} // namespace keiko::bench
