#include "keiko/geometry/bezier/patch_height.h"

#include "keiko/math/jet.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

using RangeJet = Jet<Jet<Interval>>;

/// The relative rounding of a sum of four products.
constexpr double product_rounding = 1e-15;

BernsteinField height_field(const BezierPatchView& patch, const Height& height, bool rational) {
    std::vector<double> coefficients;
    double largest = 0;
    for (const Vec4& p : patch.points) {
        const double w = rational ? 1 : p.w;
        const Vec3 place(p.x / w, p.y / w, p.z / w);
        coefficients.push_back(height.slope.dot(place) + height.offset * (p.w / w));
        largest = std::max(largest, magnitudes(height.slope).dot(magnitudes(place)) +
                                        std::abs(height.offset * (p.w / w)));
    }
    return {patch.degree_u, patch.degree_v, std::move(coefficients), product_rounding * largest};
}

BernsteinField weight_field(const BezierPatchView& patch, bool rational) {
    if (!rational) return {0, 0, {1.0}, 0};
    std::vector<double> coefficients;
    for (const Vec4& p : patch.points) coefficients.push_back(p.w);
    return {patch.degree_u, patch.degree_v, std::move(coefficients), 0};
}

/// Value and first derivatives.
Jet<Interval> first_jet(const BernsteinField& field) {
    return {field.range(), field.derivative(true).range(), field.derivative(false).range()};
}

RangeJet second_jet(const BernsteinField& field) {
    const BernsteinField x = field.derivative(true), y = field.derivative(false);
    const Interval xy = x.derivative(false).range();
    return {{field.range(), x.range(), y.range()},
            {x.range(), x.derivative(true).range(), xy},
            {y.range(), xy, y.derivative(false).range()}};
}

} // namespace

PatchHeight::PatchHeight(const BezierPatchView& patch, const Height& height)
    : PatchHeight(height_field(patch, height, patch.rational()),
                  weight_field(patch, patch.rational()), unit_square, Box3::infinity) {}

PatchHeight::PatchHeight(BernsteinField height, BernsteinField weight, const Box2& uv, double upper)
    : height_(std::move(height)), weight_(std::move(weight)), uv_(uv), upper_(-Box3::infinity) {
    for (int i = 0; i <= height_.degree_u(); ++i)
        for (int j = 0; j <= height_.degree_v(); ++j) upper_ = std::max(upper_, at(i, j));
    upper_ = std::min(upper_, upper);
}

double PatchHeight::weight(int i, int j) const {
    const bool even = weight_.degree_u() == 0 && weight_.degree_v() == 0;
    return even ? weight_.at(0, 0) : weight_.at(i, j);
}

double PatchHeight::at(int i, int j) const {
    return height_.at(i, j) / weight(i, j);
}

std::array<double, 4> PatchHeight::corners() const {
    const int n = height_.degree_u(), m = height_.degree_v();
    return {at(0, 0), at(n, 0), at(0, m), at(n, m)};
}

double PatchHeight::variation(bool by_u) const {
    double most = 0;
    const int lines = by_u ? height_.degree_v() : height_.degree_u();
    const int last = by_u ? height_.degree_u() : height_.degree_v();
    for (int line = 0; line <= lines; ++line) {
        double along = 0;
        for (int k = 1; k <= last; ++k)
            along += by_u ? std::abs(at(k, line) - at(k - 1, line))
                          : std::abs(at(line, k) - at(line, k - 1));
        most = std::max(most, along);
    }
    return most;
}

bool PatchHeight::varies_by_u() const {
    return variation(true) >= variation(false);
}

/// The height over its corner, times weight: near 0, where numbers are small.
BernsteinField PatchHeight::centered() const {
    const double corner = at(0, 0);
    std::vector<double> coefficients;
    for (int i = 0; i <= height_.degree_u(); ++i)
        for (int j = 0; j <= height_.degree_v(); ++j)
            coefficients.push_back(height_.at(i, j) - corner * weight(i, j));
    const double rounding = height_.rounding() + std::abs(corner) * weight_.rounding() +
                            product_rounding * height_.magnitude();
    return {height_.degree_u(), height_.degree_v(), std::move(coefficients), rounding};
}

bool PatchHeight::may_be_level() const {
    const Jet<Interval> slope = first_jet(centered()) / first_jet(weight_);
    const Vec2 extent = uv_.extent();
    return (extent.x == 0 || slope.u.holds_zero()) && (extent.y == 0 || slope.v.holds_zero());
}

PatchHeight::Slopes PatchHeight::slopes() const {
    const RangeJet height = second_jet(centered()) / second_jet(weight_);
    return {height.u.f, height.v.f, height.u.u, height.u.v, height.v.v};
}

std::array<PatchHeight, 2> PatchHeight::halves(bool by_u) const {
    auto heights = height_.parts(by_u, 0.5), weights = weight_.parts(by_u, 0.5);
    const unsigned axis = by_u ? 0 : 1;
    Box2 low = uv_, high = uv_;
    low.upper[axis] = high.lower[axis] = uv_.center()[axis];
    return {PatchHeight(std::move(heights[0]), std::move(weights[0]), low, upper_),
            PatchHeight(std::move(heights[1]), std::move(weights[1]), high, upper_)};
}

PatchHeight PatchHeight::narrowed(unsigned axis, double lower, double upper) const {
    const bool by_u = axis == 0;
    const double begin = uv_.lower[axis], extent = uv_.extent()[axis];
    if (extent == 0) return *this;
    const double high = std::clamp((upper - begin) / extent, 0.0, 1.0);
    const double low = high > 0 ? std::clamp((lower - begin) / extent / high, 0.0, 1.0) : 0;
    Box2 uv = uv_;
    uv.lower[axis] = lower, uv.upper[axis] = upper;
    return {height_.parts(by_u, high)[0].parts(by_u, low)[1],
            weight_.parts(by_u, high)[0].parts(by_u, low)[1], uv, upper_};
}

PatchHeight PatchHeight::over(const Box2& part) const {
    return narrowed(0, part.lower.x, part.upper.x).narrowed(1, part.lower.y, part.upper.y);
}

} // namespace keiko
