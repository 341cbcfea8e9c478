#include "keiko/light/areas/area_irradiance.h"

#include "keiko/light/areas/area_gloss.h"
#include "keiko/light/areas/area_penumbra.h"
#include "keiko/light/areas/ellipse_width.h"
#include "keiko/math/axes.h"
#include "keiko/math/quadrature.h"

#include "tests/support/oracle.h"
#include "tests/support/polyhedron_row.h"
#include "tests/support/random.h"
#include "tests/support/shows_below.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using std::numbers::pi;

/// A wall of a room 3 m wide, 2 m away, with a notch: concave.
const PolygonLight notched{{{-1500, 2000, 0},
                            {1500, 2000, 0},
                            {1500, 2000, 900},
                            {300, 2000, 900},
                            {300, 2000, 400},
                            {-200, 2000, 400},
                            {-200, 2000, 1100},
                            {-1500, 2000, 1100}},
                           Rgb(100)};

TEST(AreaIrradiance, SphereMeetsTheOracleWithoutPlates) {
    test::WorstError worst("E_unocc");
    for (const test::OracleRow& row : test::OracleTable("area_sphere")) {
        const SphereLight light{row.vector("in.C"), row.number("in.R"), Rgb(1)};
        const double lx =
            row.number("in.L") * projected_solid_angle(light, row.vector("in.P"), row.unit("in.N"));
        worst.compare(row, lx, row.number("out.E_unocc"), 1e-11);
    }
}

TEST(AreaIrradiance, PolygonMeetsTheOracleWithoutPlates) {
    test::WorstError worst("E_unocc");
    for (const test::OracleRow& row : test::OracleTable("area_polygon_occluded")) {
        const PolygonLight light{row.points("in.V"), Rgb(1), true};
        const double lx =
            row.number("in.L") * projected_solid_angle(light, row.vector("in.P"), row.unit("in.N"));
        worst.compare(row, lx, row.number("out.E_unocc"), 1e-11);
    }
}

TEST(AreaIrradiance, PolyhedronIsTheSumOfItsFacesThatFaceThePoint) {
    test::WorstError worst("E_unocc");
    for (const test::OracleRow& row : test::OracleTable("area_polyhedron")) {
        const Vec3 point = row.vector("in.P"), normal = row.unit("in.N");
        double lx = 0;
        int facing = 0;
        for (const PolygonLight& face : test::faces_of(row)) {
            facing += face.shines_at(point);
            lx += face.luminance.r * projected_solid_angle(face, point, normal);
        }
        EXPECT_EQ(facing, row.integer("out.n_front")) << row.id();
        worst.compare(row, lx, row.number("out.E_unocc"), 1e-11);
    }
}

TEST(AreaIrradiance, PanelIsDarkFromBehindUnlessBothFacesShine) {
    PolygonLight light{{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
    EXPECT_EQ(light.normal(), Vec3(0, 0, 1));
    const Vec3 below(0.5, 0.5, 0), above(0.5, 0.5, 2), up(0, 0, 1);
    EXPECT_EQ(projected_solid_angle(light, below, up), 0);
    const double lit = projected_solid_angle(light, above, -up);
    EXPECT_GT(lit, 0.5);
    light.two_sided = true;
    EXPECT_NEAR(projected_solid_angle(light, below, up), lit, 1e-14);
}

/// Lambert's law for a whole sphere, and a sphere that fills half of the sky.
TEST(AreaIrradiance, SphereAboveTheHorizonFollowsTheSquareOfItsSine) {
    const SphereLight light{{300, 400, 1200}, 500};
    const Vec3 up(0, 0, 1);
    EXPECT_NEAR(projected_solid_angle(light, Vec3(0), up), pi * 0.25 / 1.69 * (12.0 / 13), 1e-13);
    const SphereLight huge{{0, 0, 1e6}, 1e6 - 1e-3};
    EXPECT_NEAR(projected_solid_angle(huge, Vec3(0), up), pi, 1e-8);
    EXPECT_EQ(projected_solid_angle(light, Vec3(300, 400, 1300), up), 0);
}

/// Flux from one panel to another is that back, by Gauss's rule over the receiver.
TEST(AreaIrradiance, FluxIsReciprocal) {
    const PolygonLight a{{{0, 0, 0}, {700, 0, 0}, {700, 300, 0}, {0, 300, 0}}};
    const PolygonLight b{
        {{100, -200, 900}, {100, 400, 700}, {900, 400, 1000}, {900, -200, 1200}}, Rgb(1), true};
    const auto flux = [](const PolygonLight& from, const PolygonLight& to, const Vec3& normal) {
        const Vec3 u = to.corners[1] - to.corners[0], v = to.corners[3] - to.corners[0];
        return u.cross(v).length() * integrate(
                                         [&](double s) {
                                             return integrate(
                                                 [&](double t) {
                                                     const Vec3 at = to.corners[0] + u * s + v * t;
                                                     return projected_solid_angle(from, at, normal);
                                                 },
                                                 0, 1, 24);
                                         },
                                         0, 1, 24);
    };
    const double there = flux(a, b, -b.normal() * (b.normal().z > 0 ? 1 : -1));
    const double back = flux(b, a, a.normal());
    EXPECT_GT(back, 1e4);
    EXPECT_NEAR(there, back, 1e-9 * back);
}

/// A rectangle at a height of 800 mm that shines down.
PolygonLight ceiling(double from, double to) {
    return {{{from, -300, 800}, {from, 500, 800}, {to, 500, 800}, {to, -300, 800}}};
}

/// Along lines and across them, with and without the horizon across the panel. A jump from line to
/// line that no breakpoint states is found to 2^-14 of the width.
TEST(AreaPenumbra, VisiblePartsOfLinesAddUpToTheClosedForm) {
    const WidthOptions options{1e-7, 0.12, true};
    for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(0.8, 0, 0.6), Vec3(-0.36, 0.48, 0.8)})
        for (const double reach : {600.0, 200.0}) { // longer than wide, and wider than long
            const PolygonLight whole = ceiling(-400, reach);
            const double all = projected_solid_angle(whole, Vec3(0), normal);
            const double left = projected_solid_angle(ceiling(-400, 100), Vec3(0), normal);
            EXPECT_GT(all, left);
            EXPECT_NEAR(visible_share(whole, Vec3(0), normal, test::ShowsBelow(100), options) * all,
                        left, 1e-5 * all);
        }
}

