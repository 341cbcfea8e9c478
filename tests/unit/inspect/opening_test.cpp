// Notches, slits and small holes between free edges.
#include "keiko/inspect/openings/opening.h"

#include "keiko/base/units.h"
#include "keiko/inspect/inspection.h"

#include "tests/support/long_run.h"
#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace keiko {
namespace {

constexpr double length = 100, depth = 50; ///< mm of either sheet, along x and y
constexpr double join = 0.5;

/// A sheet below y = 0 whose upper border runs through `border`, from x = length to 0.
void notched_sheet(test::ModelBuilder& builder, const std::vector<Vec2>& border) {
    builder.plane({0, -depth, 0}, {length, 0, 0}, {0, depth + 1, 0});
    std::vector<Vec2> corners{{0, 0}, {1, 0}};
    for (const Vec2& p : border) corners.emplace_back(p.x / length, (p.y + depth) / (depth + 1));
    builder.polygon(corners);
}

void whole_sheet(test::ModelBuilder& builder) {
    builder.plane({0, 0, 0}, {length, 0, 0}, {0, depth, 0});
}

/// Both ends of the seam, and what lies between.
std::vector<Vec2> bordered(const std::vector<Vec2>& between) {
    std::vector<Vec2> border{{length, 0}};
    border.insert(border.end(), between.begin(), between.end());
    border.emplace_back(0, 0);
    return border;
}

SurfaceModel notched_model(const std::vector<Vec2>& between) {
    test::ModelBuilder builder;
    whole_sheet(builder);
    notched_sheet(builder, bordered(between));
    return builder.build();
}

std::vector<Opening> openings_of(const SurfaceModel& model) {
    const auto seams = measure_seams(model, pair_seams(model, join), {}, join);
    return find_openings(model, seams.pieces, {join, 0.1, 0.01});
}

TEST(Openings, AreNoneAlongAClosedSeam) {
    EXPECT_TRUE(openings_of(notched_model({})).empty());
    EXPECT_TRUE(openings_of(notched_model({{70, 0}, {20, 0}})).empty());
}

TEST(Openings, AreNotchesWhateverTheAngleOfTheirFlanks) {
    for (const double flank : {11.0, 30.0, 45.0, 60.0, 80.0})
        for (const double deep : {0.3, 1.0, 5.0, 20.0}) {
            const double half = deep / std::tan(degrees_to_radians(flank));
            if (half > 40) continue;
            const auto found =
                openings_of(notched_model({{50 + half, 0}, {50, -deep}, {50 - half, 0}}));
            ASSERT_GE(found.size(), 1u) << flank << " degrees, " << deep << " mm";
            EXPECT_GT(found.front().width, 0.05);
            EXPECT_NEAR(found.front().place.x, 50, half + 1);
        }
}

TEST(Openings, AreDeepSlitsOfOneFaceThatBeginAtASeam) {
    const auto found = openings_of(notched_model({{50.6, 0}, {50.6, -20}, {49.4, -20}, {49.4, 0}}));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found.front().length, 20, 1.1);
    EXPECT_FALSE(found.front().goes_on);
}

TEST(Openings, AreNotchesAtACrease) {
    for (const Vec3& other : {Vec3(0, 0, 50), Vec3(0, 20, 50), Vec3(0, -20, 50)}) {
        test::ModelBuilder builder;
        builder.plane({0, 0, 0}, {length, 0, 0}, other);
        notched_sheet(builder, bordered({{51, 0}, {50, -1}, {49, 0}}));
        EXPECT_EQ(openings_of(builder.build()).size(), 1u) << other.y;
    }
}

TEST(Openings, AreSlitsFromAFreeEdgeToASeam) {
    // The seam ends at x = 40; beyond it the lower sheet turns away by 30 degrees.
    const double away = 60 * std::tan(degrees_to_radians(30));
    test::ModelBuilder builder;
    whole_sheet(builder);
    notched_sheet(builder, {{length, -away}, {40, 0}, {0, 0}});
    const auto found = openings_of(builder.build());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found.front().goes_on);
    EXPECT_NEAR(found.front().width, 2 * 25 * std::sin(degrees_to_radians(15)), 1);
}

TEST(Openings, AreTriangularHolesAtACornerOfThreeFaces) {
    for (const double c : {0.2, 0.45, 0.8, 5.0, 15.0}) {
        test::ModelBuilder builder;
        builder.plane({0, -depth, 0}, {length, 0, 0}, {0, depth, 0});
        builder.plane({0, 0, 0}, {50, 0, 0}, {0, depth, 0});
        builder.polygon({{0, 0}, {1 - c / 50, 0}, {1, c / 50}, {1, 1}, {0, 1}});
        builder.plane({50, 0, 0}, {50, 0, 0}, {0, depth, 0});
        builder.polygon({{c / 50, 0}, {1, 0}, {1, 1}, {0, 1}, {0, c / 50}});
        const auto found = openings_of(builder.build());
        ASSERT_EQ(found.size(), 1u) << c;
        EXPECT_NEAR(found.front().width, c, 0.5 * c);
    }
}

