#include "keiko/tubes/tube_irradiance.h"

#include "keiko/tubes/cylinder_irradiance.h"
#include "keiko/tubes/flat_tube_models.h"

#include <algorithm>

namespace keiko {
namespace {

/// The strip's error 0.058 (d/D)^2 reaches 1e-4, the accuracy of the whole system, at 0.0415.
constexpr double strip_up_to = 0.04;
/// Physics 2.9: beyond this ratio the strip is no longer good for a picture either.
constexpr double strip_in_pictures_up_to = 0.2;

TubeModel chosen(TubeModel model, const TubeView& view) {
    if (model != TubeModel::automatic && model != TubeModel::picture) return model;
    const bool exacting = model == TubeModel::automatic;
    const double limit = exacting ? strip_up_to : strip_in_pictures_up_to;
    return view.ratio() < limit ? TubeModel::strip : TubeModel::cylinder;
}

double solid_angle_of(const VisiblePart& part, const TubeView& view, TubeModel model) {
    switch (model) {
        case TubeModel::seed:
            return seed_solid_angle(view, part);
        case TubeModel::rectangle:
            return rectangle_solid_angle(view, part);
        case TubeModel::line:
            return line_solid_angle(view, part);
        case TubeModel::strip:
            return strip_solid_angle(view, part);
        default:
            return cylinder_solid_angle(view, part);
    }
}

} // namespace

double projected_solid_angle(const TubeLamp& lamp, const Vec3& point, const Vec3& normal,
                             const IntervalSet& visible, TubeModel model) {
    if (below_horizon(lamp, point, normal)) return 0;
    const auto view = view_of(lamp, point, normal);
    if (!view) return 0;
    double sum = 0;
    for (const ParameterInterval& interval : visible) {
        const double begin = std::max(interval.begin, 0.0), end = std::min(interval.end, 1.0);
        if (!(begin < end)) continue;
        const VisiblePart part{view->x_at(begin), view->x_at(end), begin == 0, end == 1};
        sum += solid_angle_of(part, *view, chosen(model, *view));
    }
    return sum;
}

} // namespace keiko
