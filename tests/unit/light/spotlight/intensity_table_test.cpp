#include "keiko/light/spotlight/photometric_web.h"

#include <gtest/gtest.h>

#include <vector>

using namespace keiko;

namespace {

/// Intensity from a table of one vertical angle, so that only the planes matter; plane i holds i +
/// 1.
double of_planes(std::vector<double> planes, PlaneSymmetry symmetry, double h) {
    std::vector<double> values;
    for (std::size_t i = 0; i < planes.size(); ++i) values.push_back(static_cast<double>(i + 1));
    return IntensityTable({0}, std::move(planes), std::move(values), symmetry)(0, h);
}

} // namespace

TEST(IntensityTable, PlanesThatStopShortOfAFullTurnCloseWithTheFirst) {
    const std::vector<double> planes{0, 90, 180, 270};
    const auto at = [&](double h) { return of_planes(planes, PlaneSymmetry::none, h); };
    EXPECT_DOUBLE_EQ(at(270), 4);
    EXPECT_DOUBLE_EQ(at(315), 2.5);
    EXPECT_DOUBLE_EQ(at(360), 1);
    EXPECT_DOUBLE_EQ(at(-45), 2.5);
    EXPECT_DOUBLE_EQ(at(765), 1.5);
}

TEST(IntensityTable, SymmetriesMirrorThePlanes) {
    using enum PlaneSymmetry;
    const std::vector<double> quarter{0, 45, 90}, half{0, 90, 180}, across{90, 180, 270};
    for (const double h : {30.0, 150.0, 210.0, 330.0})
        EXPECT_DOUBLE_EQ(of_planes(quarter, quadrant, h), 1 + 30 / 45.0);
    for (const double h : {30.0, 330.0, -30.0})
        EXPECT_DOUBLE_EQ(of_planes(half, bilateral, h), 1 + 30 / 90.0);
    for (const double h : {120.0, 60.0, -300.0})
        EXPECT_DOUBLE_EQ(of_planes(across, bilateral_across, h), 1 + 30 / 90.0);
    EXPECT_DOUBLE_EQ(of_planes(across, bilateral_across, 300), 1 + 150 / 90.0);
    EXPECT_DOUBLE_EQ(of_planes(quarter, lateral, -60), of_planes(quarter, lateral, 60));
    EXPECT_EQ(of_planes({0}, axial, 123), 1);
}

TEST(IntensityTable, IsDarkOutsideOfItsAngles) {
    const IntensityTable table({10, 20}, {-30, 30}, {1, 2, 3, 4}, PlaneSymmetry::limited);
    EXPECT_DOUBLE_EQ(table(15, 0), 2.5);
    EXPECT_EQ(table(20, 30), 4);
    EXPECT_EQ(table(9.99, 0), 0);
    EXPECT_EQ(table(20.01, 0), 0);
    EXPECT_EQ(table(15, 30.01), 0);
    EXPECT_EQ(table.largest(), 4);
}

TEST(IntensityTable, TellsBeyondWhichAngleAllIsDark) {
    const auto up_to = [](std::vector<double> values) {
        return IntensityTable({0, 30, 60, 90}, {0}, std::move(values), PlaneSymmetry::axial)
            .lit_up_to();
    };
    EXPECT_EQ(up_to({1, 1, 0, 0}), 60);
    EXPECT_EQ(up_to({1, 0, 0, 1}), 90);
    EXPECT_EQ(up_to({0, 0, 0, 0}), 0);
}
