#include "keiko/tubes/coat_entry.h"

#include "keiko/luminance/line_irradiance.h"
#include "keiko/math/quadrature.h"

#include <cmath>

namespace keiko {

double entering_share(const ClearCoat& coat, const TubeView& view, const VisiblePart& part) {
    constexpr int nodes = 4;
    const LinePiece lit =
        above_horizon({part.begin, part.end, view.distance, view.n_along, view.n_lamp});
    if (!(lit.begin < lit.end)) return 0;
    // By the sine of the elevation: what a piece of the axis gives is N.w times its change.
    const double begin = lit.begin / std::hypot(lit.begin, view.distance);
    const double end = lit.end / std::hypot(lit.end, view.distance);
    double given = 0, entered = 0;
    for (const QuadratureNode& node : gauss_legendre(nodes)) {
        const double sine = (begin + end) / 2 + (end - begin) / 2 * node.x;
        const double cosine = view.n_lamp * std::sqrt(1 - sine * sine) + view.n_along * sine;
        given += node.weight * cosine;
        entered += node.weight * cosine * coat.entering(cosine);
    }
    return given > 0 ? entered / given : 0;
}

} // namespace keiko
