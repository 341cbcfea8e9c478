#include "tests/bench/trace_benchmark.h"

#include "tests/bench/contenders.h"
#include "tests/bench/cpu_clock.h"
#include "tests/bench/place_tolerance.h"
#include "tests/bench/progress.h"
#include "tests/bench/ray_classes.h"
#include "tests/bench/summary.h"
#include "tests/bench/trimming_cost.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace keiko::bench {
namespace {

/// A contender in one mode at work on one class.
struct Lane {
    const Contender* contender;
    Mode mode;
    std::unique_ptr<Pass> pass;
    std::size_t rays; ///< that it traces
    std::vector<double> rates{};
    std::optional<Accuracy> accuracy{};

    /// Rays per second.
    double timed() {
        pass->reset();
        return static_cast<double>(rays) / thread_seconds([&] { pass->run(); });
    }
};

std::vector<Lane> lanes_of(const Contenders& contenders, const RaySet& rays) {
    std::vector<Lane> lanes;
    for (const auto& contender : contenders)
        for (const Mode mode : contender->modes()) {
            std::unique_ptr<Pass> pass = contender->pass(rays, mode);
            const std::size_t stride = pass->stride();
            lanes.push_back(
                {contender.get(), mode, std::move(pass), (rays.rays.size() + stride - 1) / stride});
        }
    return lanes;
}

void warm_up(Lane& lane, const RaySet& rays, const Box3& bounds) {
    lane.timed();
    const Answers answers = lane.pass->answers();
    if (!answers.empty())
        lane.accuracy = judged(rays, answers, lane.pass->stride(),
                               place_tolerance(lane.contender->facts(), bounds));
}

const std::vector<double>& rates_of(const std::vector<Lane>& lanes, Kind kind, Mode mode) {
    return std::find_if(lanes.begin(), lanes.end(),
                        [&](const Lane& lane) {
                            return lane.contender->facts().kind == kind && lane.mode == mode;
                        })
        ->rates;
}

double median_ratio(const std::vector<double>& ours, const std::vector<double>& theirs) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < ours.size(); ++i) ratios.push_back(ours[i] / theirs[i]);
    return median(std::move(ratios));
}

ClassResult measure(const RaySet& rays, const Contenders& contenders, const Box3& bounds,
                    int rounds) {
    std::vector<Lane> lanes = lanes_of(contenders, rays);
    for (Lane& lane : lanes) warm_up(lane, rays, bounds);
    for (int round = 0; round < rounds; ++round)
        for (Lane& lane : lanes) lane.rates.push_back(lane.timed());

    ClassResult result{.name = rays.name, .rays = rays.rays.size()};
    for (const std::optional<Hit>& hit : rays.truth) {
        result.hits += hit.has_value();
        result.tangential += hit && has(hit->flags, HitFlags::tangential);
    }
    for (const Lane& lane : lanes) {
        const ContenderFacts& facts = lane.contender->facts();
        const auto times = [&](Kind kind, Mode mode) {
            return median_ratio(rates_of(lanes, kind, mode), lane.rates);
        };
        result.measurements.push_back({facts.kind, facts.name, lane.mode, median(lane.rates),
                                       times(Kind::keiko, Mode::single),
                                       times(Kind::keiko, Mode::packets),
                                       times(Kind::crossings, lane.mode), lane.accuracy});
    }
    return result;
}

SceneResult measure(const SceneFile& scene, const TraceOptions& options) {
    tell(scene.name, "reading");
    const SurfaceModel model = scene.load();
    const Tracer truth(model, {.second_derivatives = true});
    tell(scene.name, "true hits");
    const std::vector<RaySet> classes = ray_classes(model, truth, options.rays);
    const Contenders contenders = contenders_of(scene, model, classes.front(), options);

    SceneResult result{.name = scene.name,
                       .free_form = scene.free_form,
                       .faces = model.faces.size(),
                       .patches = model.patches.size(),
                       .size = truth.bounds().size()};
    for (const auto& contender : contenders) result.contenders.push_back(contender->facts());
    for (const RaySet& rays : classes) {
        if (rays.rays.empty()) continue;
        tell(scene.name, rays.name + " rays");
        result.classes.push_back(measure(rays, contenders, truth.bounds(), options.rounds));
        if (!options.alone) result.classes.back().costs = kernel_costs(model, rays, options.rounds);
    }
    return result;
}

} // namespace

TraceResults run_trace_benchmark(const TraceOptions& options) {
    TraceResults results{.machine = this_machine(), .rays = options.rays, .rounds = options.rounds};
    for (const SceneFile& scene : chosen_scenes(options.scenes)) {
        if (scene.present())
            results.scenes.push_back(measure(scene, options));
        else
            results.skipped.push_back(scene.name);
    }
    if (!options.alone) results.trimming_cost = trimming_cost(options.rounds);
    return results;
}

} // namespace keiko::bench
