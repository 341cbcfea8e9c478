#include "keiko/inspect/curvature/curvature_range.h"

#include "keiko/inspect/basics/patch_model.h"
#include "keiko/math/taylor_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace keiko {
namespace {

using Vector = Triple<TaylorModel>;

/// A parameter direction: dx, dy.
struct Direction {
    double x = 0, y = 0;
};

/// Parameter directions of the principal curvatures: the tangents along them at the centre are unit
/// vectors.
struct Frame {
    Direction a, b;
};

Vector operator*(const Vector& v, double factor) {
    return {v.x * factor, v.y * factor, v.z * factor};
}

HomogeneousModel combined(const HomogeneousModel& a, double s, const HomogeneousModel& b,
                          double t) {
    return {a.p * s + b.p * t, a.w * s + b.w * t};
}

Vec3 centre(const HomogeneousModel& model) {
    return {model.p.x.c[0], model.p.y.c[0], model.p.z.c[0]};
}

/// Principal frame of a patch whose centre is the origin; nullopt if the tangents there span no
/// plane.
std::optional<Frame> principal_frame(const PatchModel& patch) {
    const double unit = 1 / patch.s.w.c[0];
    const Vec3 x = centre(patch.x) * unit, y = centre(patch.y) * unit, n = x.cross(y);
    const double length = x.length(), width = n.length() / length;
    if (!(length > 0 && width > 0)) return std::nullopt;
    const Direction along{1 / length, 0}, across{-x.dot(y) / (length * length * width), 1 / width};
    const auto bend = [&](const Direction& p, const Direction& q) {
        return (centre(patch.xx) * (p.x * q.x) + centre(patch.xy) * (p.x * q.y + p.y * q.x) +
                centre(patch.yy) * (p.y * q.y))
            .dot(n);
    };
    const double turn =
        0.5 * std::atan2(2 * bend(along, across), bend(along, along) - bend(across, across));
    const double c = std::cos(turn), s = std::sin(turn);
    return Frame{{c * along.x + s * across.x, c * along.y + s * across.y},
                 {c * across.x - s * along.x, c * across.y - s * along.y}};
}

/// The tangents in a frame, by homogeneous coordinates.
struct Tangents {
    HomogeneousModel a, b;
    Vector normal;      ///< w^3 S_a x S_b
    TaylorModel height; ///< p . (a x b): the normal times the place

    Tangents(const PatchModel& patch, const Frame& frame, bool rational)
        : a(combined(patch.x, frame.a.x, patch.y, frame.a.y)),
          b(combined(patch.x, frame.b.x, patch.y, frame.b.y)),
          normal(cross(a.p, b.p)) {
        if (!rational) return;
        height = dot(patch.s.p, normal);
        normal = normal * patch.s.w - cross(patch.s.p, b.p) * a.w - cross(a.p, patch.s.p) * b.w;
    }
};

/// The entries of the shape operator I^-1 II in the frame.
struct Shape {
    TaylorModel b11, b12, b21, b22;

