#include "keiko/geometry/trim/trim_region.h"

#include "keiko/geometry/bernstein/bernstein.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace keiko {
namespace {

using Random = std::mt19937_64;
using Curve = std::vector<Vec3>;
using Loop = std::vector<Curve>;

double uniform(Random& random, double low, double high) {
    return low + (high - low) * std::uniform_real_distribution<double>(0, 1)(random);
}

SurfaceModel face_with(const std::vector<Loop>& loops, std::uint32_t edge = no_index) {
    test::ModelBuilder builder;
    builder.plane(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0));
    for (const Loop& loop : loops) builder.loop(loop, edge);
    return builder.build();
}

TrimRegion region_of(const SurfaceModel& model) {
    return TrimRegion(model, model.faces[0]);
}

Loop polygon(const std::vector<Vec2>& corners) {
    Loop loop;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        loop.push_back({Vec3(a.x, a.y, 1), Vec3(b.x, b.y, 1)});
    }
    return loop;
}

/// Four rational quarters, turned by `turn` so that their ends are not the extrema.
Loop circle(const Vec2& center, double radius, double turn) {
    Loop loop;
    const double w = std::sqrt(0.5);
    for (int q = 0; q < 4; ++q) {
        const double a = turn + q * 1.5707963267948966, b = turn + (q + 1) * 1.5707963267948966;
        const Vec2 from(std::cos(a), std::sin(a)), to(std::cos(b), std::sin(b));
        const Vec2 p = center + from * radius, m = center + (from + to) * radius;
        const Vec2 r = center + to * radius;
        loop.push_back({Vec3(p.x, p.y, 1), Vec3(m.x, m.y, 1) * w, Vec3(r.x, r.y, 1)});
    }
    return loop;
}

/// A wild closed chain of cubics, rational or not, that crosses itself.
Loop tangle(Random& random, int count, bool rational) {
    std::vector<Vec2> knots;
    for (int i = 0; i < count; ++i)
        knots.emplace_back(uniform(random, 0, 1), uniform(random, 0, 1));
    Loop loop;
    for (int i = 0; i < count; ++i) {
        const Vec2 ends[] = {knots[static_cast<std::size_t>(i)],
                             knots[static_cast<std::size_t>((i + 1) % count)]};
        Curve curve{Vec3(ends[0].x, ends[0].y, 1)};
        for (int k = 0; k < 2; ++k) {
            const double w = rational ? std::exp(uniform(random, -2, 2)) : 1;
            curve.emplace_back(uniform(random, 0, 1) * w, uniform(random, 0, 1) * w, w);
        }
        curve.emplace_back(ends[1].x, ends[1].y, 1);
        loop.push_back(curve);
    }
    return loop;
}

/// Polyline of a model's loops, `per_curve` chords a curve, with each chord's largest length.
struct Outline {
    std::vector<std::pair<Vec2, Vec2>> chords;

    Outline(const SurfaceModel& model, int per_curve) {
        for (std::uint32_t c = 0; c < model.trim_curves.size(); ++c) {
            const auto at = [&](int i) {
                return evaluate(model.trim_curve(c), static_cast<double>(i) / per_curve, 0)[0];
            };
            for (int i = 0; i < per_curve; ++i) chords.emplace_back(at(i), at(i + 1));
        }
    }
    bool odd(const Vec2& p) const {
        bool inside = false;
        for (const auto& [a, b] : chords)
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
                inside = !inside;
        return inside;
    }
    double distance(const Vec2& p) const {
        double least = 1e300;
        for (const auto& [a, b] : chords) {
            const Vec2 d = b - a;
            const double t = std::clamp((p - a).dot(d) / std::max(d.length2(), 1e-300), 0.0, 1.0);
            least = std::min(least, (a + d * t - p).length());
        }
        return least;
    }
};

TEST(BernsteinRoots, FindsSimpleAndDoubleRootsInside) {
    // (t - 0.25)(t - 0.75), and (t - 0.5)^2 t
    const double simple[] = {0.1875, -0.3125, 0.1875};
    const std::vector<double> two = bernstein_roots(simple, 0);
    ASSERT_EQ(two.size(), 2u);
    EXPECT_NEAR(two[0], 0.25, 1e-14);
    EXPECT_NEAR(two[1], 0.75, 1e-14);
    const double away[] = {1, 2, 0.5, 3};
    EXPECT_TRUE(bernstein_roots(away, 0).empty());
    const double zero[] = {1e-20, -1e-20, 1e-20};
    EXPECT_TRUE(bernstein_roots(zero, 1e-15).empty());
}

