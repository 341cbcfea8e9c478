#include "keiko/placement/plane_frame.h"

#include <gtest/gtest.h>

#include <numbers>

namespace keiko {
namespace {

Ray ray_of(const Vec3& origin, const Vec3& direction) {
    Ray ray;
    ray.origin = origin;
    ray.direction = direction;
    return ray;
}

const PlaneFrame ceiling{{100, 200, 3000}, {1, 0, 0}, {0, 1, 0}};

TEST(PlaneFrame, MeetsRaysFromBothSides) {
    const PlaneHit up = meet(ceiling, ray_of({0, 0, 0}, {0, 3, 4})).value();
    EXPECT_NEAR(up.place.x, -100, 1e-9);
    EXPECT_NEAR(up.place.y, 3000 * 3.0 / 4 - 200, 1e-9);
    EXPECT_NEAR(up.t, 750, 1e-9);
    EXPECT_NEAR(up.cosine, 0.8, 1e-15);
    EXPECT_FALSE(up.gradients);
    EXPECT_TRUE(meet(ceiling, ray_of({0, 0, 4000}, {0, 0, -1})));
    EXPECT_FALSE(meet(ceiling, ray_of({0, 0, 0}, {0, 0, -1})));
    EXPECT_FALSE(meet(ceiling, ray_of({0, 0, 0}, {1, 1, 0})));
}

TEST(PlaneFrame, GradientsAreTheDerivativesOfThePlace) {
    const RayDifferentials d{.origin_dx = {1, 2, 3},
                             .origin_dy = {-1, 0, 2},
                             .direction_dx = {.01, .02, -.03},
                             .direction_dy = {0, -.02, .01}};
    Ray ray = ray_of({10, 20, 30}, {.1, .2, .9});
    ray.differentials = d;
    const PlaneHit::Gradients g = meet(ceiling, ray)->gradients.value();
    constexpr double h = 1e-4;
    const auto moved = [&](double x, double y) {
        return meet(ceiling, ray_of(ray.origin + d.origin_dx * x + d.origin_dy * y,
                                    ray.direction + d.direction_dx * x + d.direction_dy * y))
            ->place;
    };
    const Vec2 dx = (moved(h, 0) - moved(-h, 0)) / (2 * h);
    const Vec2 dy = (moved(0, h) - moved(0, -h)) / (2 * h);
    EXPECT_LT((dx - Vec2(g.u.x, g.v.x)).length(), 1e-5);
    EXPECT_LT((dy - Vec2(g.u.y, g.v.y)).length(), 1e-5);
}

TEST(PlaneFrame, CrossingNeedsEndsOnBothSides) {
    const Vec2 place = crossing(ceiling, {100, 200, 2000}, {300, 200, 4000}).value();
    EXPECT_LT((place - Vec2(100, 0)).length(), 1e-9);
    EXPECT_FALSE(crossing(ceiling, {0, 0, 0}, {0, 0, 2999}));
    EXPECT_FALSE(crossing(ceiling, {0, 0, 3001}, {0, 0, 9999}));
}

TEST(PlaneFrame, TurningKeepsThePlane) {
    const PlaneFrame turned = ceiling.turned(std::numbers::pi / 6);
    EXPECT_LT((turned.normal() - ceiling.normal()).length(), 1e-15);
    EXPECT_NEAR(turned.u.dot(ceiling.v), 0.5, 1e-15); // from u towards v
    EXPECT_LT((turned.at(turned.place({7, 8, 3000})) - Vec3(7, 8, 3000)).length(), 1e-9);
}

} // namespace
} // namespace keiko
