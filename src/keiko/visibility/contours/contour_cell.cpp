#include "keiko/visibility/contours/contour_cell.h"

#include "keiko/geometry/bernstein/bernstein.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>
#include <utility>

namespace keiko {
namespace {

/// Differences of neighbouring coefficients along one parameter.
struct Steps {
    double low = 0, high = 0; ///< 0 among them
    double mean = 0;          ///< of their magnitudes

    bool have_one_sign() const { return low >= 0 || high <= 0; }
};

Steps steps(const ScalarNet& net, bool by_u) {
    Steps all;
    std::size_t count = 0;
    for (std::size_t i = 0; i + by_u < net.rows; ++i)
        for (std::size_t j = 0; j + !by_u < net.columns; ++j, ++count) {
            const double step = net.at(i + by_u, j + !by_u) - net.at(i, j);
            all.low = std::min(all.low, step), all.high = std::max(all.high, step);
            all.mean += std::abs(step);
        }
    if (count > 0) all.mean /= static_cast<double>(count);
    return all;
}

bool has_one_sign(const ScalarNet& net) {
    const auto [low, high] = std::minmax_element(net.c.begin(), net.c.end());
    return *low >= 0 || *high < 0;
}

ScalarNet transposed(const ScalarNet& net) {
    ScalarNet other{net.columns, net.rows, std::vector<double>(net.c.size())};
    for (std::size_t i = 0; i < net.rows; ++i)
        for (std::size_t j = 0; j < net.columns; ++j) other.at(j, i) = net.at(i, j);
    return other;
}

/// A polynomial of one parameter by its Bernstein coefficients.
struct Row {
    BernsteinRow c;
    std::size_t count = 0;