TEST(TrimRegion, WithoutLoopsIsEverywhere) {
    const TrimRegion region = region_of(face_with({}));
    EXPECT_TRUE(region.untrimmed());
    EXPECT_TRUE(region.contains(Vec2(17, -3)));
    EXPECT_EQ(region.classify({Vec2(0), Vec2(1)}), TrimSide::inside);
    EXPECT_FALSE(region.nearest_curve(Vec2(0.5), ParameterMetric(Vec2(1)), 10));
}

TEST(TrimRegion, KnowsTheInsideOfARingToTheLastDigits) {
    for (const double turn : {0.0, 0.3, 1.0}) {
        const TrimRegion region =
            region_of(face_with({circle(Vec2(3, 4), 2, turn), circle(Vec2(3, 4), 1, -turn)}));
        Random random(5);
        for (int i = 0; i < 20000; ++i) {
            const double angle = uniform(random, 0, 7), side = i % 2 == 0 ? 1 : -1;
            const double off = std::pow(10, -uniform(random, 0.5, 13));
            const Vec2 direction(std::cos(angle), std::sin(angle));
            EXPECT_EQ(region.contains(Vec2(3, 4) + direction * (2 + side * off)), side < 0) << off;
            EXPECT_EQ(region.contains(Vec2(3, 4) + direction * (1 + side * off)), side > 0) << off;
        }
    }
}

TEST(TrimRegion, KnowsWhereLinesCrossItsCurves) {
    const TrimRegion disk = region_of(face_with({circle(Vec2(3, 4), 2, 0.3)}));
    for (const unsigned axis : {0U, 1U}) {
        const double middle = axis == 0 ? 3 : 4, other = axis == 0 ? 4 : 3;
        for (const double off : {-1.9, -0.4, 0.0, 1.2}) {
            const auto found = disk.crossings(axis, middle + off);
            ASSERT_EQ(found.size(), 2u);
            const double half = std::sqrt(4 - off * off);
            EXPECT_NEAR(found[0], other - half, 1e-13);
            EXPECT_NEAR(found[1], other + half, 1e-13);
        }
        EXPECT_TRUE(disk.crossings(axis, middle + 2.1).empty());
    }
}

TEST(TrimRegion, HoldsAtTheHeightsOfCornersAndExtrema) {
    // A star whose corners share heights with each other; v is taken exactly there.
    const TrimRegion star = region_of(
        face_with({polygon({{0, 0}, {2, 1}, {4, 0}, {3, 2}, {4, 4}, {2, 3}, {0, 4}, {1, 2}})}));
    for (const double v : {0.0, 1.0, 2.0, 3.0, 4.0}) {
        EXPECT_FALSE(star.contains(Vec2(-1, v))) << v;
        EXPECT_FALSE(star.contains(Vec2(5, v))) << v;
    }
    EXPECT_TRUE(star.contains(Vec2(2, 2)));
    EXPECT_TRUE(star.contains(Vec2(1.5, 1)));
    EXPECT_FALSE(star.contains(Vec2(0.4, 2)));
    const TrimRegion disk = region_of(face_with({circle(Vec2(0), 1, 0)}));
    for (const double v : {1.0, -1.0}) {
        EXPECT_FALSE(disk.contains(Vec2(-3, v)));
        EXPECT_FALSE(disk.contains(Vec2(3, v)));
    }
    EXPECT_TRUE(disk.contains(Vec2(0, 0)));
    EXPECT_FALSE(disk.contains(Vec2(-1.5, 0)));
}

class Tangles : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(, Tangles, testing::Values(false, true), [](const auto& kind) {
    return std::string(kind.param ? "Rational" : "Polynomial");
});

TEST_P(Tangles, AgreeWithAFinePolyline) {
    Random random(6);
    for (int shape = 0; shape < 10; ++shape) {
        const SurfaceModel model =
            face_with({tangle(random, 3 + shape, GetParam()), tangle(random, 2, GetParam())});
        const TrimRegion region = region_of(model);
        const Outline outline(model, 400);
        int inside = 0, asked = 0;
        for (int i = 0; i < 400; ++i) {
            const Vec2 p(uniform(random, -0.1, 1.1), uniform(random, -0.1, 1.1));
            if (outline.distance(p) < 1e-3) continue;
            ++asked;
            inside += outline.odd(p);
            EXPECT_EQ(region.contains(p), outline.odd(p)) << shape << ": " << p.x << ' ' << p.y;
        }
        EXPECT_GT(inside, 10);
        EXPECT_GT(asked - inside, 10);
    }
}

