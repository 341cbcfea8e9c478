#include "keiko/geometry/model/curve_fault.h"

#include "keiko/geometry/bernstein/bernstein.h"

#include <algorithm>
#include <cmath>

namespace keiko {

std::string fault_of(const NurbsCurve<Vec4>& piece) {
    const auto degree = static_cast<std::size_t>(piece.degree);
    if (piece.degree < 1 || piece.degree > max_degree) return "an impossible degree";
    if (piece.points.size() < degree + 1 || piece.knots.size() != piece.points.size() + degree + 1)
        return "a curve with a wrong number of knots";
    const auto is_finite = [](double number) { return std::isfinite(number); };
    if (!std::all_of(piece.knots.begin(), piece.knots.end(), is_finite))
        return "a knot that is not finite";
    if (!std::is_sorted(piece.knots.begin(), piece.knots.end()) ||
        !(piece.knots[degree] < piece.knots[piece.points.size()]))
        return "knots that do not rise";
    for (const Vec4& point : piece.points) {
        if (!is_finite(point.x) || !is_finite(point.y) || !is_finite(point.z))
            return "a point that is not finite";
        if (!(point.w > 0) || !is_finite(point.w)) return "a weight that is not positive";
    }
    return "";
}

} // namespace keiko
