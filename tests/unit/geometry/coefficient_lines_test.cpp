// Lines of a tensor cut and continued, against the polynomials' own values.
#include "keiko/geometry/bernstein/coefficient_lines.h"

#include "keiko/geometry/bernstein/de_casteljau.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace keiko {
namespace {

constexpr std::size_t rows = 4, columns = 6;

std::vector<double> coefficients() {
    test::Random random(1);
    std::vector<double> c;
    for (std::size_t i = 0; i < rows * columns; ++i) c.push_back(test::uniform(random, -1, 1));
    return c;
}

/// The value of a line at t.
double value(const std::vector<double>& c, const CoefficientLines& at, std::size_t line, double t) {
    std::vector<double> own;
    for (std::size_t i = 0; i < at.count; ++i) own.push_back(c[i * at.step + line * at.stride]);
    return bernstein_value(own, t);
}

/// Expects that lines at t have the values of others at `whole(t)`.
void expect_same(const std::vector<double>& part, const std::vector<double>& whole,
                 const CoefficientLines& at, const std::function<double(double)>& where) {
    for (std::size_t line = 0; line < at.lines; ++line)
        for (const double t : {0.0, 0.2, 0.7, 1.0})
            EXPECT_NEAR(value(part, at, line, t), value(whole, at, line, where(t)), 1e-13);
}

TEST(CoefficientLines, AreThoseOfTheTensorAlongEitherParameter) {
    const auto u = CoefficientLines::of_tensor(rows, columns, true);
    const auto v = CoefficientLines::of_tensor(rows, columns, false);
    EXPECT_EQ(u.count, rows);
    EXPECT_EQ(u.lines, columns);
    EXPECT_EQ(v.count, columns);
    EXPECT_EQ(v.lines, rows);
    EXPECT_EQ(2 * u.step + 3 * u.stride, 3 * v.step + 2 * v.stride);
}

TEST(CoefficientLines, KeepTheirValuesWhereTheyAreCut) {
    const std::vector<double> whole = coefficients();
    for (const bool along_u : {true, false}) {
        const auto at = CoefficientLines::of_tensor(rows, columns, along_u);
        std::vector<double> part = whole;
        restrict_lines(part.data(), at, 0.3, 0.8);
        expect_same(part, whole, at, [](double t) { return 0.3 + 0.5 * t; });
        std::vector<double> beyond = whole, before(whole.size());
        split_lines(beyond.data(), before.data(), at, 0.3);
        expect_same(before, whole, at, [](double t) { return 0.3 * t; });
        expect_same(beyond, whole, at, [](double t) { return 0.3 + 0.7 * t; });
    }
}

TEST(CoefficientLines, GoOnBeyondTheirEnds) {
    const std::vector<double> whole = coefficients();
    const auto at = CoefficientLines::of_tensor(rows, columns, true);
    std::vector<double> longer = whole;
    keep_beyond(longer.data(), at, -0.1);
    expect_same(longer, whole, at, [](double t) { return -0.1 + 1.1 * t; });
    longer = whole;
    keep_before(longer.data(), at, 1.1);
    expect_same(longer, whole, at, [](double t) { return 1.1 * t; });
}

} // namespace
} // namespace keiko