TEST_P(Tangles, AreClassifiedSafelyAndSharply) {
    Random random(7);
    const SurfaceModel model = face_with({tangle(random, 5, GetParam())});
    const TrimRegion region = region_of(model);
    const Outline outline(model, 2000);
    int mixed = 0, decided = 0;
    for (int i = 0; i < 2000; ++i) {
        const double size = std::pow(10, -uniform(random, 0.5, 3));
        const Vec2 corner(uniform(random, -0.1, 1.1), uniform(random, -0.1, 1.1));
        const Box2 box{corner, corner + Vec2(size, size * uniform(random, 0.2, 1))};
        bool touched = false;
        for (const auto& [a, b] : outline.chords)
            touched = touched || box.contains(a) || box.contains(b);
        const TrimSide side = region.classify(box);
        if (touched) {
            EXPECT_EQ(side, TrimSide::mixed);
        }
        if (side == TrimSide::mixed) {
            ++mixed;
            EXPECT_LT(outline.distance(box.center()), box.size() * 0.5 + 1e-3);
            continue;
        }
        ++decided;
        for (int k = 0; k < 5; ++k) {
            const Vec2 p =
                box.lower + box.extent() * Vec2(uniform(random, 0, 1), uniform(random, 0, 1));
            EXPECT_EQ(region.contains(p), side == TrimSide::inside);
        }
    }
    EXPECT_GT(mixed, 100);
    EXPECT_GT(decided, 100);
}

/// Far from 0 places are rounded.
Curve moved(Curve curve, double by, double weight) {
    for (Vec3& p : curve) p = Vec3(p.x + by * p.z, p.y - by * p.z, p.z) * weight;
    return curve;
}

/// Strips along chords leave out many boxes that lie within those of pieces, and none that a piece
/// touches.
TEST_P(Tangles, MayTouchTheBoxesThatTheyTouch) {
    for (const Vec2& frame : {Vec2(0, 1), Vec2(1e6, 1e3), Vec2(-1e9, 1e-3), Vec2(0, 1e-60)}) {
        Random random(9);
        int touched = 0, left_out = 0;
        for (const Curve& curve : tangle(random, 20, GetParam()))
            for (const MonotonePiece& piece : monotone_pieces({moved(curve, frame.x, frame.y)}, 0))
                for (int i = 0; i < 200; ++i) {
                    const Vec2 share(uniform(random, 0, 1), uniform(random, 0, 1));
                    const Vec2 middle = i % 2 ? piece.box().lower + piece.box().extent() * share
                                              : piece.point(share.x);
                    const Vec2 half(std::pow(10, -uniform(random, 1, 16)));
                    const Box2 box{middle - half, middle + half};
                    const bool touches = piece.touches(box);
                    touched += touches, left_out += !piece.may_touch(box);
                    ASSERT_TRUE(piece.may_touch(box) || !touches) << i << " at " << frame;
                }
        EXPECT_GT(touched, 3000) << frame;
        EXPECT_GT(left_out, 1000) << frame;
    }
}

TEST_P(Tangles, BoundTheirBend) {
    Random random(12);
    double closest = 0;
    for (const Curve& curve : tangle(random, 20, GetParam()))
        for (const MonotonePiece& piece : monotone_pieces({curve}, 0))
            for (int i = 0; i < 200; ++i) {
                const double a = uniform(random, 0, 1), b = uniform(random, 0, 1);
                const Vec2 sag = piece.point((a + b) / 2) - (piece.point(a) + piece.point(b)) / 2;
                const Vec2 most = piece.bend() * ((b - a) * (b - a) / 8);
                ASSERT_LE(std::abs(sag.x), most.x + 1e-15);
                ASSERT_LE(std::abs(sag.y), most.y + 1e-15);
                closest = std::max({closest, sag.x / most.x, sag.y / most.y});
            }
    EXPECT_GT(closest, 0.2);
    EXPECT_LE(closest, 1);
}

TEST_P(Tangles, KnowTheirNearestPoint) {
    Random random(8);
    const SurfaceModel model = face_with({tangle(random, 4, GetParam())});
    const TrimRegion region = region_of(model);
    const Outline outline(model, 5000);
    for (int i = 0; i < 200; ++i) {
        const Vec2 p(uniform(random, 0, 1), uniform(random, 0, 1));
        const double expected = outline.distance(p);
        const auto near = region.nearest_curve(p, ParameterMetric(Vec2(10)), 20);
        ASSERT_TRUE(near);
        EXPECT_NEAR(near->distance, 10 * expected, 1e-2 * expected + 1e-5);
        const Vec2 foot = evaluate(model.trim_curve(near->curve), near->t, 0)[0];
        EXPECT_NEAR((foot - p).length() * 10, near->distance, 1e-9);
        EXPECT_FALSE(region.nearest_curve(p, ParameterMetric(Vec2(10)), 9 * expected));
    }
}

