#include "keiko/inspect/curvature_range.h"

#include "keiko/inspect/derivative_ranges.h"
#include "keiko/inspect/levelled_patch.h"
#include "keiko/math/taylor_jet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace keiko {
namespace {

using FirstRange = Jet<Interval>;
using SecondRange = TaylorJet<Interval>;

/// A parameter direction: du, dv.
struct Direction {
    double u = 0, v = 0;
};

/// Directions along which the surface is looked at: at the centre its tangents there are unit
/// vectors along the principal directions.
struct Frame {
    Direction a, b;
};

/// Point and weight as jets: of a place, or of a derivative.
template <class T>
struct Homogeneous {
    Triple<T> p;
    T w;
};

Homogeneous<FirstRange> jets(const DerivativeIntervals& d, std::size_t k, std::size_t l,
                             FirstRange) {
    const HomogeneousRange &f = d[k][l], &u = d[k + 1][l], &v = d[k][l + 1];
    return {{{f.p.x, u.p.x, v.p.x}, {f.p.y, u.p.y, v.p.y}, {f.p.z, u.p.z, v.p.z}}, {f.w, u.w, v.w}};
}

Homogeneous<SecondRange> jets(const DerivativeIntervals& d, std::size_t k, std::size_t l,
                              SecondRange) {
    const HomogeneousRange &f = d[k][l], &u = d[k + 1][l], &v = d[k][l + 1];
    const HomogeneousRange &uu = d[k + 2][l], &uv = d[k + 1][l + 1], &vv = d[k][l + 2];
    return {{{f.p.x, u.p.x, v.p.x, uu.p.x, uv.p.x, vv.p.x},
             {f.p.y, u.p.y, v.p.y, uu.p.y, uv.p.y, vv.p.y},
             {f.p.z, u.p.z, v.p.z, uu.p.z, uv.p.z, vv.p.z}},
            {f.w, u.w, v.w, uu.w, uv.w, vv.w}};
}

template <class T>
Homogeneous<T> operator+(const Homogeneous<T>& a, const Homogeneous<T>& b) {
    return {a.p + b.p, a.w + b.w};
}
template <class T>
Homogeneous<T> operator*(const Homogeneous<T>& a, double b) {
    return {{a.p.x * b, a.p.y * b, a.p.z * b}, a.w * b};
}

/// The entries of the shape operator I^-1 II in the frame.
template <class T>
struct Shape {
    T b11, b12, b21, b22;
    T squared{}; ///< of the length of the cross product of the tangents

