#include "keiko/geometry/trim/monotone_piece.h"

#include "keiko/geometry/bernstein/bernstein.h"
#include "keiko/geometry/bernstein/binomial.h"
#include "keiko/geometry/bernstein/de_casteljau.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// A coordinate that decides no side of a piece.
constexpr double anywhere = std::numeric_limits<double>::quiet_NaN();

/// Rounding of the sums across a chord whose places are far from 0.
constexpr double rounding = 1e-14;

Vec2 projected(const Vec3& p) {
    return Vec2(p.x, p.y) / p.z;
}

/// Bernstein coefficients of a * b.
std::vector<double> product(const std::vector<double>& a, const std::vector<double>& b) {
    const std::size_t m = a.size() - 1, n = b.size() - 1;
    const std::vector<double> of_a = binomials(m), of_b = binomials(n);
    std::vector<double> c(m + n + 1, 0.0);
    for (std::size_t i = 0; i <= m; ++i)
        for (std::size_t j = 0; j <= n; ++j) c[i + j] += of_a[i] * of_b[j] * a[i] * b[j];
    const std::vector<double> of_product = binomials(m + n);
    for (std::size_t k = 0; k <= m + n; ++k) c[k] /= of_product[k];
    return c;
}

std::vector<double> differences(const std::vector<double>& a) {
    std::vector<double> d;
    for (std::size_t i = 1; i < a.size(); ++i) d.push_back(a[i] - a[i - 1]);
    return d;
}

/// Extrema of x = X / W by the roots of X' W - X W', with X taken from the curve's start so that
/// a far-off coordinate costs no digits.
std::vector<double> extrema(const BezierCurveView& curve, int coordinate) {
    const Vec2 start = projected(curve.points.front());
    std::vector<double> x, w;
    double size = 0, heaviest = 0;
    for (const Vec3& p : curve.points) {
        w.push_back(p.z);
        x.push_back(p[coordinate] - start[static_cast<unsigned>(coordinate)] * p.z);
        size = std::max(size, std::abs(x.back()));
        heaviest = std::max(heaviest, std::abs(w.back()));
    }
    std::vector<double> derivative = product(differences(x), w);
    const std::vector<double> correction = product(x, differences(w));
    for (std::size_t i = 0; i < derivative.size(); ++i) derivative[i] -= correction[i];
    constexpr double of_products = 1e-14;
    return bernstein_roots(derivative, of_products * size * heaviest);
}

/// The derivative by t, as control points.
std::vector<Vec3> derivative(const std::vector<Vec3>& points) {
    std::vector<Vec3> result;
    for (std::size_t i = 1; i < points.size(); ++i)
        result.push_back((points[i] - points[i - 1]) * static_cast<double>(points.size() - 1));
    return result;
}

/// Bounds of the coordinates of a curve.
Vec3 most_of(const std::vector<Vec3>& points) {
    Box3 all;
    all.extend(Vec3(0));
    for (const Vec3& p : points) all.extend(magnitudes(p));
    return all.upper;
}

} // namespace

MonotonePiece::MonotonePiece(std::vector<Vec3> points, std::uint32_t curve, double begin,
                             double end)
    : points_(std::move(points)),
      first_(projected(points_.front())),
      last_(projected(points_.back())),
      curve_(curve),
      begin_(begin),
      end_(end) {
    box_.extend(first_);
    box_.extend(last_);
    binomials_ = binomials(points_.size() - 1);
    find_strip();
    find_bend();
}

void MonotonePiece::find_bend() {
    std::vector<Vec3> points; // from the first place, so that one far off costs no digits
    for (const Vec3& p : points_)
        points.push_back({p.x - first_.x * p.z, p.y - first_.y * p.z, p.z});
    const std::vector<Vec3> slopes = derivative(points);
    const Vec3 first = most_of(slopes), second = most_of(derivative(slopes));
    const auto least = std::min_element(points.begin(), points.end(),
                                        [](const Vec3& a, const Vec3& b) { return a.z < b.z; });
    // X = x / w, so X' = (x' - X w') / w and X'' = (x'' - 2 X' w' - X w'') / w.
    const Vec2 farthest = box_.extent();
    const Vec2 slope = (Vec2(first.x, first.y) + farthest * first.z) / least->z;
    bend_ = (Vec2(second.x, second.y) + slope * (2 * first.z) + farthest * second.z) / least->z;
    if (!(least->z > 0)) bend_ = Vec2(std::numeric_limits<double>::infinity());
}

void MonotonePiece::find_strip() {
    constexpr double all = std::numeric_limits<double>::infinity();
    for (const Vec3& p : points_) {
        const Vec2 place = projected(p);
        const double beside = beside_chord(place - first_), room = rounding * across(place);
        if (!(p.z > 0) || !std::isfinite(beside) || !std::isfinite(room)) {
            strip_low_ = -all, strip_high_ = all;
            return;
        }
        strip_low_ = std::min(strip_low_, beside - room);
        strip_high_ = std::max(strip_high_, beside + room);
    }
}

double MonotonePiece::beside_chord(const Vec2& place) const {
    const Vec2 chord = last_ - first_;
    return chord.x * place.y - chord.y * place.x;
}

double MonotonePiece::across(const Vec2& size) const {
    const Vec2 chord = box_.extent();
    return chord.x * std::abs(size.y) + chord.y * std::abs(size.x);
}