    /// Along the first parameter at a second one.
    static Row across(const ScalarNet& net, double along) {
        const BernsteinRow weights = bernstein_values(static_cast<int>(net.columns) - 1, along);
        Row row;
        row.count = net.rows;
        for (std::size_t i = 0; i < net.rows; ++i) {
            row.c[i] = 0;
            for (std::size_t j = 0; j < net.columns; ++j) row.c[i] += weights[j] * net.at(i, j);
        }
        return row;
    }
    /// Along the second parameter at an end of the first one.
    static Row at_end(const ScalarNet& net, std::size_t i) {
        Row row;
        row.count = net.columns;
        for (std::size_t j = 0; j < net.columns; ++j) row.c[j] = net.at(i, j);
        return row;
    }
    struct Value {
        double value, derivative;
    };
    Value at(double x) const {
        if (count == 1) return {c[0], 0};
        BernsteinRow row; // only what is set is read
        for (std::size_t i = 0; i < count; ++i) row[i] = c[i];
        for (std::size_t left = count - 1; left > 1; --left)
            for (std::size_t i = 0; i < left; ++i) row[i] += x * (row[i + 1] - row[i]);
        const double slope = row[1] - row[0];
        return {row[0] + x * slope, slope * static_cast<double>(count - 1)};
    }
    int sign_changes() const {
        int changes = 0;
        for (std::size_t i = 1; i < count; ++i) changes += (c[i] >= 0) != (c[i - 1] >= 0);
        return changes;
    }
};

/// The only zero of a polynomial between ends of opposite signs, by Newton's method within
/// brackets; the end that is nearer to zero if they are not.
double only_zero(const Row& row) {
    constexpr int most_steps = 60;
    constexpr double rounding = 1e-15, squared = 1e-9; // steps whose square is rounding
    double low = 0, high = 1;
    const double first = row.c[0], last = row.c[row.count - 1];
    const bool rises = last > first;
    if (rises ? first >= 0 : first <= 0) return 0;
    if (rises ? last <= 0 : last >= 0) return 1;
    double x = first / (first - last);
    for (int i = 0; i < most_steps && high - low > rounding; ++i) {
        const Row::Value f = row.at(x);
        ((f.value > 0) == rises ? high : low) = x;
        const double next = x - f.value / f.derivative;
        if (!(next >= low && next <= high)) {
            x = (low + high) / 2;
            continue;
        }
        if (std::abs(next - x) <= squared) return next;
        x = next;
    }
    return x;
}

/// Zeros in (0, 1), rising.
std::vector<double> zeros(const Row& row) {
    const int changes = row.sign_changes();
    if (changes == 0) return {};
    if (changes == 1) return {only_zero(row)}; // Descartes' rule
    return bernstein_roots(std::span(row.c).first(row.count), 0);
}

} // namespace

std::vector<ContourCell> ContourCell::all(ScalarNet function) {
    std::vector<ContourCell> cells;
    split(std::move(function), {Vec2(0), Vec2(1)}, 0, cells);
    return cells;
}

void ContourCell::split(ScalarNet function, const Box2& box, int depth,
                        std::vector<ContourCell>& cells) {
    constexpr int most_halvings = 28; // of both parameters together
    if (has_one_sign(function)) return;
    const Steps by_u = steps(function, true), by_v = steps(function, false);
    const bool u_rises = by_u.have_one_sign(), v_rises = by_v.have_one_sign();
    const bool first_is_v = v_rises && (!u_rises || by_v.mean > by_u.mean);
    if (u_rises || v_rises || depth == most_halvings) {
        ContourCell cell(first_is_v ? transposed(function) : function, box, first_is_v);
        if (cell.is_sound() || depth == most_halvings) return cells.push_back(std::move(cell));
    }
    const unsigned axis = by_u.high - by_u.low >= by_v.high - by_v.low ? 0 : 1;
    Box2 low = box, high = box;
    low.upper[axis] = high.lower[axis] = box.center()[axis];
    auto [below, above] = halved(function, axis);
    split(std::move(below), low, depth + 1, cells);
    split(std::move(above), high, depth + 1, cells);
}

ContourCell::ContourCell(ScalarNet function, const Box2& box, bool swapped)
    : net_(std::move(function)), box_(box), swapped_(swapped) {
    const std::vector<double> at = ends();
    for (std::size_t i = 0; i + 1 < at.size(); i += 2) parts_.push_back({at[i], at[i + 1]});
    is_sound_ = at.size() % 2 == 0 &&
                std::all_of(parts_.begin(), parts_.end(),
                            [&](const ParameterInterval& part) { return has_zero_amid(part); });
}

std::vector<double> ContourCell::ends() const {
    std::vector<double> ends;
    const std::size_t columns = net_.columns, last = net_.rows - 1;
    // Where the zero enters or leaves by an end of the second parameter.
    for (const std::size_t j : {std::size_t{0}, columns - 1})
        if ((net_.at(0, j) >= 0) != (net_.at(last, j) >= 0)) ends.push_back(j == 0 ? 0 : 1);
    // Where it does by an end of the first one.
    for (const std::size_t i : {std::size_t{0}, last}) {
        for (const double zero : zeros(Row::at_end(net_, i))) ends.push_back(zero);
    }
    std::sort(ends.begin(), ends.end());
    return ends;
}

bool ContourCell::has_zero_amid(const ParameterInterval& part) const {
    constexpr double point = 1e-9; // of the cell: signs over what is shorter are rounding
    const Row row = Row::across(net_, (part.begin + part.end) / 2);
    return part.length() <= point || (row.c[0] >= 0) != (row.c[row.count - 1] >= 0);
}

Vec2 ContourCell::zero(double along) const {
    const double first = only_zero(Row::across(net_, along));
    return box_.lower + box_.extent() * (swapped_ ? Vec2(along, first) : Vec2(first, along));
}

Vec2 ContourCell::gradient(const Vec2& uv) const {
    const Vec2 own = (uv - box_.lower) / box_.extent();
    const double first = swapped_ ? own.y : own.x, second = swapped_ ? own.x : own.y;
    const double by_first = Row::across(net_, second).at(first).derivative;
    const double by_second = Row::across(transposed(net_), first).at(second).derivative;
    return (swapped_ ? Vec2(by_second, by_first) : Vec2(by_first, by_second)) / box_.extent();
}

} // namespace keiko
