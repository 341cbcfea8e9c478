#include "keiko/light/luminance/projected_solid_angle.h"

#include "keiko/light/luminance/clipped_boundary.h"
#include "keiko/light/luminance/rim.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {

double projected_solid_angle(std::span<const Vec3> corners, const Vec3& point, const Vec3& normal) {
    if (corners.size() < 3) return 0;
    ClippedBoundary boundary(normal);
    Vec3 previous = corners.back() - point;
    for (const Vec3& corner : corners) {
        const Vec3 next = corner - point;
        boundary.add_edge(previous, next);
        previous = next;
    }
    return std::abs(boundary.closed());
}

namespace {

/// Part of a chord in the horizon, whose great circle has the normal N.
double chord(const Vec3& from, const Vec3& to, const Vec3& normal) {
    return std::atan2(normal.dot(from.cross(to)), from.dot(to));
}

} // namespace

double projected_solid_angle(const Disc& disc, const Vec3& point, const Vec3& normal) {
    const Rim rim(disc, point, normal);
    if (rim.edge_on()) return 0;
    if (rim.lowest() >= 0) return std::abs(rim.whole()) / 2;
    if (!rim.meets_horizon()) return 0;
    const auto [begin, end] = rim.above();
    return std::abs(rim.arc(begin, end) + chord(rim.at(end), rim.at(begin), normal)) / 2;
}

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
    // As products, so that nothing cancels if the piece is short or the element far along.
    const double across =
        length * (h * h - x1 * x2) / r12 + std::atan2(length * h, h * h + x1 * x2) / h;
    const double along = h * length * (x1 + x2) / r12;
    return (piece.n_line * across + piece.n_along * along) / 2;
}

} // namespace keiko
