#include "keiko/light/tubes/tube_penumbra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace keiko;

namespace {

constexpr double pi = std::numbers::pi;
const TubeLamp lamp{{-700, 40, 900}, {650, -20, 950}, 80, Rgb(1)};
const Vec3 normal = Vec3(0.1, -0.2, 1).normalized();

/// Everything on one side of a plane through the point and nearly along the lamp is hidden.
class PastEdge final : public Visibility {
public:
    using Visibility::intervals;
    explicit PastEdge(const Vec3& hidden_side) : side_(hidden_side) {}
    IntervalSet intervals(const Segment& segment) const override {
        ++lines;
        const double a = side_.dot(segment.a), b = side_.dot(segment.b);
        if (a <= 0 && b <= 0) return IntervalSet::whole();
        if (a >= 0 && b >= 0) return {};
        return a < 0 ? IntervalSet::whole(0, a / (a - b)) : IntervalSet::whole(a / (a - b), 1);
    }
    mutable int lines = 0;

private:
    Vec3 side_;
};

TubeView view() {
    return *view_of(lamp, Vec3(0), normal);
}

/// The plane that leaves place x of the width, -1 to 1 sideways, and turns by `slant` radians.
Vec3 hidden_beyond(double x, double slant) {
    const TubeView v = view();
    const double psi = std::asin(v.radius / v.distance * std::sin(pi / 2 * x));
    const Vec3 along = v.along * std::cos(slant) + v.sideways * std::sin(slant);
    const Vec3 way = v.sideways * std::sin(psi) - v.towards * std::cos(psi);
    const Vec3 side = along.cross(way);
    return side.dot(v.sideways) > 0 ? side : -side;
}

/// Brute force: the near side of the tube in narrow strips, each by its middle.
double share_by_strips(const Vec3& hidden_side) {
    constexpr int around = 4000, along = 400;
    const TubeView v = view();
    double all = 0, seen = 0;
    for (int i = 0; i < around; ++i) {
        const double phi = pi * ((i + 0.5) / around - 0.5);
        const Vec3 out = v.towards * std::cos(phi) + v.sideways * std::sin(phi);
        for (int j = 0; j < along; ++j) {
            const Vec3 x = lamp.a + (lamp.b - lamp.a) * ((j + 0.5) / along) + out * v.radius;
            const double light = std::max(0.0, normal.dot(x)) * std::max(0.0, -out.dot(x)) /
                                 (x.length2() * x.length2());
            all += light;
            if (hidden_side.dot(x) <= 0) seen += light;
        }
    }
    return seen / all;
}

double share(const Visibility& visible, double tolerance) {
    return seen_tubes({&lamp, 1}, Vec3(0), normal, visible, {tolerance})[0].share;
}

} // namespace

TEST(TubePenumbra, FindsEdgesAlongALampToTheTolerance) {
    for (int i = 0; i < 40; ++i) {
        const double x = -0.99 + 1.98 * i / 39;
        const Vec3 hidden = hidden_beyond(x, 0);
        const double exact = share(PastEdge(hidden), 1e-9);
        EXPECT_NEAR(exact, share_by_strips(hidden), 5e-4) << x;
        EXPECT_NEAR(share(PastEdge(hidden), 5e-5), exact, 1e-4) << x;
        EXPECT_NEAR(share(PastEdge(hidden), 3e-3), exact, 1e-2) << x;
    }
}

TEST(TubePenumbra, FindsEdgesAslantToTheTolerance) {
    for (const double slant : {0.002, 0.01, 0.05, 0.3})
        for (int i = 0; i < 12; ++i) {
            const double x = -0.95 + 1.9 * i / 11;
            const Vec3 hidden = hidden_beyond(x, slant);
            EXPECT_NEAR(share(PastEdge(hidden), 5e-5), share(PastEdge(hidden), 1e-9), 1e-4)
                << x << ' ' << slant;
        }
}

/// The middle line also gives the visible part of the axis, even where the point is beside the
/// lamp's ends.
TEST(TubePenumbra, TellsWhatIsSeenOfTheAxis) {
    for (const TubeShape shape : {TubeShape::cylinder, TubeShape::rectangle})
        for (const double shift : {-2000.0, -300.0, 0.0, 300.0, 2000.0})
            for (int i = 0; i < 12; ++i) {
                TubeLamp moved = lamp;
                const Vec3 along = (lamp.b - lamp.a).normalized();
                moved.a += along * shift, moved.b += along * shift;
                const Vec3 at = moved.a + (moved.b - moved.a) * ((i - 1.3) / 9.0);
                const PastEdge visible(at.cross(along.cross(Vec3(0.1, 0.2, 1))));
                const auto seen =
                    seen_tubes({&moved, 1}, Vec3(0), normal, visible, {1e-4, shape, true})[0];
                const auto alone =
                    seen_tubes({&moved, 1}, Vec3(0), normal, visible, {1e-4, shape})[0];
                EXPECT_NEAR(seen.share, alone.share, 1e-12);
                const IntervalSet axis = visible.intervals(Segment{moved.a, moved.b});
                ASSERT_EQ(seen.axis.size(), axis.size()) << shift << ' ' << i;
                for (std::size_t k = 0; k < axis.size(); ++k) {
                    EXPECT_NEAR(seen.axis[k].begin, axis[k].begin, 1e-12);
                    EXPECT_NEAR(seen.axis[k].end, axis[k].end, 1e-12);
                }
            }
}

/// However often the width is halved.
TEST(TubePenumbra, AsksNoLineTwice) {
    struct Recorder final : Visibility {
        explicit Recorder(const Vec3& hidden_side) : edge(hidden_side) {}
        using Visibility::intervals;
        IntervalSet intervals(const Segment& segment) const override {
            for (const Segment& other : asked)
                twice += (other.a - segment.a).length() + (other.b - segment.b).length() < 1e-9;
            asked.push_back(segment);
            return edge.intervals(segment);
        }
        PastEdge edge;
        mutable std::vector<Segment> asked;
        mutable int twice = 0;
    };
    for (const double slant : {0.0, 0.002}) {
        const Recorder visible(hidden_beyond(0.3, slant));
        share(visible, 1e-4);
        EXPECT_GT(visible.asked.size(), 20u);
        EXPECT_EQ(visible.twice, 0);
    }
}

TEST(TubePenumbra, AsksFewLinesWhereAnEdgeCrossesTheLamp) {
    const PastEdge visible(hidden_beyond(0.1, pi / 2));
    share(visible, 3e-3);
    EXPECT_LE(visible.lines, 5);
}
