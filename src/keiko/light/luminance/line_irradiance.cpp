#include "keiko/light/luminance/line_irradiance.h"

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

} // namespace keiko
