#include "keiko/geometry/model/primitive.h"
#include "keiko/light/areas/area_irradiance.h"
#include "keiko/render/shading/traced_lamp.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <vector>

namespace keiko {
namespace {

/// Rays along the axes of these meet the outside first, or nothing; they are open all the same.
TEST(ContourLight, OpenBodiesAlongAnAxisAreNone) {
    for (unsigned axis = 0; axis < 3; ++axis) {
        Vec3 end(0);
        end[axis] = 300;
        const FrustumShape pipe{{0, 0, 0}, end, 80, 80, true};
        EXPECT_FALSE(TracedLamp(primitive_model(pipe, "pipe")).is_closed()) << axis;
        const FrustumShape can{{0, 0, 0}, end, 80, 80, false};
        EXPECT_TRUE(TracedLamp(primitive_model(can, "can")).is_closed()) << axis;
    }
    const std::array<std::array<Vec3, 3>, 6> faces{{{Vec3(0), {0, 0, 1}, {0, 1, 0}},
                                                    {Vec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}},
                                                    {Vec3(0), {1, 0, 0}, {0, 0, 1}},
                                                    {Vec3(0, 1, 0), {0, 0, 1}, {1, 0, 0}},
                                                    {Vec3(0), {0, 1, 0}, {1, 0, 0}},
                                                    {Vec3(0, 0, 1), {1, 0, 0}, {0, 1, 0}}}};
    for (std::size_t left_out = 0; left_out <= 6; left_out += 2) {
        std::vector<SurfaceModel> kept;
        for (std::size_t i = 0; i < 6; ++i)
            if (const auto& [at, u, v] = faces[i]; i / 2 != left_out / 2)
                kept.push_back(primitive_model(PlaneShape{at * 90, u * 90, v * 90}, "side"));
        EXPECT_EQ(TracedLamp(merge(kept)).is_closed(), left_out == 6) << left_out;
    }
}

/// Cubes of 12 mm in a box of 3 m: pictures have their light too.
TEST(ContourLight, PicturesHaveTheLightOfScatteredParts) {
    test::Random random(3);
    std::vector<SurfaceModel> cubes;
    for (int i = 0; i < 40; ++i) {
        const auto in = [&](double from, double to) { return test::uniform(random, from, to); };
        const Vec3 at(in(-1500, 1500), in(-1500, 1500), in(2000, 2300));
        const BoxShape cube{at, {12, 0, 0}, {0, 12, 0}, {0, 0, 12}};
        cubes.push_back(primitive_model(cube, "cube"));
    }
    const auto body = std::make_shared<const TracedLamp>(merge(cubes));
    EXPECT_TRUE(body->is_closed());
    const ContourLight light{body, Rgb(1)};
    for (const Vec3& point :
         {Vec3(0), Vec3(700, -900, 300), Vec3(2500, 400, 0), Vec3(90, 10, 1900)}) {
        const double exact = projected_solid_angle(light, point, {0, 0, 1}, 1e-6);
        EXPECT_GT(exact, 0);
        EXPECT_NEAR(projected_solid_angle(light, point, {0, 0, 1}, 1e-3), exact, 1e-3 * exact)
            << point;
    }
}

} // namespace
} // namespace keiko
