#include "tests/bench/shafts_benchmark.h"

#include "keiko/import/worker/load_model.h"

#include "tests/bench/cpu_clock.h"
#include "tests/support/paths.h"
#include "tests/support/shaft_trial.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keiko::bench {
namespace {

using test::Marching;
using test::ShaftTrial;

constexpr int tiles = 3, tile_size = 32; ///< px, as pictures are made
constexpr double picture_rays = 960 * 540;

/// `count` spheres in a block, as large altogether whatever their number.
SurfaceModel spheres(int across, int high) {
    SurfaceModel model = load_model(test::repository("surfaces/rational-sphere.step"));
    const std::vector<Instance> octants = std::exchange(model.instances, {});
    const double pitch = 2400.0 / across, scale = 0.35 * pitch / 100;
    for (int i = 0; i < across; ++i)
        for (int j = 0; j < across; ++j)
            for (int k = 0; k < high; ++k)
                for (Instance placed : octants) {
                    const Affine move = Affine::translate(Vec3(i, j, k) * pitch);
                    placed.transform = move * Affine::scale(scale) * placed.transform;
                    model.instances.push_back(placed);
                }
    return model;
}

ShaftError error_of(std::span<const Rgb> light, std::span<const Rgb> reference) {
    double off = 0, squares = 0, sum = 0;
    for (std::size_t i = 0; i < light.size(); ++i) {
        const double difference = std::abs(light[i].g - reference[i].g);
        off += difference;
        squares += difference * difference;
        sum += reference[i].g;
    }
    const double count = static_cast<double>(light.size()), least = 0.05 * sum / count;
    std::vector<double> shares;
    for (std::size_t i = 0; i < light.size(); ++i)
        shares.push_back(std::abs(light[i].g - reference[i].g) / std::max(reference[i].g, least));
    std::sort(shares.begin(), shares.end());
    return {off / sum, std::sqrt(squares * count) / sum, shares[shares.size() * 99 / 100]};
}

/// Marching of a sample of the rays, until it is good enough.
class Marcher {
public:
    Marcher(const ShaftTrial& trial, std::span<const Segment> rays, std::span<const Rgb> reference,
            std::size_t count)
        : trial_(trial) {
        const std::size_t stride = std::max<std::size_t>(1, rays.size() / count);
        for (std::size_t i = stride / 2; i < rays.size(); i += stride) {
            rays_.push_back(rays[i]);
            reference_.push_back(reference[i]);
        }
    }

    /// The cheapest for each error.
    void find_best(ShaftCost& cost) const {
        for (const Marching marching : {Marching::even, Marching::equi_angular}) {
            constexpr double least = 16, most = 16384;
            MarchingCost mean, rms, rays;
            const auto reach = [](MarchingCost& goal, const MarchingCost& marched, double error) {
                if (!goal.reached) goal = marched, goal.reached = error <= shaft_error;
            };
            for (double steps = least; steps < most && !(rms.reached && rays.reached);
                 steps *= std::sqrt(2)) {
                const auto [marched, error] = measured(static_cast<int>(steps), marching);
                reach(mean, marched, error.mean);
                reach(rms, marched, error.rms);
                reach(rays, marched, error.most_rays);
            }
            keep_cheaper(cost.to_mean, mean);
            keep_cheaper(cost.to_rms, rms);
            keep_cheaper(cost.to_most_rays, rays);
        }
    }

private:
    struct Measured {
        MarchingCost cost;
        ShaftError error;
    };

    Measured measured(int steps, Marching marching) const {
        std::vector<Rgb> light;
        const double seconds = thread_seconds([&] {
            for (const Segment& ray : rays_) light.push_back(trial_.marched(ray, steps, marching));
        });
        const double microseconds = 1e6 * seconds / static_cast<double>(rays_.size());
        return {{microseconds, steps, marching == Marching::equi_angular, false},
                error_of(light, reference_)};
    }
    static void keep_cheaper(MarchingCost& best, const MarchingCost& other) {
        const bool first = best.steps == 0, cheaper = other.microseconds < best.microseconds;
        if (first || other.reached > best.reached || (other.reached == best.reached && cheaper))
            best = other;
    }

