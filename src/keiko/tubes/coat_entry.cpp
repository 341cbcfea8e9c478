#include "keiko/tubes/coat_entry.h"

#include "keiko/luminance/line_irradiance.h"
#include "keiko/math/quadrature.h"

#include <algorithm>
#include <cmath>

namespace keiko {

double entering_share(const ClearCoat& coat, const TubeView& view, const VisiblePart& part) {
    const LinePiece lit =
        above_horizon({part.begin, part.end, view.distance, view.n_along, view.n_lamp});
    if (!(lit.begin < lit.end)) return 0;
    // By the sine of the elevation: what a piece of the axis gives is N.w times its change.
    const double square = view.distance * view.distance;
    const double begin = lit.begin / std::sqrt(lit.begin * lit.begin + square);
    const double end = lit.end / std::sqrt(lit.end * lit.end + square);
    const auto cosine_at = [&](double sine) {
        return view.n_lamp * std::sqrt(1 - sine * sine) + view.n_along * sine;
    };
    // Away from grazing incidence a coat takes in nearly the same.
    constexpr double grazing = 0.4;
    const bool even = std::min(cosine_at(begin), cosine_at(end)) > grazing;
    double given = 0, entered = 0;
    for (const QuadratureNode& node : gauss_legendre(even ? 2 : 4)) {
        const double cosine = cosine_at((begin + end) / 2 + (end - begin) / 2 * node.x);
        given += node.weight * cosine;
        entered += node.weight * cosine * coat.entering(cosine);
    }
    return given > 0 ? entered / given : 0;
}

} // namespace keiko
