#include "keiko/geometry/bezier/subpatch.h"

#include "keiko/geometry/bernstein/coefficient_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// Restricts polynomials to [a, b]. The part beyond the patch is continued first, from the whole of
/// it: continued by as much from a narrow piece, rounding would grow with a power of their ratio.
void restrict_or_continue(Vec4* c, const CoefficientLines& lines, double a, double b) {
    if (a >= 0) return restrict_lines(c, lines, a, b);
    keep_beyond(c, lines, a);
    const double end = (b - a) / (1 - a);
    if (end != 1) keep_before(c, lines, end);
}

/// Gradient and Hessian of half the squared distance at a place of the piece.
struct Local {
    Vec2 gradient{0};
    double uu = 0, uv = 0, vv = 0;
    Vec2 speed{0}; ///< mm in a unit of u, of v

    Local(const SurfaceDerivatives& s, const Vec3& p) {
        const Vec3 off = s.position() - p;
        gradient = Vec2(off.dot(s.du()), off.dot(s.dv()));
        const double first_uu = s.du().length2(), first_uv = s.du().dot(s.dv());
        const double first_vv = s.dv().length2();
        speed = Vec2(std::sqrt(first_uu), std::sqrt(first_vv));
        uu = first_uu + off.dot(s.duu());
        uv = first_uv + off.dot(s.duv());
        vv = first_vv + off.dot(s.dvv());
        // Where the function is concave, the tangents alone are used (Gauss-Newton).
        if (!(uu > 0.1 * first_uu && vv > 0.1 * first_vv && uu * vv - uv * uv > 0.01 * uu * vv))
            uu = first_uu, uv = first_uv, vv = first_vv;
    }
};

/// True if descent leads out of the unit square there.
bool held(double t, double gradient) {
    return (t <= 0 && gradient > 0) || (t >= 1 && gradient < 0);
}

/// Newton's step along the sides that are not held.
Vec2 newton_step(const Local& f, const Vec2& uv) {
    const bool held_u = held(uv.x, f.gradient.x), held_v = held(uv.y, f.gradient.y);
    const double tiny = std::numeric_limits<double>::min();
    if (held_u && held_v) return Vec2(0);
    if (held_u) return {0, -f.gradient.y / std::max(f.vv, tiny)};
    if (held_v) return {-f.gradient.x / std::max(f.uu, tiny), 0};
    const double determinant = f.uu * f.vv - f.uv * f.uv;
    if (!(determinant > 1e-14 * f.uu * f.vv))
        return {-f.gradient.x / std::max(f.uu, tiny), -f.gradient.y / std::max(f.vv, tiny)};
    return {(f.uv * f.gradient.y - f.vv * f.gradient.x) / determinant,
            (f.uv * f.gradient.x - f.uu * f.gradient.y) / determinant};
}

Vec2 clamped(const Vec2& uv) {
    return {std::clamp(uv.x, 0.0, 1.0), std::clamp(uv.y, 0.0, 1.0)};
}

} // namespace

std::vector<Vec4> subpatch(const BezierPatchView& patch, const Box2& box) {
    std::vector<Vec4> points(patch.points.begin(), patch.points.end());
    const auto rows = static_cast<std::size_t>(patch.degree_u) + 1;
    const auto columns = static_cast<std::size_t>(patch.degree_v) + 1;
    restrict_or_continue(points.data(), CoefficientLines::of_tensor(rows, columns, true),
                         box.lower.x, box.upper.x);
    restrict_or_continue(points.data(), CoefficientLines::of_tensor(rows, columns, false),
                         box.lower.y, box.upper.y);
    return points;
}

PieceProjection piece_projection(const BezierPatchView& piece, const Vec3& p, const Vec2& start) {
    constexpr int most_steps = 40;
    constexpr double enough = 1e-11; // mm
    Vec2 uv = start;
    bool converged = false;
    SurfaceDerivatives s = evaluate(piece, uv, 2);
    double square = (s.position() - p).length2();
    for (int i = 0; i < most_steps; ++i) {
        const Local f(s, p);
        Vec2 step = newton_step(f, uv);
        Vec2 next = clamped(uv + step);
        SurfaceDerivatives there = evaluate(piece, next, 2);
        double square_there = (there.position() - p).length2();
        // At the minimum itself the distance only rounds up and down.
        const double not_worse = square * (1 + 1e-12);
        for (int shorter = 0; shorter < 20 && square_there > not_worse; ++shorter) {
            step *= 0.25;
            next = clamped(uv + step);
            there = evaluate(piece, next, 2);
            square_there = (there.position() - p).length2();
        }
        converged = !(square_there <= not_worse);
        if (converged) break;
        const double moved =
            std::abs(next.x - uv.x) * f.speed.x + std::abs(next.y - uv.y) * f.speed.y;
        uv = next, s = there, square = square_there;
        converged = moved <= enough;
        if (converged) break;
    }
    return {uv, s.position(), std::sqrt(square), converged};
}

} // namespace keiko
