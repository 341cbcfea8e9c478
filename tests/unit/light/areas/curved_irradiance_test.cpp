#include "keiko/light/areas/area_coverage.h"
#include "keiko/light/areas/area_gloss.h"
#include "keiko/light/areas/area_irradiance.h"
#include "keiko/light/areas/area_penumbra.h"
#include "keiko/light/areas/ellipse_width.h"
#include "keiko/light/areas/frustum_width.h"
#include "keiko/light/tubes/cylinder_irradiance.h"
#include "keiko/math/axes.h"
#include "keiko/math/bounds.h"

#include "tests/support/curved_row.h"
#include "tests/support/random.h"
#include "tests/support/shows_below.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using std::numbers::pi;

TEST(CurvedIrradiance, BodiesMeetTheOracleWithoutPlates) {
    test::WorstError worst("E_unocc");
    for (const test::OracleRow& row : test::OracleTable("area_curved")) {
        double lx = 0;
        for (const auto& part : test::parts_of(row))
            lx += row.number("in.L") *
                  std::visit(
                      [&](const auto& light) {
                          return projected_solid_angle(light, row.vector("in.P"), row.unit("in.N"));
                      },
                      part);
        worst.compare(row, lx, row.number("out.E_unocc"), 1e-10);
    }
}

/// A cone, truncated or not, some of them wider at the second rim, around 0 or beside it.
FrustumLight random_cone(test::Random& random) {
    FrustumLight light;
    light.from = test::random_direction(random) * test::uniform(random, 300, 3000);
    light.to = light.from + test::random_direction(random) * test::uniform(random, 50, 2500);
    light.radius = test::uniform(random, 10, 600);
    light.to_radius = test::pick(random, 4) == 0 ? 0 : test::uniform(random, 10, 600);
    return light;
}

EllipsoidLight random_ellipsoid(test::Random& random) {
    EllipsoidLight light;
    light.center = test::random_direction(random) * test::uniform(random, 500, 3000);
    light.u = test::random_direction(random) * test::uniform(random, 20, 400);
    light.v = test::random_direction(random) * test::uniform(random, 20, 400);
    light.w = light.u.cross(light.v).normalized() * test::uniform(random, 20, 400);
    return light;
}

DiscLight random_disc(test::Random& random) {
    return {test::random_direction(random) * test::uniform(random, 300, 3000),
            test::random_direction(random), test::uniform(random, 10, 900), Rgb(1)};
}

/// Reflects in proportion to the cosine, as a diffuse surface does.
struct CosineKernel {
    Vec3 normal;

    Rgb operator()(const Vec3& light) const { return Rgb(std::max(normal.dot(light), 0.0)); }
    const Vec3& peak() const { return normal; }
    LobeChart chart() const { return {normal, 1}; }
    double cone(double) const { return pi; }
};

/// The closed form along the contour and the lines are two ways to one projected solid angle.
TEST(CurvedIrradiance, LinesOfAnySourceAddUpToTheClosedForm) {
    test::Random random(28);
    int compared = 0, around = 0;
    const auto compare = [&](const auto& light, const Vec3& normal) {
        if (holds(light, Vec3(0))) return;
        const double closed = projected_solid_angle(light, Vec3(0), normal);
        const auto width = width_of(light, Vec3(0), normal);
        compared += closed > 0.01;
        const double by_lines =
            width ? AreaGloss(*width, CosineKernel{normal}, 1e-9).integral().g : 0;
        EXPECT_NEAR(by_lines, closed, 1e-6) << compared;
    };
    for (int i = 0; i < 300; ++i) {
        const Vec3 normal = test::random_direction(random);
        const FrustumLight cone = random_cone(random);
        const auto view = FrustumView::of(cone, Vec3(0));
        around += view && view->all_around();
        compare(cone, normal);
        compare(random_ellipsoid(random), normal);
        compare(random_disc(random), normal);
    }
    EXPECT_GT(compared, 200);
    EXPECT_GT(around, 3);
}

