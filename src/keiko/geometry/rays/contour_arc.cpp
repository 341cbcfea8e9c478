#include "keiko/geometry/rays/contour_arc.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace keiko {
namespace {

/// Both zeros of a quadratic polynomial with real ones, by its Bernstein coefficients.
std::array<double, 2> quadratic_zeros(double a, double b, double c) {
    // a (1 - t)^2 + 2 b t (1 - t) + c t^2 = (a - 2 b + c) t^2 - 2 (a - b) t + a
    const double square = a - 2 * b + c, half = a - b;
    const double off = std::sqrt(std::max(b * b - a * c, 0.0));
    // The sum without cancellation, and the other root by the product.
    const double sum = half + std::copysign(off, half);
    if (!(std::abs(sum) > 0)) return {0, 0};
    const bool is_linear = !(std::abs(square) > 0);
    return {is_linear ? std::numeric_limits<double>::infinity() : sum / square, a / sum};
}

/// Places in [0, 1] where a quadratic polynomial changes its sign, by its Bernstein coefficients;
/// zero counts as above. Signs at the ends decide how many there are.
ContourArc::Crossings quadratic_roots(double a, double b, double c) {
    ContourArc::Crossings roots;
    const bool from_above = a >= 0, to_above = c >= 0;
    if (from_above == to_above && ((b >= 0) == from_above || !(b * b > a * c))) return roots;
    auto [first, second] = quadratic_zeros(a, b, c);
    const auto within = [](double t) { return t >= 0 && t <= 1; };
    if (from_above != to_above) {
        // A zero at the begin is above: if the polynomial rises there it changes at the other one.
        const bool rises_from_zero = from_above && !(a > 0) && b > 0;
        const double t = !rises_from_zero && within(second) ? second : first;
        roots.of[roots.count++] = {std::fmin(std::fmax(t, 0.0), 1.0), to_above};
        return roots;
    }
    if (!within(first) || !within(second)) return roots;
    if (first > second) std::swap(first, second);
    roots.of[roots.count++] = {first, !from_above};
    roots.of[roots.count++] = {second, from_above};
    return roots;
}

} // namespace

ContourArc ContourArc::part(double from, double to) const {
    const Vec3 a = begin * (1 - from) + middle * from, b = middle * (1 - from) + end * from;
    const Vec3 c = begin * (1 - to) + middle * to, d = middle * (1 - to) + end * to;
    return {a * (1 - from) + b * from,  a * (1 - to) + b * to, c * (1 - to) + d * to, left,
            from > 0 || turns_at_begin, to < 1 || turns_at_end};
}

ContourArc::Crossings ContourArc::crossings(const Vec3& normal) const {
    return quadratic_roots(begin.dot(normal), middle.dot(normal), end.dot(normal));
}

std::optional<double> ContourArc::nearest(const Vec3& direction) const {
    const Crossings crossed = crossings(direction.cross(begin.cross(end)));
    for (const ArcRoot& root : crossed)
        if (at(root.t).dot(direction) > 0) return root.t;
    return std::nullopt;
}

double ContourArc::angle_off(const Vec3& direction) const {
    const auto t = nearest(direction);
    return t ? angle_between(at(*t), direction) : std::numeric_limits<double>::infinity();
}

ContourArc::Crossings ContourArc::extremes(const Vec3& ahead, const Vec3& across) const {
    // The derivative of a quotient of quadratic polynomials x / z has a quadratic numerator, with
    // the coefficients of x' z - x z'.
    const auto numerator = [&](const Vec3& p, const Vec3& q) {
        return q.dot(across) * p.dot(ahead) - p.dot(across) * q.dot(ahead);
    };
    return quadratic_roots(numerator(begin, middle), numerator(begin, end) / 2,
                           numerator(middle, end));
}

ContourArc arc_through(const Vec3& begin, const Vec3& through, const Vec3& end,
                       const Vec3& begin_plane, const Vec3& end_plane) {
    constexpr double straight = 1e-12;
    Vec3 corner = begin_plane.cross(end_plane);
    if (corner.dot(begin + end) < 0) corner = -corner;
    const double volume = begin.cross(corner).dot(end);
    const double a = through.cross(corner).dot(end) / volume;
    const double b = begin.cross(through).dot(end) / volume;
    const double c = begin.cross(corner).dot(through) / volume;
    const bool bends =
        std::abs(volume) > straight * begin.length() * end.length() * corner.length();
    if (bends && a > 0 && b > 0 && c > 0) return {begin * (4 * a), corner * (2 * b), end * (4 * c)};
    const Vec3 chord = (begin + end) / 2;
    const Vec3 at = through * (chord.dot(through) / through.length2());
    return {begin, at * 2 - chord, end};
}

} // namespace keiko
