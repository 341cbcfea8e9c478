#include "keiko/light/tubes/tube_penumbra.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace keiko;
using namespace keiko::test;

namespace {

/// Hides what lies on one side of a plane through the point.
class HalfHidden final : public Visibility {
public:
    HalfHidden(const Vec3& point, const Vec3& side) : point_(point), side_(side) {}

    bool sees(const Vec3& x) const { return side_.dot(x - point_) > 0; }
    IntervalSet intervals(const Segment& s) const override {
        const double a = side_.dot(s.a - point_), b = side_.dot(s.b - point_);
        if (a > 0 && b > 0) return IntervalSet::whole();
        if (!(a > 0) && !(b > 0)) return {};
        return a > 0 ? IntervalSet::whole(0, a / (a - b)) : IntervalSet::whole(a / (a - b), 1);
    }

private:
    Vec3 point_, side_;
};

struct Case {
    TubeLamp lamp;
    Vec3 point, normal;

    /// Before one end or the other, now and then with the horizon across its disc.
    explicit Case(Random& random) {
        const Vec3 along = random_direction(random);
        lamp = {Vec3(7, -3, 2), Vec3(7, -3, 2) + along * 300, uniform(random, 20, 200), Rgb(1),
                true};
        const bool before = pick(random, 2) == 0;
        const Vec3 out = before ? -along : along, end = before ? lamp.a : lamp.b;
        point = end + out * uniform(random, 30, 400) + random_direction(random) * 20;
        normal = ((end - point).normalized() + random_direction(random) * 1.2).normalized();
    }
    /// Visible share of the cap's light by small squares of the disc.
    double share_by_brute_force(const HalfHidden& visible) const {
        const Vec3 along = (lamp.b - lamp.a).normalized();
        const Vec3 centre = along.dot(point - lamp.a) < 0 ? lamp.a : lamp.b;
        const Vec3 x = along.cross(Vec3(0.3, 0.5, -0.8)).normalized(), y = along.cross(x);
        constexpr int side = 1500;
        double all = 0, seen = 0;
        for (int i = 0; i < side; ++i)
            for (int j = 0; j < side; ++j) {
                const Vec2 at((2 * i + 1.0) / side - 1, (2 * j + 1.0) / side - 1);
                if (at.length2() > 1) continue;
                const Vec3 place = centre + (x * at.x + y * at.y) * (lamp.diameter / 2);
                const Vec3 way = place - point;
                const double light = std::max(normal.dot(way), 0.0) * std::abs(along.dot(way)) /
                                     (way.length2() * way.length2());
                all += light;
                if (visible.sees(place)) seen += light;
            }
        return all > 0 ? seen / all : 0;
    }
};

} // namespace

TEST(CapPenumbra, IsWhatIsSeenOfTheDiscAboveTheHorizon) {
    Random random(17);
    int in_part = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const Case c(random);
        const HalfHidden visible(c.point, random_direction(random));
        const double truth = c.share_by_brute_force(visible);
        const double share = seen_share_of_cap(c.lamp, c.point, c.normal, visible, 1e-5);
        EXPECT_NEAR(share, truth, 1e-3); // the squares at the edges
        in_part += truth > 0.02 && truth < 0.98;
    }
    EXPECT_GT(in_part, 10);
}

TEST(CapPenumbra, TellsEdgesAlongTheHorizonWhereverTheyLie) {
    Random random(18);
    for (int trial = 0; trial < 200; ++trial) {
        const TubeLamp lamp{Vec3(0, 0, 300), Vec3(200, 0, 300), 100, Rgb(1), true};
        const Vec3 point(-uniform(random, 50, 500), 0, 0), normal(0, 0, 1);
        const double height = uniform(random, 252, 348);
        const HalfHidden visible(point, Vec3(-height, 0, -point.x)); // what is higher is seen
        double all = 0, seen = 0;
        constexpr int rows = 20000;
        for (int i = 0; i < rows; ++i) {
            const double z = 250 + 100 * (i + 0.5) / rows,
                         half = std::sqrt(2500 - (z - 300) * (z - 300));
            constexpr int columns = 40;
            for (int k = 0; k < columns; ++k) {
                const Vec3 way(-point.x, half * ((2 * k + 1.0) / columns - 1), z);
                const double light = half * z / (way.length2() * way.length2());
                all += light;
                if (visible.sees(point + way)) seen += light;
            }
        }
        for (const double tolerance : {5e-5, 3e-3})
            EXPECT_NEAR(seen_share_of_cap(lamp, point, normal, visible, tolerance), seen / all,
                        tolerance + 1e-4)
                << height;
    }
}

TEST(CapPenumbra, DoesNotAskForACapThatFacesAway) {
    const TubeLamp lamp{Vec3(0, 0, 0), Vec3(100, 0, 0), 30, Rgb(1), true};
    const HalfHidden nothing(Vec3(50, 0, 80), Vec3(0, 0, 1));
    EXPECT_EQ(seen_share_of_cap(lamp, Vec3(50, 0, 80), Vec3(0, 0, -1), nothing, 1e-5), 1);
}

// A disc that is cut by the horizon right through a point in its plane.
TEST(CapPenumbra, OfADiscSeenEdgeOnIsNotLookedAt) {
    const Vec3 normal(0, 0, 1);
    for (const double off : {0.0, 1e-13, -1e-13, 1e-9}) {
        const TubeLamp lamp{{-4000, -1000 + off, 5000}, {-4000, 6000, 5000}, 250, Rgb(1), true};
        const Vec3 point(1000, -1000, 5000);
        const double share =
            seen_share_of_cap(lamp, point, normal, HalfHidden(point, {0.1, 0.2, 0.3}), 1e-4);
        EXPECT_TRUE(share >= 0 && share <= 1) << off;
    }
}