// At a pole du is 0, and a whole border is equally near: the search once visited all of it.
TEST(TrimRegion, NearestCurveEndsWhereTheScaleIsZero) {
    const SurfaceModel model = face_with({circle(Vec2(0), 1, 0.3)});
    const TrimRegion region = region_of(model);
    for (const Vec2& scale : {Vec2(0, 1), Vec2(1, 0), Vec2(0, 0)}) {
        const auto near = region.nearest_curve(Vec2(0, 0.5), ParameterMetric(scale), 1);
        ASSERT_TRUE(near);
        EXPECT_LE(near->distance, 1e-6);
    }
}

TEST(TrimRegion, ClosesTinyGapsBetweenCurves) {
    Random random(9);
    Loop loop = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    for (Curve& curve : loop)
        for (Vec3& p : curve)
            p += Vec3(uniform(random, -1e-7, 1e-7), uniform(random, -1e-7, 1e-7), 0);
    const TrimRegion region = region_of(face_with({loop}));
    for (int i = 0; i < 20000; ++i) {
        // Heights within the gaps, where a chain with holes would leak.
        const double v = (i % 2 == 0 ? 0 : 1) + uniform(random, -2e-7, 2e-7);
        EXPECT_FALSE(region.contains(Vec2(-0.5, v)));
        EXPECT_FALSE(region.contains(Vec2(1.5, v)));
    }
    EXPECT_TRUE(region.contains(Vec2(0.5, 0.5)));
}

TEST(TrimRegion, TakesTouchingLoopsAndCusps) {
    // Two disks that touch in (0, 0), and a cubic loop with a cusp there.
    const TrimRegion disks =
        region_of(face_with({circle(Vec2(-1, 0), 1, 0.2), circle(Vec2(1, 0), 1, 0.7)}));
    EXPECT_TRUE(disks.contains(Vec2(-0.01, 0)));
    EXPECT_TRUE(disks.contains(Vec2(0.01, 0)));
    EXPECT_FALSE(disks.contains(Vec2(0, 0.01)));
    EXPECT_FALSE(disks.contains(Vec2(0, -0.01)));
    const TrimRegion cusp = region_of(
        face_with({{{Vec3(-1, 1, 1), Vec3(1, -1.0 / 3, 1), Vec3(-1, -1.0 / 3, 1), Vec3(1, 1, 1)},
                    {Vec3(1, 1, 1), Vec3(-1, 1, 1)}}}));
    EXPECT_TRUE(cusp.contains(Vec2(0, 0.5)));
    EXPECT_TRUE(cusp.contains(Vec2(0, 1e-3)));
    EXPECT_FALSE(cusp.contains(Vec2(0, -1e-3)));
    EXPECT_FALSE(cusp.contains(Vec2(0.5, 0.1)));
}

TEST(TrimRegion, HoldsForManyLoops) {
    std::vector<Loop> loops{polygon({{0, 0}, {100, 0}, {100, 100}, {0, 100}})};
    for (int i = 0; i < 30; ++i)
        for (int k = 0; k < 30; ++k)
            loops.push_back(circle(Vec2(3 * i + 5, 3 * k + 5), 1, 0.1 * i));
    const TrimRegion region = region_of(face_with(loops));
    Random random(10);
    for (int i = 0; i < 20000; ++i) {
        const Vec2 p(uniform(random, -5, 105), uniform(random, -5, 105));
        bool expected = std::min(p.x, p.y) > 0 && std::max(p.x, p.y) < 100;
        const auto center = [](double x) {
            return 3 * std::clamp(std::round((x - 5) / 3), 0.0, 29.0) + 5;
        };
        if ((p - Vec2(center(p.x), center(p.y))).length() < 1) expected = false;
        EXPECT_EQ(region.contains(p), expected);
    }
}

TEST(TrimRegion, SaysNoToNan) {
    const TrimRegion disk = region_of(face_with({circle(Vec2(0), 1, 0)}));
    const double nan = std::nan("");
    EXPECT_FALSE(disk.contains(Vec2(nan, 0)));
    EXPECT_FALSE(disk.contains(Vec2(0, nan)));
}

} // namespace
} // namespace keiko
