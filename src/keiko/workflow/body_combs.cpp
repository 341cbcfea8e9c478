#include "keiko/workflow/body_combs.h"

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

} // namespace keiko
