#include "keiko/geometry/bernstein/bernstein_field.h"

#include "keiko/geometry/bernstein/binomial.h"
#include "keiko/geometry/bernstein/coefficient_lines.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

/// Values of the Bernstein polynomials at t, 0 to 1.
std::vector<double> basis(int degree, double t) {
    std::vector<double> row(static_cast<std::size_t>(degree) + 1);
    row.front() = 1;
    for (std::size_t n = 1; n < row.size(); ++n) raise_degree(row, n, t);
    return row;
}

BernsteinNet quadrant(const BernsteinNet& net, bool upper_u, bool upper_v) {
    BernsteinNet part;
    part.rows = net.rows;
    part.columns = net.columns;
    std::copy_n(net.c.begin(), net.rows * net.columns, part.c.begin());
    for (const bool along_u : {true, false}) {
        const auto lines = CoefficientLines::of_tensor(net.rows, net.columns, along_u);
        if (along_u ? upper_u : upper_v)
            keep_beyond(part.c.data(), lines, 0.5);
        else
            keep_before(part.c.data(), lines, 0.5);
    }
    return part;
}

/// Coefficients of the derivative of a net over a quadrant, one unit wide: by x or by y.
BernsteinNet derivative(const BernsteinNet& net, bool by_x) {
    BernsteinNet d;
    d.rows = net.rows - (by_x ? 1 : 0);
    d.columns = net.columns - (by_x ? 0 : 1);
    const auto degree = static_cast<double>((by_x ? net.rows : net.columns) - 1);
    for (std::size_t i = 0; i < d.rows; ++i)
        for (std::size_t j = 0; j < d.columns; ++j)
            d.at(i, j) =
                degree * (by_x ? net.at(i + 1, j) - net.at(i, j) : net.at(i, j + 1) - net.at(i, j));
    return d;
}

/// Largest magnitude; 0 for the derivative of a constant, which has no coefficients.
double magnitude(const BernsteinNet& net) {
    double most = 0;
    for (std::size_t i = 0; i < net.rows * net.columns; ++i)
        most = std::max(most, std::abs(net.c[i]));
    return most;
}

void extend(NetBounds& b, const BernsteinNet& part) {
    for (std::size_t i = 0; i < part.rows * part.columns; ++i) {
        b.low = std::min(b.low, part.c[i]);
        b.high = std::max(b.high, part.c[i]);
    }
    const BernsteinNet x = derivative(part, true), y = derivative(part, false);
    const double xx = x.rows > 0 ? magnitude(derivative(x, true)) : 0;
    const double yy = y.columns > 0 ? magnitude(derivative(y, false)) : 0;
    const double xy = x.rows > 0 && x.columns > 0 ? magnitude(derivative(x, false)) : 0;
    b.slope = std::max(b.slope, magnitude(x) + magnitude(y));
    b.bend = std::max(b.bend, xx + 2 * xy + yy);
    b.bend_u = std::max(b.bend_u, xx);
    b.bend_v = std::max(b.bend_v, yy);
    b.twist = std::max(b.twist, xy);
}

} // namespace

double BernsteinField::magnitude() const {
    double most = 0;
    for (const double c : coefficients_) most = std::max(most, std::abs(c));
    return most;
}

Interval BernsteinField::range() const {
    const auto [low, high] = std::minmax_element(coefficients_.begin(), coefficients_.end());
    return Interval(*low, *high).padded(rounding_);
}

Interval BernsteinField::side_range(bool by_u, bool upper) const {
    const int fixed = upper ? (by_u ? degree_u_ : degree_v_) : 0;
    const int last = by_u ? degree_v_ : degree_u_;
    const auto on_side = [&](int k) { return by_u ? at(fixed, k) : at(k, fixed); };
    Interval all(on_side(0));
    for (int k = 1; k <= last; ++k)
        all = {std::min(all.low, on_side(k)), std::max(all.high, on_side(k))};
    return all.padded(rounding_);
}

BernsteinField BernsteinField::derivative(bool by_u) const {
    const int degree = by_u ? degree_u_ : degree_v_;
    if (degree == 0) return BernsteinField();
    const int rows = degree_u_ - (by_u ? 1 : 0), columns = degree_v_ - (by_u ? 0 : 1);
    std::vector<double> slopes(static_cast<std::size_t>(rows + 1) *
                               static_cast<std::size_t>(columns + 1));
    auto next = slopes.begin();
    for (int i = 0; i <= rows; ++i)
        for (int j = 0; j <= columns; ++j)
            *next++ = degree * (at(i + (by_u ? 1 : 0), j + (by_u ? 0 : 1)) - at(i, j));
    return {rows, columns, std::move(slopes),
            degree * (2 * rounding_ + 4 * unit_roundoff * magnitude())};
}

double BernsteinField::operator()(const Vec2& uv) const {
    const std::vector<double> u = basis(degree_u_, uv.x), v = basis(degree_v_, uv.y);
    double sum = 0;
    std::size_t next = 0;
    for (const double by_u : u) {
        double along = 0;
        for (const double by_v : v) along += by_v * coefficients_[next++];
        sum += by_u * along;
    }
    return sum;
}