    bool known() const { return std::isfinite(b11.error + b12.error + b21.error + b22.error); }
    TaylorModel mean() const { return (b11 + b22) * 0.5; }
    TaylorModel gaussian() const { return b11 * b22 - b12 * b21; }
    /// Square of half the difference of the principal curvatures.
    TaylorModel parting() const { return square((b11 - b22) * 0.5) + b12 * b21; }
};

/// Shape operator in homogeneous coordinates, where the derivatives of the weight drop out of most
/// terms. With m = w^3 S_a x S_b, D_ij = w^4 S_ij . (S_a x S_b) and q_i = w^2 S_i, B = w (I II) /
/// |m|^3.
Shape shape(const PatchModel& patch, const Frame& frame, const Tangents& t, bool rational) {
    const auto bend = [&](const Direction& p, const Direction& q) {
        const double xx = p.x * q.x, xy = p.x * q.y + p.y * q.x, yy = p.y * q.y;
        const TaylorModel d = dot(patch.xx.p * xx + patch.xy.p * xy + patch.yy.p * yy, t.normal);
        if (!rational) return d;
        return d - (patch.xx.w * xx + patch.xy.w * xy + patch.yy.w * yy) * t.height;
    };
    const auto tangent = [&](const HomogeneousModel& s) {
        return rational ? s.p * patch.s.w - patch.s.p * s.w : s.p;
    };
    const TaylorModel l = bend(frame.a, frame.a), n = bend(frame.a, frame.b),
                      k = bend(frame.b, frame.b);
    const Vector qa = tangent(t.a), qb = tangent(t.b);
    const TaylorModel e = length2(qa), f = dot(qa, qb), g = length2(qb);
    TaylorModel scale = inverse_cubed_root(length2(t.normal));
    if (rational) scale = scale * patch.s.w;
    return {(g * l - f * n) * scale, (g * n - f * k) * scale, (e * n - f * l) * scale,
            (e * k - f * n) * scale};
}

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Interval everything{-infinity, infinity};

/// Place of a peak in the patch's parameters.
Vec2 place_of(const TaylorPeak& peak) {
    return (peak.place + Vec2(1)) / 2;
}

Spread spread_of(const TaylorModel& model) {
    const TaylorPeak low = peak(-model), high = peak(model);
    return {{-low.bound, high.bound}, place_of(low), place_of(high)};
}

/// Narrows `spread` to its intersection with another one.
void sharpen(Spread& spread, const Spread& other) {
    if (other.range.low > spread.range.low)
        spread.range.low = other.range.low, spread.lowest = other.lowest;
    if (other.range.high < spread.range.high)
        spread.range.high = other.range.high, spread.highest = other.highest;
}

/// Upper bound of the larger eigenvalue. It grows with both entries of the diagonal if the product
/// of the others is not negative.
double larger_eigenvalue(double b11, double b22, double product) {
    const Interval half = (Interval(b11) - Interval(b22)) * 0.5;
    return ((Interval(b11) + Interval(b22)) * 0.5 + sqrt(square(half) + Interval(product))).high;
}

/// Ranges of the eigenvalues from those of the entries. They hold at umbilics too, where the roots
/// are not smooth.
void take_eigenvalues(const Shape& s, CurvatureRange& range) {
    const Spread a = spread_of(s.b11), b = spread_of(s.b22);
    const Interval both = spread_of(s.b12 * s.b21).range;
    const double product = std::max(0.0, both.high);
    const double defect = sqrt(Interval(std::max(0.0, -both.low))).high;
    const bool a_larger = a.range.middle() > b.range.middle();
    const Spread &larger = a_larger ? a : b, &smaller = a_larger ? b : a;
    range.k1 = {{std::max(a.range.low, b.range.low) - defect,
                 larger_eigenvalue(a.range.high, b.range.high, product)},
                larger.lowest,
                larger.highest};
    range.k2 = {{-larger_eigenvalue(-a.range.low, -b.range.low, product),
                 std::min(a.range.high, b.range.high) + defect},
                smaller.lowest,
                smaller.highest};
}

/// Ranges of the eigenvalues as smooth functions; requires that they differ all over the patch.
void take_roots(const Shape& s, CurvatureRange& range) {
    const TaylorModel root = sqrt(s.parting()), mean = s.mean();
    if (!std::isfinite(root.error)) return;
    sharpen(range.k1, spread_of(mean + root));
    sharpen(range.k2, spread_of(mean - root));
}

/// Bends along u and v: the rotation of the normal and the relative change of speed, times the
/// curvature, or alone if the curvatures are unknown.
void take_bends(const Vector& normal, const Shape& s, CurvatureRange& range) {
    const double length = Vec3(normal.x.c[0], normal.y.c[0], normal.z.c[0]).length();
    range.bend_u = (normal.x.along_x() + normal.y.along_x() + normal.z.along_x()) / length;
    range.bend_v = (normal.x.along_y() + normal.y.along_y() + normal.z.along_y()) / length;
    if (!s.known()) return;
    const double curvature = std::max(std::abs(s.b11.c[0]), std::abs(s.b22.c[0]));
    range.bend_u = range.bend_u * curvature + s.b11.along_x() + s.b22.along_x();
    range.bend_v = range.bend_v * curvature + s.b11.along_y() + s.b22.along_y();
}

} // namespace

bool CurvatureRange::finite() const {
    const auto is_finite = [](const Spread& s) {
        return std::isfinite(s.range.low) && std::isfinite(s.range.high);
    };
    return is_finite(k1) && is_finite(k2) && is_finite(mean) && is_finite(gaussian);
}

CurvatureRange CurvatureRange::turned() const {
    return {k2.turned(), k1.turned(), mean.turned(), gaussian, bend_u, bend_v};
}

CurvatureRange curvature_range(const BezierPatchView& patch, double rounding) {
    const Spread unknown{everything};
    CurvatureRange range{unknown, unknown, unknown, unknown, infinity, infinity};
    const LevelledPatch level(patch, rounding);
    const PatchModel model = patch_model(level.view(), level.rounding());
    const auto frame = principal_frame(model);
    if (!frame) return range;
    const bool rational = patch.rational();
    const Tangents tangents(model, *frame, rational);
    const Shape s = shape(model, *frame, tangents, rational);
    take_bends(tangents.normal, s, range);
    if (!s.known()) return range;
    range.mean = spread_of(s.mean()), range.gaussian = spread_of(s.gaussian());
    take_eigenvalues(s, range);
    take_roots(s, range);
    return range;
}

} // namespace keiko