/// Occluders are collected for a body that holds every line that is queried.
TEST(CurvedIrradiance, BoundsOfEllipsoidsHoldTheirLines) {
    test::Random random(31);
    int lines = 0;
    for (int i = 0; i < 200; ++i) {
        const EllipsoidLight light = random_ellipsoid(random);
        const auto width = width_of(light, Vec3(0), test::random_direction(random));
        if (holds(light, Vec3(0)) || !width) continue;
        Box3 box; // the hull is a cube
        for (const Vec3& corner : bounds_of(light)) box.extend(corner);
        for (double place = -0.95; place < 1; place += 0.1) {
            const Segment line = width->line_of(width->sub_axis(place));
            EXPECT_TRUE(box.padded(1e-9 * box.size()).contains(line.a));
            EXPECT_TRUE(box.padded(1e-9 * box.size()).contains(line.b));
            ++lines;
        }
    }
    EXPECT_GT(lines, 1000);
}

/// Share of a fine grid of Nusselt's disc, whose rays meet any of some lights, times pi.
template <class... Lights>
double by_rays(const Vec3& normal, const Lights&... lights) {
    constexpr int side = 500;
    const Vec3 x = any_perpendicular(normal).normalized(), y = normal.cross(x);
    int met = 0;
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k) {
            const double s = (2 * i + 1.0) / side - 1, t = (2 * k + 1.0) / side - 1;
            const double up = 1 - s * s - t * t;
            if (!(up > 0)) continue;
            const Vec3 way = x * s + y * t + normal * std::sqrt(up);
            met += (area_hit(lights, Vec3(0), way, {}).has_value() || ...);
        }
    return 4.0 * met / (side * side);
}

TEST(CurvedIrradiance, BodiesAreWhatRaysMeet) {
    test::Random random(5);
    for (int i = 0; i < 20; ++i) {
        const Vec3 normal = test::random_direction(random);
        const FrustumLight cone = random_cone(random);
        const DiscLight end{cone.from, -cone.along(), cone.radius, Rgb(1)};
        if (holds(cone, Vec3(0))) continue;
        const double all = projected_solid_angle(cone, Vec3(0), normal) +
                           projected_solid_angle(end, Vec3(0), normal);
        EXPECT_NEAR(all, by_rays(normal, cone, end), 2e-3) << i;
        const EllipsoidLight ball = random_ellipsoid(random);
        EXPECT_NEAR(projected_solid_angle(ball, Vec3(0), normal), by_rays(normal, ball), 2e-3) << i;
    }
}

/// Both parts of a cone that is cut across have the tangents of the whole.
TEST(CurvedIrradiance, PartsOfAConeAddUp) {
    test::Random random(6);
    for (int i = 0; i < 300; ++i) {
        const Vec3 normal = test::random_direction(random);
        const FrustumLight whole = random_cone(random);
        FrustumLight first = whole, second = whole;
        const double cut = test::uniform(random, 0.1, 0.9);
        first.to = second.from = whole.from + (whole.to - whole.from) * cut;
        first.to_radius = second.radius = whole.radius + (whole.to_radius - whole.radius) * cut;
        EXPECT_NEAR(projected_solid_angle(first, Vec3(0), normal) +
                        projected_solid_angle(second, Vec3(0), normal),
                    projected_solid_angle(whole, Vec3(0), normal), 1e-11)
            << i;
    }
}

TEST(CurvedIrradiance, CylinderIsTheTube) {
    test::Random random(7);
    int compared = 0;
    for (int i = 0; i < 200; ++i) {
        const Vec3 normal = test::random_direction(random);
        const FrustumLight side{test::random_direction(random) * 900,
                                test::random_direction(random) * 900, 40, 40, Rgb(1)};
        const auto view = view_of(TubeLamp{side.from, side.to, 80, Rgb(1)}, Vec3(0), normal);
        if (!view || view->ratio() > 1) continue;
        const double tube = cylinder_solid_angle(*view, {view->x_at(0), view->x_at(1)});
        EXPECT_NEAR(projected_solid_angle(side, Vec3(0), normal), tube, 1e-7) << i;
        compared += tube > 1e-3;
    }
    EXPECT_GT(compared, 50);
}

