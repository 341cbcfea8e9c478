#include "keiko/workflow/model_info.h"

#include "keiko/base/text.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/inspect/seams/seam_measure.h"
#include "keiko/scene/view.h"

namespace keiko {

ModelFacts model_info(const std::filesystem::path& file, const FactsOptions& options,
                      const Job& job) {
    SurfaceModel model = load_model(file, options.load, job);
    if (options.load.axes.empty())
        if (auto remark = axes_remark(material_bounds(model, job)))
            model.diagnostics.push_back(*remark);
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

} // namespace keiko
