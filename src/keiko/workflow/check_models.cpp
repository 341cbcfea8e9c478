#include "keiko/workflow/check_models.h"

#include "keiko/base/job_steps.h"
#include "keiko/base/text.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/inspect/seams/seam_measure.h"
#include "keiko/scene/view.h"
#include "keiko/workflow/judged_body.h"
#include "keiko/workflow/open_scene.h"
#include "keiko/workflow/painted_body.h"
#include "keiko/workflow/version.h"
#include "keiko/workflow/zoned_limits.h"

#include <numeric>

namespace keiko {

bool has_curves(const CombOptions& options) {
    return !options.planes.empty() || options.iso_curves > 0;
}

Combs combs_of(const SurfaceModel& model, const CombOptions& options, const Job& job) {
    Combs combs;
    FoundCombs found = comb_curves(model, options, job);
    combs.json = combs_json(found, options.planes, model, version());
    combs.remarks = comb_remarks(found, options.planes, model);
    combs.curves = std::move(found.curves);
    combs.csv = combs_csv(combs.curves, model);
    combs.pictures = comb_pictures(combs.curves, options.planes);
    return combs;
}

std::vector<SeamProfile> profiles_of(const SurfaceModel& model, const Inspection& inspection,
                                     std::span<const std::uint32_t> seams, const Job& job) {
    if (seams.empty()) return {};
    return seam_profiles(model, inspection.seams, inspection.pieces, seams, inspection.limits, job);
}

namespace {

constexpr double choosing = 0.5, drawing = 1;

JudgedParts parts_of(const CheckOptions& options) {
    return {options.join, options.joints, options.acceptances};
}

double weight_of_judging(const CheckOptions& options) {
    return choosing + parts_of(options).weight() +
           drawing * (has_curves(options.combs) + options.profiles);
}

CheckResult judged(const SurfaceModel& model, const CheckOptions& options, JobSteps& steps) {
    const FaceLimits limits =
        zoned_limits({model}, options.preset, options.scope, steps.next(choosing));
    CheckResult result{judged_body(model, limits, parts_of(options), steps)};
    if (has_curves(options.combs))
        result.combs = combs_of(model, options.combs, steps.next(drawing));
    if (options.profiles) {
        std::vector<std::uint32_t> all(result.inspection.seams.size());
        std::iota(all.begin(), all.end(), 0u);
        result.profiles = profiles_of(model, result.inspection, all, steps.next(drawing));
    }
    return result;
}

} // namespace

CheckResult check_models(std::span<const std::filesystem::path> inputs, const CheckOptions& options,
                         const Job& job) {
    const SceneSpec spec = spec_of(inputs, SceneOptions{}.material);
    constexpr double reading = 2;
    JobSteps steps(job, reading + weight_of_judging(options));
    return judged(read_body(spec, options.load, steps.next(reading)).model, options, steps);
}

CheckResult check_body(const SurfaceModel& model, const CheckOptions& options, const Job& job) {
    JobSteps steps(job, weight_of_judging(options));
    return judged(model, options, steps);
}

ModelFacts body_info(const SurfaceModel& model, const FactsOptions& options, const Job& job) {
    const std::vector<Seam> seams = pair_seams(model, options.join, job);
    const ModelBorders borders(model);
    ModelFacts facts = model_facts(borders, seams, options.join, job);
    facts.seams = line_count(measure_all_seams(borders, seams, {}, options.join, job).seams);
    if (options.tracing) {
        const Tracer tracer(model, {.second_derivatives = true}, job);
        facts.tracing = timed_trace_facts(tracer.statistics());
    }
    return facts;
}

ModelFacts model_info(const std::filesystem::path& file, const FactsOptions& options,
                      const Job& job) {
    SurfaceModel model = load_model(file, options.load, job);
    if (options.load.axes.empty())
        if (auto remark = axes_remark(material_bounds(model, job)))
            model.diagnostics.push_back(*remark);
    return body_info(model, options, job);
}

} // namespace keiko
