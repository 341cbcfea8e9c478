#include "keiko/workflow/check_models.h"

#include "keiko/compare/shape/symmetry.h"
#include "keiko/workflow/open_scene.h"
#include "keiko/workflow/painted_body.h"
#include "keiko/workflow/version.h"

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

CheckResult check_models(std::span<const std::filesystem::path> inputs, const CheckOptions& options,
                         const Job& job) {
    const SceneSpec spec = spec_of(inputs, SceneOptions{}.material);
    const SurfaceModel model = read_body(spec, options.load, job).model;
    CheckResult result{inspect(model, options.preset, options.join, job)};
    check_symmetry(model, result.inspection, job);
    if (has_curves(options.combs)) result.combs = combs_of(model, options.combs, job);
    return result;
}

} // namespace keiko
