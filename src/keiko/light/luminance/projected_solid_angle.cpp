#include "keiko/light/luminance/projected_solid_angle.h"

#include "keiko/math/quadrature.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {

namespace {

/// The boundary sum of a polygon that is clipped to the horizon edge by edge, without storage. All
/// vectors are relative to the point.
class ClippedBoundary {
public:
    explicit ClippedBoundary(const Vec3& normal) : normal_(normal) {}

    void add_edge(const Vec3& a, const Vec3& b) {
        const double ha = normal_.dot(a), hb = normal_.dot(b);
        const bool a_above = ha >= 0, b_above = hb >= 0;
        if (!a_above && !b_above) return;
        if (a_above && b_above) return add_arc(a, b);
        const Vec3 crossing = a + (b - a) * (ha / (ha - hb));
        if (a_above) {
            add_arc(a, crossing);
            exit_ = crossing;
            outside_ = true;
        } else {
            enter(crossing);
            add_arc(crossing, b);
        }
    }

    /// The sum over the closed boundary, signed by its orientation.
    double closed() {
        if (outside_) add_horizon_arc(exit_, first_entry_);
        return sum_ / 2;
    }

private:
    void add_arc(const Vec3& a, const Vec3& b) {
        const Vec3 plane = a.cross(b);
        const double sine = plane.length();
        if (sine > 0) sum_ += std::atan2(sine, a.dot(b)) * normal_.dot(plane) / sine;
    }

    /// Adds the side in the horizon in full: its great circle has the normal +-N. The signed angle
    /// about N stays right where the crossings nearly coincide.
    void add_horizon_arc(const Vec3& a, const Vec3& b) {
        sum_ += std::atan2(normal_.dot(a.cross(b)), a.dot(b));
    }

    void enter(const Vec3& crossing) {
        if (outside_) {
            add_horizon_arc(exit_, crossing);
        } else {
            first_entry_ = crossing; // its exit is the last one, met when the boundary closes
        }
        outside_ = false;
    }

    Vec3 normal_;
    double sum_ = 0;
    bool outside_ = false; ///< went below the horizon at exit_ and is not back yet
    Vec3 exit_{0}, first_entry_{0};
};

} // namespace

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

// Key: psi runs along the rim from its place farthest from the point, so that the squared distance
// is a + b cos(psi), a > b >= 0. N.(r x dr/dpsi) is alpha + beta cos(psi) + gamma sin(psi). The
// height of the rim above the horizon is lift + lift_cos cos(psi) + lift_sin sin(psi).
namespace {

using std::numbers::pi;

struct Rim {
    double a = 0, b = 0;
    double alpha = 0, beta = 0, gamma = 0;
    double lift = 0, lift_cos = 0, lift_sin = 0;
    double a_b = 0; ///< sqrt(a^2 - b^2) from the least and the largest distance
    Vec3 center, x, y;

    Vec3 at(double psi) const { return center + x * std::cos(psi) + y * std::sin(psi); }
    double kernel(double psi) const {
        const double c = std::cos(psi), s = std::sin(psi);
        return (alpha + beta * c + gamma * s) / (a + b * c);
    }
};

Vec3 any_across(const Vec3& axis) {
    const Vec3 beside = std::abs(axis.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    return (beside - axis * axis.dot(beside)).normalized();
}

/// Unit vector across the axis of a disc in the direction of `level`, `aside` long. The rounding of
/// a place `far` away may leave a short one aslant, and that of a place on the axis anything.
Vec3 outwards_of(const Vec3& level, double aside, const Vec3& axis, double far) {
    constexpr double certain = 1e-7, nothing = 1e-14;
    if (aside > certain * far) return level / aside;
    const Vec3 straight = level - axis * axis.dot(level);
    return straight.length() > nothing * far ? straight.normalized() : any_across(axis);
}

Rim rim_of(const Disc& disc, const Vec3& point, const Vec3& normal) {
    Rim rim;
    rim.center = disc.center - point;
    const Vec3 level = rim.center - disc.normal * disc.normal.dot(rim.center);
    const double aside = level.length();
    const Vec3 outwards = outwards_of(level, aside, disc.normal, rim.center.length());
    rim.x = outwards * disc.radius;
    rim.y = disc.normal.cross(outwards) * disc.radius;
    const double height2 = rim.center.length2() - aside * aside, r = disc.radius;
    rim.a = height2 + aside * aside + r * r;
    rim.b = 2 * aside * r;
    const double nearest2 = height2 + (aside - r) * (aside - r);
    rim.a_b = std::sqrt(nearest2 * (height2 + (aside + r) * (aside + r)));
    rim.alpha = r * r * normal.dot(disc.normal);
    rim.beta = normal.dot(rim.center.cross(rim.y));
    rim.gamma = -normal.dot(rim.center.cross(rim.x));
    rim.lift = normal.dot(rim.center);
    rim.lift_cos = normal.dot(rim.x);
    rim.lift_sin = normal.dot(rim.y);
    return rim;
}

double whole_rim(const Rim& rim) {
    return 2 * pi / rim.a_b * (rim.alpha - rim.beta * rim.b / (rim.a + rim.a_b));
}

/// Integral of 1 / (a + b cos) from 0 to psi, -pi to pi.
double inverse_integral(const Rim& rim, double psi) {
    return 2 / rim.a_b *
           std::atan2((rim.a - rim.b) * std::sin(psi / 2), rim.a_b * std::cos(psi / 2));
}

/// Integral of 1 / (a + b cos) over any range of at most a full turn within [-2 pi, 2 pi].
double inverse_integral(const Rim& rim, double begin, double end) {
    const auto from_zero = [&](double psi) {
        if (psi > pi) return inverse_integral(rim, psi - 2 * pi) + 2 * pi / rim.a_b;
        if (psi < -pi) return inverse_integral(rim, psi + 2 * pi) - 2 * pi / rim.a_b;
        return inverse_integral(rim, psi);
    };
    return from_zero(end) - from_zero(begin);
}

/// Part of the rim. The closed form loses digits like a / b, and the kernel is almost a sine where
/// they are many.
double arc(const Rim& rim, double begin, double end) {
    if (rim.b < 0.03 * rim.a)
        return integrate([&](double psi) { return rim.kernel(psi); }, begin, end, 32);
    const double inverse = inverse_integral(rim, begin, end);
    const double cosines = ((end - begin) - rim.a * inverse) / rim.b;
    const double sines =
        -std::log((rim.a + rim.b * std::cos(end)) / (rim.a + rim.b * std::cos(begin))) / rim.b;
    return rim.alpha * inverse + rim.beta * cosines + rim.gamma * sines;
}

/// Part of a chord in the horizon, whose great circle has the normal N.
double chord(const Vec3& from, const Vec3& to, const Vec3& normal) {
    return std::atan2(normal.dot(from.cross(to)), from.dot(to));
}

} // namespace

double projected_solid_angle(const Disc& disc, const Vec3& point, const Vec3& normal) {
    const Rim rim = rim_of(disc, point, normal);
    if (!(rim.a > rim.b) || !(disc.radius > 0)) return 0;
    const double swing = std::hypot(rim.lift_cos, rim.lift_sin);
    if (rim.lift >= swing) return std::abs(whole_rim(rim)) / 2;
    if (rim.lift <= -swing) return 0;
    const double highest = std::atan2(rim.lift_sin, rim.lift_cos);
    const double half = std::acos(-rim.lift / swing);
    const double begin = highest - half, end = highest + half;
    return std::abs(arc(rim, begin, end) + chord(rim.at(end), rim.at(begin), normal)) / 2;
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
