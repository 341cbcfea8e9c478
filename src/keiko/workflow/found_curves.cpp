#include "keiko/workflow/found_curves.h"

#include "keiko/report/content/contour_set.h"
#include "keiko/report/content/curve_sets.h"

namespace keiko {

CurveSet check_curves(const CheckResult& result, const CheckOptions& options) {
    std::span<const CombCurve> combs;
    if (result.combs) combs = result.combs->curves;
    return inspection_curves(result.inspection, combs, options.combs.chord_error);
}

std::vector<NamedCurve> view_contours(const Scene& scene, const LineList& list, double chord_error,
                                      const Job& job) {
    std::vector<NamedCurve> curves;
    for (const ViewLines& view : list.views) {
        const std::vector<ContourLine> found =
            contour_curves(scene.model, LineEye(view.camera), chord_error, job);
        for (NamedCurve& curve : contour_set(scene.model, view.view, found))
            curves.push_back(std::move(curve));
    }
    return curves;
}

} // namespace keiko
