#include "keiko/keiko.h"

namespace keiko {

bool has_curves(const CombOptions& options) {
    return !options.planes.empty() || options.iso_curves > 0;
}

Combs combs_of(const SurfaceModel& model, const CombOptions& options, const Job& job) {
    Combs combs;
    combs.curves = comb_curves(model, options, job);
    combs.json = combs_json(combs.curves, model, version());
    combs.csv = combs_csv(combs.curves, model);
    combs.pictures = comb_pictures(combs.curves, options.planes);
    return combs;
}

} // namespace keiko
