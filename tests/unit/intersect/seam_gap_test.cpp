#include "keiko/geometry/seam/seam_gap.h"

#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/random_patches.h"
#include "tests/support/squares.h"
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace keiko {
namespace {

using namespace test;

/// Gaps of the squares' edge, by side.
std::vector<SeamGap> gaps_of(const SurfaceModel& model, double join = 0.5) {
    std::vector<SeamGap> result;
    const std::vector<SeamGap> all = seam_gaps(model, join, {});
    for (std::size_t c = 0; c < all.size(); ++c)
        if (model.trim_curves[c].edge == squares_edge) result.push_back(all[c]);
    return result;
}

TEST(SeamGap, IsMeasuredWhateverTheFileClaims) {
    for (const double claimed : {1e-7, 2e-3, 0.1}) {
        const std::vector<SeamGap> gaps = gaps_of(squares(1e-4, claimed, 0.3));
        ASSERT_EQ(gaps.size(), 2u);
        for (std::size_t side = 0; side < 2; ++side) {
            EXPECT_GT(gaps[side].width, 1e-4);
            EXPECT_LT(gaps[side].width, 2e-4);
            // From the left square to the right one, which is folded up, and back.
            ASSERT_FALSE(gaps[side].samples.empty());
            const Vec3 across = Vec3(5e-5 * (1 + std::cos(0.3)), 0, 5e-5 * std::sin(0.3));
            for (const SeamGap::Sample& s : gaps[side].samples)
                EXPECT_LT((s.across - across * (side == 0 ? 1 : -1)).length(), 1e-12);
        }
    }
}

TEST(SeamGap, WiderThanTheFileAndReasonSayIsSealedAsFarAsTheFileSays) {
    const std::vector<SeamGap> gaps = gaps_of(squares(0.1, 1e-3, 0));
    ASSERT_EQ(gaps.size(), 2u);
    for (const SeamGap& gap : gaps) {
        EXPECT_EQ(gap.width, 1e-3);
        ASSERT_FALSE(gap.samples.empty());
        const Vec3 across = gap.samples.front().across.normalized();
        EXPECT_TRUE(gap.holds(0.5, across * 0.9e-3, {0, 0, 1}));
        EXPECT_FALSE(gap.holds(0.5, across * 1.1e-3, {0, 0, 1}));
    }
    for (const SeamGap& gap : gaps_of(squares(0.1, 0.2, 0), 0.05)) EXPECT_LE(gap.width, 0.05);
}

TEST(SeamGap, OfBordersThatMeetIsOnlyRounding) {
    for (const SeamGap& gap : gaps_of(squares(0, 0.1, 0.3))) {
        EXPECT_LT(gap.width, 1e-6);
        EXPECT_TRUE(gap.samples.empty());
    }
}

/// The right face's border is x(t) = 0.0282 t (t - 1/4) (t - 1/2) (t - 3/4) (t - 1) mm, as
/// interpolation at equal steps leaves it. It meets the left face's straight one at t = 0, 1/4,
/// 1/2, 3/4, 1.
SurfaceModel squares_that_meet_at_five_places() {
    ShapeBuilder builder;
    const std::uint32_t edge = builder.edge(2e-3), rim = builder.edge(0);
    builder.face({rectangle(-10, 0, -10, 10, 0)},
                 {{line({-10, -10}, {0, -10}, rim), line({0, -10}, {0, 10}, edge),
                   line({0, 10}, {-10, 10}, rim), line({-10, 10}, {-10, -10}, rim)}});
    CurveData wave{{}, edge};
    const std::array<double, 6> x{0, 0.01875, -0.040625, 0.040625, -0.01875, 0};
    for (std::size_t i = 0; i < x.size(); ++i)
        wave.points.emplace_back(0.0282 * x[i], -10 + 4.0 * double(i), 1);
    builder.face({rectangle(-1, 10, -10, 10, 0)},
                 {{wave, line({0, 10}, {10, 10}, rim), line({10, 10}, {10, -10}, rim),
                   line({10, -10}, {0, -10}, rim)}});
    return builder.model();
}

TEST(SeamGap, IsSeenBetweenThePlacesWhereTheBordersMeet) {
    const SurfaceModel model = squares_that_meet_at_five_places();
    for (const SeamGap& gap : gaps_of(model)) EXPECT_GT(gap.width, 9e-5);
    // At t = 0.1 the borders are 9.9e-5 mm apart.
    EXPECT_TRUE(Tracer(model).any(ray_through(Vec3(5e-5, -8, 5), Vec3(0, 0, -1))));
}

/// A disc within a plate, both bounded by one edge of two half circles.
TEST(SeamGap, OfAnEdgeThatClosesOnItselfIsMeasured) {
    ShapeBuilder builder;
    const std::uint32_t edge = builder.edge(0.1);
    const auto halves = [&](double radius) {
        const auto half = [&](double side) {
            return CurveData{
                {Vec3(side * radius, 0, 1), Vec3(0, side * radius, 0), Vec3(-side * radius, 0, 1)},
                edge};
        };
        return LoopData{half(1), half(-1)};
    };
    builder.face({rectangle(-10, 10, -10, 10, 0)}, {halves(5)});
    builder.face({rectangle(-10, 10, -10, 10, 0)},
                 {polygon({{-10, -10}, {10, -10}, {10, 10}, {-10, 10}}), halves(5.001)});
    const SurfaceModel model = builder.model();
    const std::vector<SeamGap> all = seam_gaps(model, 0.5, {});
    for (std::size_t c = 0; c < all.size(); ++c) {
        if (model.trim_curves[c].edge != edge) continue;
        EXPECT_NEAR(all[c].width, 1.5e-3, 1e-5);
        EXPECT_FALSE(all[c].samples.empty());
    }
}

/// The file claims 1e-7 mm of a gap of 1e-4.
TEST(Gaps, ThatTheFileUnderstatesAreTight) {
    const SurfaceModel model = squares(1e-4, 1e-7, 0.1);
    const Tracer tracer(model), clipping(model, {.clipping_only = true});
    for (int i = 0; i <= 100; ++i) {
        const Vec3 target((i - 50) * 1e-6, 0.17 * (i - 50), 0);
        const Ray ray = ray_through(target + Vec3(1, 2, 5), Vec3(-1, -2, -5));
        for (const Tracer* each : {&tracer, &clipping}) EXPECT_EQ(each->all(ray).size(), 1u) << i;
    }
}

/// A ray through the gap meets the squares' planes the farther off the lower it comes.
TEST(Gaps, AreTightForLowRays) {
    const SurfaceModel model = squares(1e-3, 2e-3, 0);
    const Tracer tracer(model), clipping(model, {.clipping_only = true});
    for (const double slope : {1.0, 0.3, 0.12})
        for (int i = 1; i < 20; ++i) {
            const Vec3 target((i - 10) * 5e-5, 0.3 * i, 0);
            const Ray ray = ray_through(target + Vec3(0.3, 1, slope) * 5, Vec3(-0.3, -1, -slope));
            for (const Tracer* each : {&tracer, &clipping})
                EXPECT_EQ(each->all(ray).size(), 1u) << slope << ' ' << i;
        }
}

/// Widths are of the part; placed a thousand times as large or small it is crossed alike.
TEST(Gaps, AreTightAndCountedOnceAtAnyScale) {
    for (const double gap : {1e-3, -1e-3})
        for (const double scale : {1e-3, 1.0, 1e3}) {
            SurfaceModel model = squares(gap, 2e-3, 0.2);
            for (Vec3& row : model.instances[0].transform.rows) row *= scale;
            const Tracer tracer(model);
            for (int i = 0; i <= 40; ++i) {
                const Vec3 target((i - 20) * 4e-5, 0.3 * (i - 20), 0);
                const Ray ray = ray_through((target + Vec3(1, 2, 5)) * scale, Vec3(-1, -2, -5));
                EXPECT_EQ(tracer.all(ray).size(), 1u) << gap << ' ' << scale << ' ' << i;
            }
        }
}

/// A roof with a closed ridge, for which the file claims 0.1 mm: what passes above passes.
TEST(Folds, ThatAreClosedStopNothingBeyondThem) {
    const SurfaceModel model = squares(0, 0.1, -1);
    const Tracer tracer(model), clipping(model, {.clipping_only = true});
    for (const double above : {1e-6, 1e-3, 0.05}) {
        const double ridge = above;
        const Ray ray = ray_through(Vec3(-5, 1, ridge + 5 * 0.2), Vec3(1, 0, -0.2));
        for (const Tracer* each : {&tracer, &clipping}) EXPECT_EQ(each->all(ray).size(), 0u);
    }
}

/// A roof whose right side ends a little short of the ridge: a ray under the left side's border
/// and over the right side's enters and leaves; one over both passes.
TEST(Folds, ThatAreOpenAreCrossedAnEvenNumberOfTimes) {
    constexpr double gap = 1e-2;
    const SurfaceModel model = squares(gap, 2e-2, -1.2);
    const Tracer tracer(model), clipping(model, {.clipping_only = true});
    Random random(5);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 target(uniform(random, -0.02, 0.02), uniform(random, -5, 5),
                          uniform(random, -0.02, 0.02));
        const double slope = -std::tan(0.6) + uniform(random, -0.3, 0.3);
        const Ray ray = ray_through(target - Vec3(5, 0, 5 * slope), Vec3(1, 0.1, slope));
        for (const Tracer* each : {&tracer, &clipping})
            EXPECT_EQ(each->all(ray).size() % 2, 0u) << i << ' ' << target << ' ' << slope;
    }
}

} // namespace
} // namespace keiko
