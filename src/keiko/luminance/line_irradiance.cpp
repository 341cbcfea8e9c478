#include "keiko/luminance/line_irradiance.h"

#include <algorithm>
#include <cmath>

namespace keiko {

LinePiece above_horizon(const LinePiece& piece) {
    LinePiece above = piece;
    const double height = piece.n_line * piece.distance; // of the foot
    if (piece.n_along > 0) above.begin = std::max(piece.begin, -height / piece.n_along);
    if (piece.n_along < 0) above.end = std::min(piece.end, -height / piece.n_along);
    if (piece.n_along == 0 && !(height > 0)) above.end = above.begin;
    return above;
}

double cosine_line_integral(const LinePiece& piece) {
    const double h = piece.distance, x1 = piece.begin, x2 = piece.end;
    const double length = x2 - x1, r12 = (h * h + x1 * x1) * (h * h + x2 * x2);
    // In products, so that nothing cancels when the piece is short or the element far along.
    const double across =
        length * (h * h - x1 * x2) / r12 + std::atan2(length * h, h * h + x1 * x2) / h;
    const double along = h * length * (x1 + x2) / r12;
    return (piece.n_line * across + piece.n_along * along) / 2;
}

double isotropic_line_integral(const LinePiece& piece) {
    const double h = piece.distance, x1 = piece.begin, x2 = piece.end;
    const double r1 = std::hypot(h, x1), r2 = std::hypot(h, x2);
    // x2 / r2 - x1 / r1 and 1 / r1 - 1 / r2 with their differences taken out.
    const double rise = (x2 - x1) * (x1 + x2) / (r1 + r2); // r2 - r1
    const double sines = x1 * x2 > 0
                             ? h * h * (x2 - x1) * (x1 + x2) / (r1 * r2 * (x2 * r1 + x1 * r2))
                             : x2 / r2 - x1 / r1;
    return (piece.n_line * sines + piece.n_along * rise * h / (r1 * r2)) / h;
}

} // namespace keiko
