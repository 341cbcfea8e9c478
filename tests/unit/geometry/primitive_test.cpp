#include "keiko/geometry/model/primitive.h"

#include "keiko/math/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using std::numbers::pi;

const Vec3 from(10, 20, 30), to(110, 60, 90);

/// Area and volume below the patches of whole faces, by Gauss's rule.
struct Measures {
    double area = 0, volume = 0;
};

Measures measures_of(const SurfaceModel& model) {
    Measures sum;
    for (std::uint32_t p = 0; p < model.patches.size(); ++p)
        for (const QuadratureNode& a : gauss_legendre(24))
            for (const QuadratureNode& b : gauss_legendre(24)) {
                const SurfaceDerivatives s =
                    evaluate(model.patch(p), Vec2((1 + a.x) / 2, (1 + b.x) / 2), 1);
                const Vec3 normal = s.du().cross(s.dv()) * (a.weight * b.weight / 4);
                sum.area += normal.length(), sum.volume += normal.dot(s.position()) / 3;
            }
    return sum;
}

TEST(Primitive, BoxHasItsAreaAndVolume) {
    const BoxShape box{{1, 2, 3}, {10, 0, 0}, {2, 20, 0}, {1, 3, 30}};
    const Measures found = measures_of(primitive_model(box, "box"));
    EXPECT_NEAR(found.volume, 6000, 1e-8);
    EXPECT_NEAR(found.area, surface_area(box), 1e-8);
}

TEST(Primitive, EllipsoidHasItsAreaAndVolume) {
    const EllipsoidShape shape{{5, -7, 9}, {10, 0, 0}, {2, 20, 0}, {1, 3, -30}};
    const Measures found = measures_of(primitive_model(shape, "egg"));
    EXPECT_NEAR(found.volume, 4 * pi / 3 * 6000, 1e-3);
    EXPECT_NEAR(found.area, surface_area(shape), 1e-3);
    const EllipsoidShape ball{{0, 0, 0}, {7, 0, 0}, {0, 7, 0}, {0, 0, 7}};
    EXPECT_NEAR(surface_area(ball), 4 * pi * 49, 1e-9);
}

TEST(Primitive, ConesHaveTheirAreaAndVolume) {
    const double height = (to - from).length();
    for (const double tip : {0.0, 15.0, 40.0}) {
        const FrustumShape open{from, to, 40, tip, true};
        const SurfaceModel model = primitive_model(open, "cone");
        ASSERT_EQ(model.faces.size(), 1U);
        EXPECT_NEAR(measures_of(model).area, surface_area(open), 1e-6);
        const FrustumShape closed{from, to, 40, tip, false};
        const SurfaceModel whole = primitive_model(closed, "cone");
        EXPECT_EQ(whole.faces.size(), tip > 0 ? 3U : 2U);
        EXPECT_NEAR(surface_area(closed), surface_area(open) + pi * (1600 + tip * tip), 1e-9);
        // Ends add the cones below them, from the origin.
        const Vec3 along = (to - from) / height;
        const double ends = pi * (tip * tip * along.dot(to) - 1600 * along.dot(from)) / 3;
        EXPECT_NEAR(measures_of(model).volume + ends,
                    pi * height * (1600 + 40 * tip + tip * tip) / 3, 1e-4);
    }
}

/// Trim curves of a disc run around a circle of its plane.
TEST(Primitive, DiscIsTrimmedByItsRim) {
    const DiscShape disc{from, Vec3(0.6, 0, 0.8), 25};
    const SurfaceModel model = primitive_model(disc, "disc");
    ASSERT_EQ(model.trim_loops.size(), 1U);
    for (std::uint32_t c = 0; c < 4; ++c)
        for (const double t : {0.0, 0.3, 0.8}) {
            const Vec2 uv = evaluate(model.trim_curve(c), t, 0)[0];
            EXPECT_NEAR(uv.length(), 1, 1e-14);
            const Vec3 at = evaluate(model.patch(0), (uv + Vec2(1)) / 2, 0).position();
            EXPECT_NEAR((at - from).length(), 25, 1e-12);
            EXPECT_NEAR((at - from).dot(disc.normal), 0, 1e-12);
        }
    const SurfaceDerivatives s = evaluate(model.patch(0), Vec2(0.5), 1);
    EXPECT_GT(s.du().cross(s.dv()).dot(disc.normal), 0);
    EXPECT_NEAR(surface_area(disc), pi * 625, 1e-10);
}

/// Trim curves of an L run along its sides; its face is on the side that sees them anticlockwise.
TEST(Primitive, PolygonIsTrimmedByItsSides) {
    const PolygonShape shape{
        {{0, 0, 5}, {0, 600, 5}, {200, 600, 5}, {200, 200, 5}, {500, 200, 5}, {500, 0, 5}}};
    const SurfaceModel model = primitive_model(shape, "L");
    ASSERT_EQ(model.faces.size(), 1U);
    ASSERT_EQ(model.trim_curves.size(), 6U);
    for (std::uint32_t c = 0; c < 6; ++c)
        for (const double t : {0.0, 0.25}) {
            const Vec3 &a = shape.corners[(c + 5) % 6], &b = shape.corners[c];
            const Vec3 at =
                evaluate(model.patch(0), evaluate(model.trim_curve(c), t, 0)[0], 0).position();
            EXPECT_LT((at - (a + (b - a) * t)).length(), 1e-12) << c << t;
        }
    const SurfaceDerivatives s = evaluate(model.patch(0), Vec2(0.5), 1);
    EXPECT_GT(s.du().cross(s.dv()).dot(Vec3(0, 0, -1)), 0);
    EXPECT_GT(s.du().dot(Vec3(0, 1, 0)), 0); // u along the first side
    EXPECT_NEAR(surface_area(shape), 600 * 200 + 300 * 200, 1e-9);
}

} // namespace
} // namespace keiko