bool MonotonePiece::may_touch(const Box2& box) const {
    if (!box_.overlaps(box)) return false;
    const double room = across(box.extent() / 2) + rounding * (across(first_) + across(last_));
    const double middle = beside_chord(box.center() - first_);
    return middle - room <= strip_high_ && middle + room >= strip_low_;
}

Vec2 MonotonePiece::point(double t) const {
    const std::size_t n = points_.size() - 1;
    if (n == 1) return projected(points_[0] * (1 - t) + points_[1] * t);
    // Horner's scheme for the Bernstein form, as in "hornbez" of [Farin2002].
    const double s = 1 - t;
    double power = 1;
    Vec3 sum = points_[0] * s;
    for (std::size_t i = 1; i < n; ++i) {
        power *= t;
        sum = (sum + points_[i] * (power * binomials_[i])) * s;
    }
    return projected(sum + points_[n] * (power * t));
}

template <unsigned axis>
MonotonePiece::Bracket MonotonePiece::bracket(double at, double beside) const {
    const double noise = 4e-16 * (std::abs(first_[axis]) + std::abs(last_[axis]));
    Bracket found{0, 1, first_, last_};
    double fa = first_[axis] - at, fb = last_[axis] - at;
    if (std::abs(fa) <= noise) return {0, 0, first_, first_};
    if (std::abs(fb) <= noise) return {1, 1, last_, last_};
    // Regula falsi with the Illinois weight [DowellJarratt1971]; a bisection now and then bounds
    // the worst case.
    for (int step = 0; step < 100; ++step) {
        const auto [low, high] = std::minmax(found.at_a[1 - axis], found.at_b[1 - axis]);
        if (beside < low || beside > high) break;
        const double t = step % 8 == 7 ? (found.a + found.b) / 2
                                       : found.b - fb * (found.b - found.a) / (fb - fa);
        const Vec2 p = point(t);
        const double f = p[axis] - at;
        if (std::abs(f) <= noise || t == found.a || t == found.b) return {t, t, p, p};
        if ((f < 0) == (fb < 0))
            fa /= 2;
        else
            found.a = found.b, found.at_a = found.at_b, fa = fb;
        found.b = t, found.at_b = p, fb = f;
    }
    return found;
}

bool MonotonePiece::crossed_from(const Vec2& p) const {
    if ((first_.y <= p.y) == (last_.y <= p.y)) return false;
    if (p.x < box_.lower.x) return true;
    if (!(p.x < box_.upper.x)) return false;
    const Bracket at = bracket<1>(p.y, p.x);
    return p.x < (at.at_a.x + at.at_b.x) / 2;
}

std::vector<double> MonotonePiece::crossings(unsigned axis, double at) const {
    const double from = first_[axis], to = last_[axis];
    if (std::max(from, to) < at || std::min(from, to) > at) return {};
    if (from == to) return {first_[1 - axis], last_[1 - axis]};
    const Bracket found = axis == 0 ? bracket<0>(at, anywhere) : bracket<1>(at, anywhere);
    return {(found.at_a[1 - axis] + found.at_b[1 - axis]) / 2};
}

bool MonotonePiece::touches(const Box2& box) const {
    if (!box_.overlaps(box)) return false;
    Box2 inside;
    const auto cut_at = [&](double y, const Vec2& end) {
        if (!(box_.lower.y < y && y < box_.upper.y)) return inside.extend(end);
        const Bracket at = bracket<1>(y, anywhere);
        inside.extend(at.at_a);
        inside.extend(at.at_b);
    };
    const bool rises = first_.y < last_.y;
    cut_at(box.lower.y, rises ? first_ : last_);
    cut_at(box.upper.y, rises ? last_ : first_);
    return inside.lower.x <= box.upper.x && box.lower.x <= inside.upper.x;
}

template <unsigned axis>
void MonotonePiece::narrow(double lower, double upper, double& from, double& to) const {
    const bool rises = first_[axis] < last_[axis];
    const auto is_between = [&](double at) {
        return box_.lower[axis] < at && at < box_.upper[axis];
    };
    const double enters = rises ? lower : upper, leaves = rises ? upper : lower;
    if (is_between(enters)) from = std::max(from, bracket<axis>(enters, anywhere).a);
    if (is_between(leaves)) to = std::min(to, bracket<axis>(leaves, anywhere).b);
}

std::optional<std::pair<double, double>> MonotonePiece::stretch_in(const Box2& box) const {
    if (!box_.overlaps(box)) return std::nullopt;
    double from = 0, to = 1;
    narrow<0>(box.lower.x, box.upper.x, from, to);
    narrow<1>(box.lower.y, box.upper.y, from, to);
    return from <= to ? std::optional(std::pair(from, to)) : std::nullopt;
}

std::vector<MonotonePiece> monotone_pieces(const BezierCurveView& curve, std::uint32_t index) {
    std::vector<double> cuts = extrema(curve, 0);
    for (const double t : extrema(curve, 1)) cuts.push_back(t);
    std::sort(cuts.begin(), cuts.end());

    std::vector<MonotonePiece> pieces;
    std::vector<Vec3> rest(curve.points.begin(), curve.points.end());
    double begin = 0;
    for (const double t : cuts) {
        // Extrema of x and y that nearly coincide (a cusp) are one cut.
        if (!(t - begin > 1e-12)) continue;
        auto [left, right] = bernstein_parts(rest, (t - begin) / (1 - begin));
        pieces.emplace_back(std::move(left), index, begin, t);
        rest = std::move(right);
        begin = t;
    }
    pieces.emplace_back(std::move(rest), index, begin, 1);
    return pieces;
}

} // namespace keiko