TEST(Openings, AreTeethAlongTheWholeOfABorder) {
    std::vector<Vec2> teeth;
    for (int i = 1; i < 500; ++i) teeth.emplace_back(length - 0.2 * i, i % 2 ? -0.05 : 0);
    const auto found = openings_of(notched_model(teeth));
    ASSERT_GE(found.size(), 1u);
    EXPECT_GT(found.front().width, 0.03);
}

TEST(Openings, AreNotTheRimsOfTubes) {
    // Two half tubes, 2 mm in radius.
    test::ModelBuilder builder;
    const double w = std::sqrt(0.5);
    for (const double up : {1.0, -1.0}) {
        std::vector<Vec4> points;
        for (const double x : {0.0, 100.0})
            for (const auto& [y, z, weight] :
                 {std::array{2.0, 0.0, 1.0}, std::array{2.0, 2 * up, w},
                  std::array{0.0, 2 * up, 1.0}, std::array{-2.0, 2 * up, w},
                  std::array{-2.0, 0.0, 1.0}})
                points.emplace_back(x * weight, y * weight, z * weight, weight);
        NurbsSurface tube{1, 2, {0, 0, 1, 1}, {0, 0, 0, 1, 1, 2, 2, 2}, points};
        builder.nurbs(tube);
    }
    EXPECT_TRUE(openings_of(builder.build()).empty());
}

TEST(Openings, AreNoCornersOfCutOutsNorOfPanels) {
    // A rectangular cut-out of both sheets, 80 mm by 20 mm.
    test::ModelBuilder builder;
    builder.plane({0, -depth, 0}, {length, 0, 0}, {0, depth, 0});
    builder.polygon({{0, 0}, {1, 0}, {1, 1}, {0.9, 1}, {0.9, 0.4}, {0.1, 0.4}, {0.1, 1}, {0, 1}});
    whole_sheet(builder);
    EXPECT_TRUE(openings_of(builder.build()).empty());
}

/// Borders of the lower sheet with one defect at random.
class Planter {
public:
    explicit Planter(unsigned seed) : random_(seed) {}

    std::vector<Vec2> next() {
        switch (std::uniform_int_distribution<int>(0, 2)(random_)) {
            case 0:
                return notch();
            case 1:
                return teeth();
            default:
                return plateau();
        }
    }

private:
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }

    /// Of 11 to 80 degrees at its tip.
    std::vector<Vec2> notch() {
        const double deep = std::exp(between(std::log(0.3), std::log(20)));
        const double half = deep * std::tan(degrees_to_radians(between(11, 80)) / 2);
        const double x = between(30, 70), lean = between(-0.5, 0.5) * half;
        return {{x + half, 0}, {x + lean, -deep}, {x - half, 0}};
    }

    std::vector<Vec2> teeth() {
        std::vector<Vec2> border;
        const double size = std::exp(between(std::log(0.05), std::log(1)));
        for (double x = between(60, 90); x > 20; x -= size * between(0.3, 1.5))
            border.emplace_back(x, border.size() % 2 ? -size * between(0.3, 1.5) : 0);
        if (border.size() % 2 == 0) border.pop_back();
        return border;
    }

    std::vector<Vec2> plateau() {
        const double deep = std::exp(between(std::log(0.03), std::log(3)));
        const double long_ = std::exp(between(std::log(0.1), std::log(20)));
        const double x = between(30, 60), flank = between(0, 1.5) * deep;
        return {{x + long_ + flank, 0}, {x + long_, -deep}, {x, -deep}, {x - flank, 0}};
    }

    std::mt19937 random_;
};

TEST(Openings, LeaveNoPlantedDefectWithoutAFinding) {
    Planter planter(20261124);
    CriteriaPreset preset;
    const int cases = test::long_run() ? 2000 : 300;
    for (int i = 0; i < cases; ++i) {
        const std::vector<Vec2> defect = planter.next();
        const Inspection found = inspect(notched_model(defect), preset, join);
        EXPECT_FALSE(found.findings.empty() && found.looks.empty())
            << "case " << i << ", " << defect.size() << " corners, the first at " << defect[0].x
            << ", the second at " << defect[1].x << ", " << defect[1].y;
        for (const Check& look : found.looks) EXPECT_NE(look.face, no_index);
    }
    const Inspection clean = inspect(notched_model({}), preset, join);
    EXPECT_EQ(clean.verdict, Verdict::pass);
    EXPECT_TRUE(clean.looks.empty());
}

} // namespace
} // namespace keiko