    const ShaftTrial& trial_;
    std::vector<Segment> rays_;
    std::vector<Rgb> reference_;
};

ShaftCost measure(std::string bodies, const SurfaceModel& model, int lamps,
                  std::size_t marched_rays) {
    const ShaftTrial trial(model, lamps);
    ShaftCost cost{.bodies = std::move(bodies), .lamps = lamps};
    for (const Instance& instance : model.instances) {
        const Part& part = model.parts[instance.part];
        for (std::uint32_t f = 0; f < part.face_count; ++f)
            cost.patches += model.faces[part.first_face + f].patch_count;
    }
    cost.build_seconds = trial.occluders().statistics().build_seconds;
    std::vector<std::optional<EpipolarShadows>> pencils;
    cost.pencil_seconds = process_seconds([&] { pencils = trial.pencils(); }) / lamps;
    std::vector<Segment> rays;
    std::vector<Rgb> reference, light;
    double seconds = 0;
    for (int tile = 0; tile < tiles; ++tile) {
        const std::vector<Segment> some =
            trial.camera_rays(Vec2(0.3 + 0.4 * (tile + 0.5) / tiles, 0.57), tile_size);
        const std::vector<Rgb> good = trial.exact(some, 1e-8);
        std::vector<Rgb> quick;
        seconds += thread_seconds([&] { quick = trial.exact(some, shaft_error, pencils); });
        rays.insert(rays.end(), some.begin(), some.end());
        reference.insert(reference.end(), good.begin(), good.end());
        light.insert(light.end(), quick.begin(), quick.end());
    }
    cost.exact = 1e6 * (seconds / static_cast<double>(rays.size()) +
                        cost.pencil_seconds * lamps / picture_rays);
    cost.exact_error = error_of(light, reference);
    Marcher(trial, rays, reference, marched_rays).find_best(cost);
    return cost;
}

} // namespace

std::vector<ShaftCost> run_shafts_benchmark(std::size_t marched_rays) {
    std::vector<ShaftCost> costs;
    const SurfaceModel car = load_model(test::repository("surfaces/concept-car.step"));
    for (const int lamps : {1, 2, 4, 8, 16})
        costs.push_back(measure("concept car", car, lamps, marched_rays));
    for (const auto& [across, high] : {std::pair(2, 1), {4, 1}, {8, 2}, {16, 2}}) {
        const int count = across * across * high;
        costs.push_back(
            measure(std::to_string(count) + " spheres", spheres(across, high), 4, marched_rays));
    }
    return costs;
}

namespace {

std::string steps_of(const MarchingCost& cost) {
    return std::to_string(cost.steps) + (cost.equi_angular ? " in angle" : " even") +
           (cost.reached ? "" : ", not reached");
}

} // namespace

Table shafts_table(const std::vector<ShaftCost>& costs) {
    Table table;
    table.head = {"bodies",  "patches",  "lamps", "made ready, s", "a lamp, ms", "Keiko µs",
                  "error",   "mean: µs", "steps", "× Keiko",       "RMS: µs",    "steps",
                  "× Keiko", "99 %: µs", "steps", "× Keiko"};
    for (const ShaftCost& c : costs) {
        std::vector<std::string> row{c.bodies,
                                     std::to_string(c.patches),
                                     std::to_string(c.lamps),
                                     digits(c.build_seconds),
                                     digits(1e3 * c.pencil_seconds),
                                     digits(c.exact),
                                     digits(c.exact_error.most_rays)};
        for (const MarchingCost& marched : {c.to_mean, c.to_rms, c.to_most_rays})
            row.insert(row.end(), {digits(marched.microseconds), steps_of(marched),
                                   digits(marched.microseconds / c.exact)});
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::vector<LogPlot> shafts_plots(const std::vector<ShaftCost>& costs) {
    LogPlot lamps{.x = "lamps on the car", .y = "µs a ray"};
    LogPlot patches{.x = "patches, spheres under 4 lamps", .y = "µs a ray"};
    for (LogPlot* plot : {&lamps, &patches})
        for (const char* name : {"marching, 99 % of rays", "marching, RMS", "visible intervals"})
            plot->curves.push_back({.name = name});
    for (const ShaftCost& c : costs) {
        const bool is_car = c.bodies == "concept car";
        LogPlot& plot = is_car ? lamps : patches;
        const double x = is_car ? c.lamps : static_cast<double>(c.patches);
        plot.curves[0].points.push_back({x, c.to_most_rays.microseconds});
        plot.curves[1].points.push_back({x, c.to_rms.microseconds});
        plot.curves[2].points.push_back({x, c.exact});
    }
    return {lamps, patches};
}

} // namespace keiko::bench
