#include "keiko/keiko.h"

namespace keiko {

ModelFacts file_facts(const std::filesystem::path& file, const FactsOptions& options,
                      const Job& job) {
    const SurfaceModel model = load_model(file, options.load, job);
    ModelFacts facts = model_facts(model, pair_seams(model, options.join, job), options.join, job);
    if (options.tracing) {
        const Tracer tracer(model, {.second_derivatives = true}, job);
        facts.tracing = timed_trace_facts(tracer.statistics());
    }
    return facts;
}

} // namespace keiko
