#include "keiko/light/lines/line_light.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

const LineLight line{{-400, 300, 900}, {700, -100, 1500}, Rgb(1)};

TEST(LineLight, IlluminanceAgreesWithTheOracle) {
    test::WorstError worst("E_cos");
    for (const auto& row : test::OracleTable("line_irradiance")) {
        const LineLight light{row.vector("in.A") * 1000, row.vector("in.B") * 1000, Rgb(1)};
        const auto view = view_of(light, row.vector("in.P") * 1000);
        ASSERT_TRUE(view);
        const double lx = row.number("in.Iq") * unit_illuminance(*view, row.unit("in.N"));
        worst.compare(row, lx, row.number("out.E_cos"), 1e-11);
    }
}

TEST(LineLight, VisiblePartsAddUp) {
    const Vec3 normal = Vec3(0.3, -0.2, 0.4).normalized();
    const auto view = view_of(line, Vec3(0));
    ASSERT_TRUE(view);
    const double all = unit_illuminance(*view, normal);
    const double part = unit_illuminance(*view, normal, IntervalSet::whole(0.2, 0.7));
    const IntervalSet rest({{0, 0.2}, {0.7, 1}});
    EXPECT_NEAR(part + unit_illuminance(*view, normal, rest), all, 1e-13 * all);
    EXPECT_GT(part, 0.3 * all);
}

/// The plane of the surface cuts the line: what is below it does not count.
TEST(LineLight, HorizonCutsTheLine) {
    const LineLight upright{{1000, 0, -500}, {1000, 0, 1500}, Rgb(1)};
    const LineLight above{{1000, 0, 0}, {1000, 0, 1500}, Rgb(1)};
    const Vec3 up(0, 0, 1);
    EXPECT_NEAR(unit_illuminance(*view_of(upright, Vec3(0)), up),
                unit_illuminance(*view_of(above, Vec3(0)), up), 1e-15);
    EXPECT_EQ(unit_illuminance(*view_of(above, Vec3(0)), -up), 0);
}

TEST(LineLight, SendsNothingAlongItself) {
    EXPECT_FALSE(view_of(line, line.a + (line.b - line.a) * -0.5));
    EXPECT_TRUE(holds(line, line.a + (line.b - line.a) * 0.25));
    EXPECT_FALSE(holds(line, line.a + (line.b - line.a) * 1.25));
    EXPECT_FALSE(holds(line, line.a + Vec3(0, 0, 1)));
}

TEST(LineLight, PlacesLieUnderTheirElevations) {
    const auto view = view_of(line, Vec3(20, -30, 40));
    ASSERT_TRUE(view);
    const auto [low, high] = view->elevations({0, 1});
    EXPECT_LT((view->place(low) - line.a).length(), 1e-9);
    EXPECT_LT((view->place(high) - line.b).length(), 1e-9);
    const Vec3 way = (view->place(0.1) - view->point).normalized();
    EXPECT_LT((way - view->direction(0.1)).length(), 1e-14);
}

} // namespace
} // namespace keiko
