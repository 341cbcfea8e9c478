#include "keiko/workflow/check_models.h"

#include "keiko/compare/shape/symmetry.h"
#include "keiko/workflow/open_scene.h"
#include "keiko/workflow/painted_body.h"

namespace keiko {

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