    T mean() const { return (b11 + b22) * 0.5; }
    T gaussian() const { return b11 * b22 - b12 * b21; }
    /// Of the principal curvatures: the square of half their difference.
    T parting() const { return square((b11 - b22) * 0.5) + b12 * b21; }
};

/// By homogeneous coordinates, where the derivatives of the weight drop out of most: with
/// m = w^3 S_a x S_b, D_ij = w^4 S_ij . (S_a x S_b) and q_i = w^2 S_i, B = w (I II) / |m|^3.
template <class T>
Shape<T> shape(const DerivativeIntervals& d, const Frame& frame) {
    const auto h = jets(d, 0, 0, T()), u = jets(d, 1, 0, T()), v = jets(d, 0, 1, T());
    const auto uu = jets(d, 2, 0, T()), uv = jets(d, 1, 1, T()), vv = jets(d, 0, 2, T());
    const Homogeneous<T> a = u * frame.a.u + v * frame.a.v, b = u * frame.b.u + v * frame.b.v;
    const Triple<T> ab = cross(a.p, b.p);
    const Triple<T> m = ab * h.w - cross(h.p, b.p) * a.w - cross(a.p, h.p) * b.w;
    const T height = dot(h.p, ab);
    const auto bend = [&](const Direction& p, const Direction& q) {
        const Homogeneous<T> second =
            uu * (p.u * q.u) + uv * (p.u * q.v + p.v * q.u) + vv * (p.v * q.v);
        return dot(second.p, m) - second.w * height;
    };
    const T l = bend(frame.a, frame.a), n = bend(frame.a, frame.b), k = bend(frame.b, frame.b);
    const Triple<T> qa = a.p * h.w - h.p * a.w, qb = b.p * h.w - h.p * b.w;
    const T e = length2(qa), f = dot(qa, qb), g = length2(qb);
    const T squared = length2(m), scale = h.w / (squared * sqrt(squared));
    return {(g * l - f * n) * scale, (g * n - f * k) * scale, (e * n - f * l) * scale,
            (e * k - f * n) * scale, squared};
}

Vec3 middle(const HomogeneousRange& range) {
    const Triple<Interval>& p = range.p;
    return {p.x.middle(), p.y.middle(), p.z.middle()};
}

/// Of a patch whose centre is the origin. Nothing where the tangents there span no plane.
std::optional<Frame> principal_frame(const DerivativeIntervals& d) {
    const double unit = 1 / d[0][0].w.middle();
    const Vec3 u = middle(d[1][0]) * unit, v = middle(d[0][1]) * unit, n = u.cross(v);
    const double length = u.length(), width = n.length() / length;
    if (!(length > 0 && width > 0)) return std::nullopt;
    const Direction along{1 / length, 0}, across{-u.dot(v) / (length * length * width), 1 / width};
    const auto bend = [&](const Direction& p, const Direction& q) {
        return (middle(d[2][0]) * (p.u * q.u) + middle(d[1][1]) * (p.u * q.v + p.v * q.u) +
                middle(d[0][2]) * (p.v * q.v))
            .dot(n);
    };
    const double turn =
        0.5 * std::atan2(2 * bend(along, across), bend(along, along) - bend(across, across));
    const double c = std::cos(turn), s = std::sin(turn);
    return Frame{{c * along.u + s * across.u, c * along.v + s * across.v},
                 {c * across.u - s * along.u, c * across.v - s * along.v}};
}

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Interval everything{-infinity, infinity};

/// What both hold; NaN stands for what is not known.
void sharpen(Interval& range, const Interval& other) {
    if (!std::isnan(other.low)) range.low = std::max(range.low, other.low);
    if (!std::isnan(other.high)) range.high = std::min(range.high, other.high);
}

/// A function over the patch from its jet there and at the centre: by Taylor's theorem to first
/// and to second order, and by its plain range. All hold, so what they share does.
Interval taylor(const SecondRange& all, const FirstRange& centre) {
    constexpr Interval step(-0.5, 0.5), half_square(0, 0.125), product(-0.25, 0.25);
    Interval range = everything;
    sharpen(range, all.f);
    sharpen(range, centre.f + all.u * step + all.v * step);
    sharpen(range, centre.f + centre.u * step + centre.v * step + all.uu * half_square +
                       all.vv * half_square + all.uv * product);
    return range;
}

/// Upper bound of the larger eigenvalue, which grows with both entries of the diagonal where the
/// product of the others is not negative.
double larger_eigenvalue(double b11, double b22, double product) {
    const Interval half = (Interval(b11) - Interval(b22)) * 0.5;
    return ((Interval(b11) + Interval(b22)) * 0.5 + sqrt(square(half) + Interval(product))).high;
}

/// From the entries' ranges; it holds at umbilics too, where the roots are not smooth.
void take_eigenvalues(const Shape<Interval>& s, CurvatureRange& range) {
    const Interval both = s.b12 * s.b21;
    const double product = std::max(0.0, both.high);
    const double defect = sqrt(Interval(std::max(0.0, -both.low))).high;
    sharpen(range.k1, {std::max(s.b11.low, s.b22.low) - defect,
                       larger_eigenvalue(s.b11.high, s.b22.high, product)});
    sharpen(range.k2, {-larger_eigenvalue(-s.b11.low, -s.b22.low, product),
                       std::min(s.b11.high, s.b22.high) + defect});
}

/// As smooth functions, where they are parted all over the patch.
void take_roots(const Shape<SecondRange>& all, const Shape<FirstRange>& centre,
                CurvatureRange& range) {
    const SecondRange parting = all.parting();
    if (!(parting.f.low > 0)) return;
    const SecondRange root = sqrt(parting), mean = all.mean();
    const FirstRange central_root = sqrt(centre.parting()), central_mean = centre.mean();
    sharpen(range.k1, taylor(mean + root, central_mean + central_root));
    sharpen(range.k2, taylor(mean - root, central_mean - central_root));
}

} // namespace

bool CurvatureRange::finite() const {
    const auto is_finite = [](const Interval& i) {
        return std::isfinite(i.low) && std::isfinite(i.high);
    };
    return is_finite(k1) && is_finite(k2) && is_finite(mean) && is_finite(gaussian);
}

CurvatureRange CurvatureRange::turned() const {
    return {-k2, -k1, -mean, gaussian, spread_u, spread_v};
}

CurvatureRange curvature_range(const BezierPatchView& patch, double rounding) {
    CurvatureRange range{everything, everything, everything, everything, infinity, infinity};
    const LevelledPatch level(patch, rounding);
    const DerivativeRanges d = derivative_ranges(level.view(), level.rounding());
    const auto frame = principal_frame(d.centre);
    if (!frame) return range;
    const auto all = shape<SecondRange>(d.all, *frame);
    if (!(all.squared.f.low > 0)) return range;
    const auto centre = shape<FirstRange>(d.centre, *frame);
    sharpen(range.mean, taylor(all.mean(), centre.mean()));
    sharpen(range.gaussian, taylor(all.gaussian(), centre.gaussian()));
    take_eigenvalues({taylor(all.b11, centre.b11), taylor(all.b12, centre.b12),
                      taylor(all.b21, centre.b21), taylor(all.b22, centre.b22)},
                     range);
    take_roots(all, centre, range);
    const auto spread = [](const Interval& slope, const Interval& second) {
        return slope.magnitude() + (second.high - second.low) / 8;
    };
    range.spread_u = spread(centre.b11.u, all.b11.uu) + spread(centre.b22.u, all.b22.uu);
    range.spread_v = spread(centre.b11.v, all.b11.vv) + spread(centre.b22.v, all.b22.vv);
    return range;
}

} // namespace keiko
