#include "keiko/math/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace keiko;

TEST(PairedQuadrature, RulesAreExactToTheirDegrees) {
    for (const int power : {0, 1, 2, 3, 6, 7, 8, 12, 13, 14}) {
        const auto sum = paired_panel([&](double x) { return std::pow(x, power); }, 0, 2);
        const double truth = std::pow(2, power + 1) / (power + 1);
        const double coarse = std::abs(sum.coarse / truth - 1);
        const double fine = std::abs(sum.fine / truth - 1);
        EXPECT_EQ(coarse < 1e-14, power <= 7) << power << " is off by " << coarse;
        EXPECT_EQ(fine < 1e-14, power <= 13) << power << " is off by " << fine;
    }
}

TEST(PairedQuadrature, HalvesWhereTheRulesDisagree) {
    int calls = 0;
    const auto peak = [&](double x) {
        ++calls;
        return 1 / (1e-4 + x * x);
    };
    Breakpoints range(-1, 1);
    const double truth = 200 * std::atan(100);
    EXPECT_NEAR(integrate_paired(peak, range, 1e-6, 20), truth, 1e-6 * truth);
    EXPECT_GT(calls, 9);
    calls = 0;
    range.cut_at(0.5);
    EXPECT_NEAR(integrate_paired([&](double x) { return ++calls, std::exp(x); }, range, 1e-6),
                2 * std::sinh(1), 1e-12);
    EXPECT_EQ(calls, 2 * 9);
}

TEST(Breakpoints, SumsOverRisingPiecesWithinTheRange) {
    Breakpoints range(1, 4);
    for (const double place : {3.0, 0.5, 2.0, 4.5, 2.5}) range.cut_at(place);
    std::vector<double> ends;
    const double length = sum_over_pieces(range, [&](double a, double b) {
        ends.push_back(b);
        return b - a;
    });
    EXPECT_EQ(length, 3);
    EXPECT_EQ(ends, (std::vector<double>{2, 2.5, 3, 4}));
}

TEST(Breakpoints, DropsNoCut) {
    Breakpoints range(0, 9);
    for (int place = 8; place >= 1; --place) range.cut_at(place);
    ASSERT_EQ(range.places().size(), Breakpoints::most_pieces + 1);
    for (std::size_t i = 0; i < range.places().size(); ++i)
        EXPECT_EQ(range.places()[i], static_cast<double>(i));
    range.cut_at(9);
    EXPECT_THROW(range.cut_at(0.5), std::length_error);
}