std::array<BernsteinField, 2> BernsteinField::parts(bool by_u, double share) const {
    BernsteinField first = *this, second = *this;
    const auto lines = CoefficientLines::of_tensor(static_cast<std::size_t>(degree_u_) + 1,
                                                   static_cast<std::size_t>(degree_v_) + 1, by_u);
    split_lines(second.coefficients_.data(), first.coefficients_.data(), lines, share);
    // Means round by some units in the last place each, and errors mix as values do.
    const double more = 3.0 * static_cast<double>(lines.count) * unit_roundoff * magnitude();
    first.rounding_ += more, second.rounding_ += more;
    return {std::move(first), std::move(second)};
}

BernsteinField BernsteinField::without_side(bool by_u, bool upper) const {
    const int degree = by_u ? degree_u_ : degree_v_;
    assert(degree >= 1);
    const int rows = degree_u_ - (by_u ? 1 : 0), columns = degree_v_ - (by_u ? 0 : 1);
    const int shift = upper ? 0 : 1;
    std::vector<double> rest;
    for (int i = 0; i <= rows; ++i)
        for (int j = 0; j <= columns; ++j) {
            const int k = by_u ? i : j;
            const double share = static_cast<double>(upper ? degree - k : k + 1) / degree;
            rest.push_back(at(i + (by_u ? shift : 0), j + (by_u ? 0 : shift)) / share);
        }
    BernsteinField divided(rows, columns, std::move(rest), degree * rounding_);
    divided.rounding_ += 2 * unit_roundoff * divided.magnitude();
    return divided;
}

BernsteinField operator*(const BernsteinField& a, const BernsteinField& b) {
    const int degree_u = a.degree_u_ + b.degree_u_, degree_v = a.degree_v_ + b.degree_v_;
    BernsteinField product(degree_u, degree_v,
                           std::vector<double>(static_cast<std::size_t>(degree_u + 1) *
                                               static_cast<std::size_t>(degree_v + 1)),
                           0);
    const auto row = [](int degree) { return binomials(static_cast<std::size_t>(degree)); };
    const auto au = row(a.degree_u_), av = row(a.degree_v_), bu = row(b.degree_u_),
               bv = row(b.degree_v_), u = row(degree_u), v = row(degree_v);
    const auto of = [](const std::vector<double>& numbers, int k) {
        return numbers[static_cast<std::size_t>(k)];
    };
    for (int i = 0; i <= a.degree_u_; ++i)
        for (int j = 0; j <= a.degree_v_; ++j) {
            const double factor = a.at(i, j) * of(au, i) * of(av, j);
            if (factor == 0) continue;
            for (int k = 0; k <= b.degree_u_; ++k)
                for (int l = 0; l <= b.degree_v_; ++l)
                    product.coefficients_[product.index(i + k, j + l)] +=
                        factor * b.at(k, l) * of(bu, k) * of(bv, l);
        }
    for (int i = 0; i <= degree_u; ++i)
        for (int j = 0; j <= degree_v; ++j)
            product.coefficients_[product.index(i, j)] /= of(u, i) * of(v, j);
    // Each coefficient is a mean of products, summed in as many steps as there are.
    const double steps =
        (a.degree_u_ + 1.0) * (a.degree_v_ + 1.0) + 4.0 * (degree_u + degree_v) + 8;
    const double am = a.magnitude(), bm = b.magnitude();
    product.rounding_ = am * b.rounding_ + bm * a.rounding_ + a.rounding_ * b.rounding_ +
                        steps * unit_roundoff * am * bm;
    return product;
}

BernsteinField operator+(const BernsteinField& a, const BernsteinField& b) {
    assert(a.degree_u_ == b.degree_u_ && a.degree_v_ == b.degree_v_);
    BernsteinField sum = a;
    for (std::size_t i = 0; i < sum.coefficients_.size(); ++i)
        sum.coefficients_[i] += b.coefficients_[i];
    sum.rounding_ += b.rounding_ + unit_roundoff * sum.magnitude();
    return sum;
}

BernsteinField operator-(const BernsteinField& a, const BernsteinField& b) {
    BernsteinField negative = b;
    for (double& c : negative.coefficients_) c = -c;
    return a + negative;
}

NetBounds net_bounds(const BernsteinNet& net) {
    NetBounds b;
    b.low = std::numeric_limits<double>::infinity();
    b.high = -b.low;
    for (const bool upper_u : {false, true})
        for (const bool upper_v : {false, true}) extend(b, quadrant(net, upper_u, upper_v));
    // Halving m times rounds m times, a difference once more, and is multiplied by its degree.
    const auto steps = static_cast<double>(net.rows + net.columns);
    const double rounding = std::numeric_limits<double>::epsilon() * steps * magnitude(net);
    b.low -= rounding;
    b.high += rounding;
    b.slope += 4 * steps * rounding;
    b.bend += 16 * steps * steps * rounding;
    return b;
}

} // namespace keiko
