// Free edges on the inside of other faces: laps, tees and crossings.
#include "keiko/base/units.h"
#include "keiko/inspect/inspection.h"

#include "tests/support/long_run.h"
#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace keiko {
namespace {

constexpr double length = 100, depth = 50; ///< mm of either sheet, along x and y
constexpr double join = 0.5;

class Dice {
public:
    explicit Dice(unsigned seed) : random_(seed) {}
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    /// Random size, uniform in its logarithm: as many in each octave.
    double size_between(double low, double high) {
        return std::exp(between(std::log(low), std::log(high)));
    }

private:
    std::mt19937 random_;
};

int case_count() {
    return test::long_run() ? 2000 : 200;
}

/// The sheet y < 0, its border y = 0.
void lower_sheet(test::ModelBuilder& builder) {
    builder.plane({0, -depth, 0}, {length, 0, 0}, {0, depth, 0});
}

/// The sheet y > 0 at a height, its lower border through `border`, from x = 0 to length, y >= -40.
void upper_sheet(test::ModelBuilder& builder, const std::vector<Vec2>& border, double height = 0) {
    builder.plane({0, -40, height}, {length, 0, 0}, {0, 40 + depth, 0});
    std::vector<Vec2> corners;
    for (const Vec2& p : border) corners.emplace_back(p.x / length, (p.y + 40) / (40 + depth));
    corners.insert(corners.end(), {{1, 1}, {0, 1}});
    builder.polygon(corners);
}

std::vector<Check> looks_of(const SurfaceModel& model, const std::string& code) {
    std::vector<Check> looks;
    for (const Check& look : inspect(model, {}, join).looks)
        if (look.code == code) looks.push_back(look);
    return looks;
}

/// Without overlaps, tees and crossings.
void expect_nothing(const SurfaceModel& model, const std::string& what) {
    for (const char* code : {"KEIKO-OVERLAP", "KEIKO-TEE", "KEIKO-CROSSING"})
        for (const Check& look : looks_of(model, code))
            ADD_FAILURE() << what << ": " << code << " " << look.message;
}

Box3 box_of(const Vec3& low, const Vec3& high) {
    Box3 box;
    box.extend(low);
    box.extend(high);
    return box.padded(0.01);
}

TEST(Overlaps, AreTonguesThatLieOnTheOtherSheet) {
    Dice dice(20261126);
    for (int i = 0; i < case_count(); ++i) {
        const double deep = dice.size_between(0.7, 20), wide = dice.size_between(0.3, 40);
        const double x = dice.between(25, 75 - wide), lean = dice.between(-0.3, 0.3) * wide;
        test::ModelBuilder builder;
        lower_sheet(builder);
        upper_sheet(builder, {{0, 0},
                              {x, 0},
                              {x + std::max(lean, 0.0), -deep},
                              {x + wide + std::min(lean, 0.0), -deep},
                              {x + wide, 0},
                              {length, 0}});
        const auto found = looks_of(builder.build(), "KEIKO-OVERLAP");
        const auto tongue = std::find_if(found.begin(), found.end(), [&](const Check& look) {
            return std::abs(look.worst.place.y + deep) < 0.01;
        });
        ASSERT_NE(tongue, found.end()) << i << ": " << wide << " x " << deep << " mm at " << x;
        // The border that a wide tongue covers is listed too.
        EXPECT_LE(found.size(), 2u) << i;
        const Box3 box = box_of({x - 1, -deep, 0}, {x + wide + 1, 0, 0});
        for (const Check& look : found) EXPECT_TRUE(box.contains(look.worst.place)) << i;
        const Check& look = *tongue;
        EXPECT_GE(look.worst.value, wide - std::abs(lean) - 1e-9) << i;
        EXPECT_LE(look.worst.value, wide + 2 * std::hypot(deep, lean)) << i;
        EXPECT_EQ(look.severity, Check::Severity::look);
    }
}

TEST(Overlaps, AreSheetsThatReachOverTheirNeighbour) {
    Dice dice(20261127);
    for (int i = 0; i < case_count(); ++i) {
        const double deep = dice.size_between(0.6, 20), height = dice.between(0, 0.45);
        test::ModelBuilder builder;
        lower_sheet(builder);
        upper_sheet(builder, {{20, -deep}, {80, -deep}}, height);
        const auto found = looks_of(builder.build(), "KEIKO-OVERLAP");
        const auto lower = std::find_if(found.begin(), found.end(), [&](const Check& look) {
            return std::abs(look.worst.place.y + deep) < 1e-6;
        });
        ASSERT_NE(lower, found.end()) << i << ": " << deep << " mm, " << height << " mm above";
        EXPECT_GE(lower->worst.value, 60 - 1e-9);
    }
}

/// A panel bent with a radius of some `radius` mm, 200 mm by 200 mm about the origin.
void bent_panel(test::ModelBuilder& builder, double radius) {
    std::vector<Vec3> points;
    for (const double x : {-100.0, 0.0, 100.0})
        for (const double y : {-100.0, 0.0, 100.0})
            // z = (x^2 + y^2) / (2 R) over [-100, 100]^2 by its Bezier points.
            points.emplace_back(x, y,
                                ((x == 0 ? -1e4 : 1e4) + (y == 0 ? -1e4 : 1e4)) / (2 * radius));
    builder.patch(2, 2, points);
}

TEST(Overlaps, ArePatchesThatLieOnAPanel) {
    Dice dice(20261128);
    for (int i = 0; i < case_count(); ++i) {
        const double radius = dice.size_between(300, 20000), height = dice.between(-0.4, 0.4);
        const double size = dice.size_between(1, 40);
        const double x = dice.between(-40, 40), y = dice.between(-40, 40);
        test::ModelBuilder builder;
        bent_panel(builder, radius);
        // As much of the same paraboloid, lifted.
        std::vector<Vec3> points;
        for (const double u : {0.0, 0.5, 1.0})
            for (const double v : {0.0, 0.5, 1.0}) {
                const auto square = [&](double from, double s) {
                    return s == 0.5 ? from * (from + size) : std::pow(from + s * size, 2);
                };
                points.emplace_back(x + u * size, y + v * size,
                                    height + (square(x, u) + square(y, v)) / (2 * radius));
            }
        builder.patch(2, 2, points);
        const auto found = looks_of(builder.build(), "KEIKO-OVERLAP");
        ASSERT_EQ(found.size(), 1u) << i << ": " << size << " mm, " << height << " mm above";
        EXPECT_NEAR(found[0].worst.value, 4 * size, 0.15 * size) << i;
    }
}

TEST(Overlaps, AreTeesWhereAFaceStandsOnAnother) {
    Dice dice(20261129);
    for (int i = 0; i < case_count(); ++i) {
        const double angle = dice.between(32, 90), gap = dice.between(0, 0.45);
        const double long_ = dice.size_between(1, 80), turn = dice.between(0, 360);
        const double a = degrees_to_radians(angle), t = degrees_to_radians(turn);
        const Vec3 along(std::cos(t), std::sin(t), 0), across(-along.y, along.x, 0);
        test::ModelBuilder builder;
        builder.plane({-100, -100, 0}, {200, 0, 0}, {0, 200, 0});
        builder.plane(Vec3(0, 0, gap) - along * (long_ / 2), along * long_,
                      (across * std::cos(a) + Vec3(0, 0, std::sin(a))) * 20);
        const auto found = looks_of(builder.build(), "KEIKO-TEE");
        ASSERT_EQ(found.size(), 1u) << i << ": " << angle << " degrees, " << gap << " mm above";
        EXPECT_NEAR(found[0].worst.value, long_, 1e-6) << i;
        EXPECT_NE(found[0].message.find("degrees to it"), std::string::npos);
    }
}

TEST(Overlaps, AreCrossingsOfPanels) {
    Dice dice(20261130);
    for (int i = 0; i < case_count(); ++i) {
        const double tilt = degrees_to_radians(dice.between(3, 90));
        const double turn = degrees_to_radians(dice.between(0, 360));
        const double size = dice.size_between(40, 120), shift = dice.between(-0.3, 0.3) * size;
        const Vec3 along(std::cos(turn), std::sin(turn), 0);
        const Vec3 up =
            Vec3(-along.y, along.x, 0) * std::cos(tilt) + Vec3(0, 0, 1) * std::sin(tilt);
        test::ModelBuilder builder;
        builder.plane({-100, -100, 0}, {200, 0, 0}, {0, 200, 0});
        builder.plane(up * (shift - size / 2) - along * (size / 2), along * size, up * size);
        const auto found = looks_of(builder.build(), "KEIKO-CROSSING");
        ASSERT_EQ(found.size(), 2u) << i << ": " << radians_to_degrees(tilt) << " degrees";
        for (const Check& look : found) EXPECT_NEAR(look.worst.place.z, 0, 0.06) << i;
    }
}

TEST(Overlaps, AreNoneAtSeamsAndCornersOfPanels) {
    Dice dice(20261201);
    for (int i = 0; i < case_count(); ++i) {
        // A sheet bent up by any angle, at most as wide as the lower one.
        const double angle = degrees_to_radians(dice.between(12, 180));
        const double left = dice.between(-5, 30), right = dice.between(60, 105);
        test::ModelBuilder builder;
        lower_sheet(builder);
        builder.plane(
            {left, 0, 0}, {right - left, 0, 0},
            Vec3(dice.between(-20, 20), -std::cos(angle) * depth, std::sin(angle) * depth));
        expect_nothing(builder.build(), std::to_string(radians_to_degrees(angle)) + " degrees");
    }
}

TEST(Overlaps, AreNoneInAClosedBox) {
    test::ModelBuilder builder;
    const Vec3 x(60, 0, 0), y(0, 40, 0), z(0, 0, 20);
    for (const auto& [u, v, w] : {std::array{x, y, z}, std::array{y, z, x}, std::array{z, x, y}}) {
        builder.plane({0, 0, 0}, u, v);
        builder.plane(w, u, v);
    }
    expect_nothing(builder.build(), "box");
}

TEST(Overlaps, AreNoneInASmoothSheetOfManyFaces) {
    Dice dice(20261202);
    for (int i = 0; i < case_count() / 10; ++i) {
        const double radius = dice.size_between(100, 5000), size = dice.size_between(2, 40);
        test::ModelBuilder builder;
        for (int row = -2; row < 2; ++row)
            for (int column = -2; column < 2; ++column) {
                if (row == 0 && column == 0) continue; // a large hole
                std::vector<Vec3> points;
                const auto square = [&](int first, int s) {
                    const double a = first * size, b = a + size;
                    return s == 0 ? a * a : s == 1 ? a * b : b * b;
                };
                for (int u = 0; u < 3; ++u)
                    for (int v = 0; v < 3; ++v)
                        points.emplace_back((column + u / 2.0) * size, (row + v / 2.0) * size,
                                            (square(column, u) + square(row, v)) / (2 * radius));
                builder.patch(2, 2, points);
            }
        expect_nothing(builder.build(), std::to_string(size) + " mm");
    }
}

} // namespace
} // namespace keiko