TEST(CurvedIrradiance, EllipsoidOfEqualAxesIsTheSphere) {
    test::Random random(9);
    for (int i = 0; i < 100; ++i) {
        const Vec3 center = test::random_direction(random) * test::uniform(random, 300, 3000);
        const double radius = center.length() * test::uniform(random, 0.001, 0.99);
        const Vec3 x = test::random_direction(random);
        const Vec3 y = any_perpendicular(x).normalized(), z = x.cross(y);
        const EllipsoidLight ball{center, x * radius, y * radius, z * radius, Rgb(1)};
        const Vec3 normal = test::random_direction(random);
        const double sphere =
            projected_solid_angle(SphereLight{center, radius, Rgb(1)}, Vec3(0), normal);
        EXPECT_NEAR(projected_solid_angle(ball, Vec3(0), normal), sphere, 1e-9 * sphere + 1e-15);
    }
}

/// The wall cuts a cylinder along the x axis into two.
TEST(CurvedIrradiance, VisiblePartsOfLinesAddUpToTheClosedForm) {
    const FrustumLight whole{{-600, 150, 800}, {700, 150, 800}, 120, 240, Rgb(1)};
    FrustumLight left = whole;
    left.to.x = 100, left.to_radius = 120 + 120 * 700.0 / 1300;
    for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(0.8, 0, 0.6), Vec3(-0.36, 0.48, 0.8)}) {
        const double all = projected_solid_angle(whole, Vec3(0), normal);
        EXPECT_NEAR(
            visible_share(whole, Vec3(0), normal, test::ShowsBelow(100), {1e-7, 0.12}) * all,
            projected_solid_angle(left, Vec3(0), normal), 1e-5 * all);
    }
}

TEST(CurvedIrradiance, HoldsWhatLiesOnOrIn) {
    const FrustumLight cone{{0, 0, 0}, {0, 0, 100}, 50, 0};
    EXPECT_TRUE(holds(cone, Vec3(20, 0, 50)));
    EXPECT_FALSE(holds(cone, Vec3(30, 0, 50)));
    EXPECT_FALSE(holds(cone, Vec3(0, 0, -1)));
    const DiscLight disc{{0, 0, 5}, {0, 0, 1}, 10};
    EXPECT_TRUE(holds(disc, Vec3(3, -4, 5)));
    EXPECT_FALSE(holds(disc, Vec3(3, -4, 5.01)));
    EXPECT_FALSE(holds(disc, Vec3(9, 9, 5)));
    const EllipsoidLight ball{{0, 0, 0}, {10, 0, 0}, {0, 20, 0}, {0, 0, 30}};
    EXPECT_TRUE(holds(ball, Vec3(0, 0, 29)));
    EXPECT_FALSE(holds(ball, Vec3(0, 29, 0)));
}

TEST(CurvedIrradiance, DiscShinesFromOneFace) {
    const DiscLight disc{{0, 0, 1000}, {0, 0, -1}, 300, Rgb(1)};
    EXPECT_NEAR(projected_solid_angle(disc, Vec3(0), {0, 0, 1}), pi * 0.09 / 1.09, 1e-13);
    EXPECT_EQ(projected_solid_angle(disc, Vec3(0, 0, 2000), {0, 0, -1}), 0);
    EXPECT_FALSE(width_of(disc, Vec3(0, 0, 2000), {0, 0, -1}));
    EXPECT_FALSE(area_hit(disc, Vec3(0, 0, 2000), {0, 0, -1}, {}));
}

} // namespace
} // namespace keiko
