#include "keiko/visibility/query/occluders.h"

#include "tests/support/round_scenes.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

using namespace keiko;
using namespace keiko::test;

namespace {

/// A square of places below all bodies and above them a region that is the box of a slanted
/// segment.
struct Question {
    std::vector<Vec3> places, region;

    explicit Question(Random& random) {
        const Vec3 corner(uniform(random, -40, 130), uniform(random, -40, 130),
                          uniform(random, -60, -31));
        const double turn = uniform(random, 0, std::numbers::pi), size = uniform(random, 1, 15);
        const Vec3 u = Vec3(std::cos(turn), std::sin(turn), 0) * size, v(-u.y, u.x, 0);
        places = {corner, corner + u, corner + v, corner + u + v};
        const Vec3 from(uniform(random, -60, 160), uniform(random, -60, 160),
                        uniform(random, 130, 200));
        const Vec3 along(uniform(random, 0, 60), uniform(random, 0, 60), uniform(random, 0, 20));
        for (int i = 0; i < 8; ++i)
            region.push_back(from +
                             Vec3(i & 1 ? along.x : 0, i & 2 ? along.y : 0, i & 4 ? along.z : 0));
    }
};

Vec3 mixture(const std::vector<Vec3>& points, Random& random) {
    Vec3 sum(0);
    double all = 0;
    for (const Vec3& point : points) {
        const double share = pick(random, 2) == 0 ? uniform(random, 0, 1) : 1e-9;
        sum += point * share, all += share;
    }
    return sum / all;
}

/// Number of rays between the two that are stopped.
std::size_t stopped(const Tracer& tracer, const Question& question, std::size_t rays,
                    Random& random) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < rays; ++i) {
        Ray ray;
        ray.origin = mixture(question.places, random);
        ray.direction = mixture(question.region, random) - ray.origin;
        ray.t_max = 1;
        count += tracer.any(ray);
    }
    return count;
}

} // namespace

TEST(BetweenPlaces, NothingThatIsProvedNotToBeThereStopsSomeRays) {
    Random random(21);
    constexpr std::size_t rays = 200;
    int proved = 0, free = 0, hidden = 0;
    for (int scene = 0; scene < 60; ++scene) {
        const SurfaceModel model = round_scene(random);
        const Tracer tracer(model);
        const Occluders occluders(model, tracer);
        for (int i = 0; i < 60; ++i) {
            const Question question(random);
            const std::size_t count = stopped(tracer, question, rays, random);
            free += count == 0;
            if (occluders.may_occlude(question.places, question.region)) continue;
            proved += count == 0;
            hidden += count == rays;
            EXPECT_TRUE(count == 0 || count == rays) << count;
        }
    }
    EXPECT_GT(proved, 0.7 * free) << "proofs that are found";
    EXPECT_GT(hidden, 10) << "behind one face as a whole";
}

// A table top lit from above: neither it nor what stands below it comes between; what stands on it
// does.
TEST(BetweenPlaces, AFlatSurfaceIsLitFromItsSideAlone) {
    const std::array<Vec3, 4> places{Vec3(40, 40, 50), Vec3(60, 40, 50), Vec3(40, 60, 50),
                                     Vec3(60, 60, 50)};
    const std::array<Vec3, 2> region{Vec3(-500, 50, 60), Vec3(500, 50, 60)};
    const auto comes_between = [&](const Vec3& low, const Vec3& size) {
        ModelBuilder builder;
        add_box(builder, {0, 0, 0}, {100, 100, 50});
        add_box(builder, low, size);
        const SurfaceModel model = builder.build();
        const Tracer tracer(model);
        return Occluders(model, tracer).may_occlude(places, region, Vec3(0, 0, 1));
    };
    EXPECT_FALSE(comes_between({120, 40, 0}, {20, 20, 50}));
    EXPECT_FALSE(comes_between({70, 70, 50}, {5, 5, 40}));
    EXPECT_TRUE(comes_between({120, 40, 0}, {20, 20, 60}));
    EXPECT_TRUE(comes_between({61, 45, 50}, {0.01, 10, 0.1}));
}

// However far the light is, as the sun is taken to be.
TEST(BetweenPlaces, WhatHardlyRisesOverAFlatSurfaceComesBetween) {
    const std::array<Vec3, 4> places{Vec3(40, 40, 0), Vec3(60, 40, 0), Vec3(40, 60, 0),
                                     Vec3(60, 60, 0)};
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, 100, 0});
    for (const double height : {1.0, 1e-2, 1e-4, 1e-6}) {
        ModelBuilder with_bar = builder;
        with_bar.plane({50, 45, height}, {0.8, 0, 0}, {0, 10, 0});
        for (const double away : {1e2, 1e4, 1e7}) {
            const std::array<Vec3, 1> light{Vec3(0.1, 0.2, 1) * away};
            const auto comes_between = [&](const SurfaceModel& model) {
                const Tracer tracer(model);
                return Occluders(model, tracer).may_occlude(places, light, Vec3(0, 0, 1));
            };
            EXPECT_TRUE(comes_between(with_bar.build())) << height << ' ' << away;
            EXPECT_FALSE(comes_between(builder.build())) << away;
        }
    }
}