TEST(AreaPenumbra, WholeAndNothingArePrecise) {
    const Vec3 up(0, 0, 1);
    const SphereLight globe{{500, 0, 300}, 400};
    const WidthOptions options{1e-4};
    for (const double shown : {0.0, 1.0}) {
        const test::ShowsBelow visible(shown > 0 ? 1e9 : -1e9);
        EXPECT_NEAR(visible_share(notched, Vec3(0), up, visible, options), shown, 1e-15);
        EXPECT_NEAR(visible_share(globe, Vec3(0), up, visible, options), shown, 1e-15);
    }
    // All of the globe is below the horizon of one, and some of it below that of the other.
    EXPECT_EQ(visible_share(globe, Vec3(0), Vec3(-1, 0, 0), Unoccluded(), options), 0);
    EXPECT_EQ(visible_share(globe, Vec3(0), -up, Unoccluded(), options), 1);
}

/// Reflects in proportion to the cosine, as a diffuse surface does.
struct CosineKernel {
    Vec3 normal;

    Rgb operator()(const Vec3& light) const { return Rgb(std::max(normal.dot(light), 0.0)); }
    const Vec3& peak() const { return normal; }
    LobeChart chart() const { return {normal, 1}; }
    double cone(double) const { return pi; }
};

/// A star of a panel around a place, with `tips` tips.
PolygonLight random_star(int tips, test::Random& random) {
    const Vec3 center = test::random_direction(random) * test::uniform(random, 300, 3000);
    const Vec3 axis = test::random_direction(random);
    const Vec3 x = any_perpendicular(axis).normalized(), y = axis.cross(x);
    PolygonLight star{{}, Rgb(1), true};
    for (int i = 0; i < 2 * tips; ++i) {
        const double angle = pi * (i + test::uniform(random, 0, 0.9)) / tips;
        const double reach = test::uniform(random, 100, 1500);
        star.corners.push_back(center + (x * std::cos(angle) + y * std::sin(angle)) * reach);
    }
    return star;
}

/// The closed form and the lines are two ways to one projected solid angle.
TEST(AreaIrradiance, LinesOfAnySourceAddUpToTheClosedForm) {
    test::Random random(8);
    int compared = 0;
    const auto compare = [&](const auto& light, const Vec3& normal) {
        const double closed = projected_solid_angle(light, Vec3(0), normal);
        const auto width = width_of(light, Vec3(0), normal);
        compared += closed > 0.01;
        const double by_lines =
            width ? AreaGloss(*width, CosineKernel{normal}, 1e-9).integral().g : 0;
        EXPECT_NEAR(by_lines, closed, 1e-6);
    };
    for (int i = 0; i < 200; ++i) {
        const Vec3 normal = test::random_direction(random);
        compare(random_star(2 + i % 4, random), normal);
        const Vec3 center = test::random_direction(random) * test::uniform(random, 300, 3000);
        compare(SphereLight{center, center.length() * test::uniform(random, 0.01, 0.99)}, normal);
    }
    EXPECT_GT(compared, 100);
}

/// No corner, and no place of a sphere, is nearer to the direction.
TEST(AreaIrradiance, LeastAngleIsALowerBound) {
    test::Random random(4);
    for (int i = 0; i < 300; ++i) {
        const Vec3 direction = test::random_direction(random);
        const PolygonLight star = random_star(3, random);
        const double bound = least_angle(star, Vec3(0), direction);
        for (const Vec3& corner : star.corners)
            EXPECT_LE(bound,
                      std::atan2(direction.cross(corner).length(), direction.dot(corner)) + 1e-12);
    }
    const SphereLight globe{{0, 3000, 0}, 1500};
    EXPECT_NEAR(least_angle(globe, Vec3(0), {1, 0, 0}), pi / 3, 1e-12);
    EXPECT_EQ(least_angle(globe, Vec3(0, 1600, 0), {-1, 0, 0}), 0);
    EXPECT_EQ(least_angle(globe, Vec3(0), Vec3(0.1, 1, 0).normalized()), 0);
}

TEST(AreaIrradiance, HoldsWhatLiesOnOrIn) {
    EXPECT_TRUE(holds(notched, Vec3(-800, 2000, 700)));
    EXPECT_FALSE(holds(notched, Vec3(0, 2000, 700))); // in the notch
    EXPECT_FALSE(holds(notched, Vec3(-800, 2000.1, 700)));
    const SphereLight globe{{0, 0, 10}, 5};
    EXPECT_TRUE(holds(globe, Vec3(0, 3, 8)));
    EXPECT_FALSE(holds(globe, Vec3(0, 0, 5)));
}

} // namespace
} // namespace keiko
