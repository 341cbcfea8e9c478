#include "keiko/spotlight/beam_volume.h"

#include "keiko/spotlight/beam_intensity.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <random>

using namespace keiko;

TEST(BeamVolume, AgreesWithOracle) {
    const test::OracleTable table("beam_volume");
    test::WorstError worst("s");
    for (const auto& row : table) {
        if (row.text("in.gx_deg") != row.text("in.gy_deg")) continue;
        const Spotlight light{.position = row.vector("in.Q") * 1000,
                              .aim = row.vector("in.C") * 1000,
                              .half_angle = row.number("in.gx_deg")};
        const double length = row.number("in.l") * 1000;
        const Vec3 eye = row.vector("in.O") * 1000;
        const IntervalSet lit = in_beam(light, {eye, eye + row.unit("in.w") * length});
        const std::vector<double> ends = row.list("out.s");
        ASSERT_EQ(lit.size(), row.number("out.n")) << row.id();
        for (std::size_t i = 0; i < lit.size(); ++i) {
            worst.compare(row, lit[i].begin * length / 1000, ends[2 * i], 1e-11);
            worst.compare(row, lit[i].end * length / 1000, ends[2 * i + 1], 1e-11);
        }
    }
}

TEST(BeamVolume, IsWhereTheIntensityIsNotZero) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> any(-1, 1);
    int inside = 0, outside = 0;
    for (const double half_angle : {2.0, 40.0, 89.0, 90.0, 130.0, 180.0}) {
        const Spotlight light{
            .aim = {0.3, 0.4, -1}, .half_angle = half_angle, .edge = BeamEdge::sharp};
        for (int i = 0; i < 500; ++i) {
            const Segment segment{{any(random), any(random), any(random)},
                                  {any(random), any(random), any(random)}};
            const IntervalSet lit = in_beam(light, segment);
            for (double t = 0.005; t < 1; t += 0.03) {
                const bool bright = intensity_towards(light, segment.at(t)) != Rgb();
                // Points within rounding of the rim may fall on either side.
                const bool near_rim = lit.contains(t - 1e-9) != lit.contains(t + 1e-9);
                EXPECT_TRUE(near_rim || lit.contains(t) == bright) << half_angle << " " << t;
                ++(bright ? inside : outside);
            }
        }
    }
    EXPECT_GT(inside, 10000);
    EXPECT_GT(outside, 10000);
}

TEST(BeamVolume, RunsAlongTheAxis) {
    const Spotlight light{.half_angle = 20};
    const IntervalSet lit = in_beam(light, {{0, 0, 1000}, {0, 0, -3000}});
    ASSERT_EQ(lit.size(), 1u);
    EXPECT_NEAR(lit[0].begin, 0.25, 1e-12);
    EXPECT_EQ(lit[0].end, 1);
}
