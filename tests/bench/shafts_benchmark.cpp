#include "tests/bench/shafts_benchmark.h"

#include "keiko/io/load_model.h"

#include "tests/bench/cpu_clock.h"
#include "tests/support/paths.h"
#include "tests/support/shaft_trial.h"

#include <algorithm>
#include <cmath>

namespace keiko::bench {
namespace {

using test::Marching;
using test::ShaftTrial;

constexpr int tiles = 3, tile_size = 32; ///< px, as pictures are made

/// `count` spheres in a block, as large altogether whatever their number.
SurfaceModel spheres(int across, int high) {
    SurfaceModel model = load_model(test::repository("surfaces/rational-sphere.step"));
    const Instance first = model.instances.front();
    model.instances.clear();
    const double pitch = 2400.0 / across, scale = 0.35 * pitch / 100;
    for (int i = 0; i < across; ++i)
        for (int j = 0; j < across; ++j)
            for (int k = 0; k < high; ++k) {
                Instance placed = first;
                placed.transform = Affine::translate(Vec3(i, j, k) * pitch) * Affine::scale(scale) *
                                   first.transform;
                model.instances.push_back(placed);
            }
    return model;
}

/// Of many rays: mean distance from the reference over its mean.
double error_of(std::span<const Rgb> light, std::span<const Rgb> reference) {
    double off = 0, sum = 0;
    for (std::size_t i = 0; i < light.size(); ++i) {
        off += std::abs(light[i].g - reference[i].g);
        sum += reference[i].g;
    }
    return off / sum;
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

    /// Keeps the cheapest that reaches the error in `cost`.
    void find_best(ShaftCost& cost) const {
        cost.reached = false;
        for (const Marching marching : {Marching::even, Marching::equi_angular}) {
            constexpr int most = 8192;
            double steps = 16;
            ShaftCost found = measured(cost, static_cast<int>(steps), marching);
            while (found.marched_error > shaft_error && steps < most) {
                steps *= std::sqrt(2);
                found = measured(cost, static_cast<int>(steps), marching);
            }
            found.reached = found.marched_error <= shaft_error;
            if (found.reached && (!cost.reached || found.marched < cost.marched)) cost = found;
            if (!found.reached && !cost.reached) cost = found;
        }
    }

private:
    ShaftCost measured(ShaftCost cost, int steps, Marching marching) const {
        std::vector<Rgb> light;
        const double seconds = thread_seconds([&] {
            for (const Segment& ray : rays_) light.push_back(trial_.marched(ray, steps, marching));
        });
        cost.marched = 1e6 * seconds / static_cast<double>(rays_.size());
        cost.marched_error = error_of(light, reference_);
        cost.steps = steps;
        cost.equi_angular = marching == Marching::equi_angular;
        return cost;
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
    std::vector<Segment> rays;
    std::vector<Rgb> reference, light;
    double seconds = 0;
    for (int tile = 0; tile < tiles; ++tile) {
        const std::vector<Segment> some = trial.eye_rays((tile + 0.5) / tiles, tile_size);
        const std::vector<Rgb> good = trial.exact(some, 1e-8);
        std::vector<Rgb> quick;
        seconds += thread_seconds([&] { quick = trial.exact(some, shaft_error); });
        rays.insert(rays.end(), some.begin(), some.end());
        reference.insert(reference.end(), good.begin(), good.end());
        light.insert(light.end(), quick.begin(), quick.end());
    }
    cost.exact = 1e6 * seconds / static_cast<double>(rays.size());
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
    for (const auto& [across, high] : {std::pair(1, 1), {2, 1}, {4, 1}, {8, 2}, {16, 2}}) {
        const int count = across * across * high;
        costs.push_back(measure(std::to_string(count) + (count == 1 ? " sphere" : " spheres"),
                                spheres(across, high), 4, marched_rays));
    }
    return costs;
}

Table shafts_table(const std::vector<ShaftCost>& costs) {
    Table table;
    table.head = {"bodies", "patches",           "lamps", "made ready, s", "Keiko µs a ray",
                  "error",  "marching µs a ray", "error", "steps",         "times as much"};
    for (const ShaftCost& c : costs)
        table.rows.push_back({c.bodies, std::to_string(c.patches), std::to_string(c.lamps),
                              digits(c.build_seconds), digits(c.exact), digits(c.exact_error),
                              digits(c.marched), digits(c.marched_error),
                              std::to_string(c.steps) + (c.equi_angular ? " in angle" : " even") +
                                  (c.reached ? "" : ", not reached"),
                              digits(c.marched / c.exact)});
    return table;
}

std::vector<CostPanel> shafts_panels(const std::vector<ShaftCost>& costs) {
    CostPanel lamps{.title = "concept car, 185 patches", .across = "lamps"};
    CostPanel patches{.title = "spheres under 4 lamps", .across = "patches"};
    for (CostPanel* panel : {&lamps, &patches})
        panel->lines = {{.name = "marching", .points = {}},
                        {.name = "visible intervals", .points = {}}};
    for (const ShaftCost& c : costs) {
        const bool is_car = c.bodies == "concept car";
        CostPanel& panel = is_car ? lamps : patches;
        const double x = is_car ? c.lamps : static_cast<double>(c.patches);
        panel.lines[0].points.emplace_back(x, c.marched);
        panel.lines[1].points.emplace_back(x, c.exact);
    }
    return {lamps, patches};
}

} // namespace keiko::bench
