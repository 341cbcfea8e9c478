#include "keiko/light/spotlight/point_light.h"
#include "keiko/light/spotlight/spotlight.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

using namespace keiko;

TEST(BeamVolume, AgreesWithOracle) {
    const test::OracleTable table("beam_volume");
    test::WorstError worst("s");
    for (const auto& row : table) {
        Spotlight light{.position = row.vector("in.Q") * 1000,
                        .aim = row.vector("in.C") * 1000,
                        .half_angle = row.number("in.gx_deg"),
                        .reference = row.vector("in.R") * 1000 - row.vector("in.Q") * 1000};
        if (row.text("in.gx_deg") != row.text("in.gy_deg"))
            light.half_angle_across = row.number("in.gy_deg");
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
    std::vector<Spotlight> lights;
    for (const double half_angle : {2.0, 40.0, 89.0, 90.0, 130.0, 180.0})
        lights.push_back({.half_angle = half_angle});
    for (const double across : {3.0, 80.0})
        lights.push_back({.half_angle = 50, .half_angle_across = across});
    for (Spotlight& light : lights) {
        light.aim = {0.3, 0.4, -1};
        light.profile = EdgeProfile{BeamEdge::sharp};
        for (int i = 0; i < 500; ++i) {
            const Segment segment{{any(random), any(random), any(random)},
                                  {any(random), any(random), any(random)}};
            const IntervalSet lit = in_beam(light, segment);
            for (double t = 0.005; t < 1; t += 0.03) {
                const bool bright = intensity_towards(light, segment.at(t)) != Rgb();
                // Points within rounding of the rim may fall on either side.
                const bool near_rim = lit.contains(t - 1e-9) != lit.contains(t + 1e-9);
                EXPECT_TRUE(near_rim || lit.contains(t) == bright) << light.half_angle << " " << t;
                ++(bright ? inside : outside);
            }
        }
    }
    EXPECT_GT(inside, 10000);
    EXPECT_GT(outside, 10000);
}

TEST(BeamVolume, ALuminaireLightsNothingBeyondItsLastBrightAngle) {
    const IntensityTable table({0, 30, 60, 90}, {0}, {100, 50, 0, 0}, PlaneSymmetry::axial);
    PhotometricWeb web{.type = PhotometricType::c, .candela = table};
    Luminaire lamp{.web = std::make_shared<PhotometricWeb>(web)};
    const Segment across{{-4000, 0, -1000}, {4000, 0, -1000}};
    const IntervalSet lit = in_beam(lamp, across);
    ASSERT_EQ(lit.size(), 1u);
    EXPECT_NEAR(lit[0].begin, 0.5 - std::sqrt(3.0) / 8, 1e-12);
    EXPECT_NEAR(lit[0].end, 0.5 + std::sqrt(3.0) / 8, 1e-12);
    web.type = PhotometricType::b;
    lamp.web = std::make_shared<PhotometricWeb>(web);
    EXPECT_EQ(in_beam(lamp, across)[0].length(), 1);
}

TEST(BeamVolume, RunsAlongTheAxis) {
    const Spotlight light{.half_angle = 20};
    const IntervalSet lit = in_beam(light, {{0, 0, 1000}, {0, 0, -3000}});
    ASSERT_EQ(lit.size(), 1u);
    EXPECT_NEAR(lit[0].begin, 0.25, 1e-12);
    EXPECT_EQ(lit[0].end, 1);
}
