#include "keiko/raster/shadow_casters.h"

#include "keiko/geometry/model/surface_model.h"

#include "tests/support/sphere_and_plate.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

TEST(ShadowCasters, HideFromAVerticalSunUpToAllBorders) {
    SurfaceMesh mesh;
    test::add_plate(mesh, Vec2(-10, -20), Vec2(30, 40), 50);
    const ShadowCasters casters(mesh);
    const Viewpoint sun = Viewpoint::towards({0, 0, 1});
    for (const double x : {-10.0, 7.0, 30.0})
        for (const double y : {-20.0, 11.0, 40.0}) {
            EXPECT_TRUE(casters.hide(Vec3(x, y, 0), sun, no_index)) << x << ", " << y;
            EXPECT_GE(casters.layers(Vec3(x, y, 0), sun), 1) << x << ", " << y;
        }
    for (const double off : {-10.001, 30.001})
        EXPECT_FALSE(casters.hide(Vec3(off, 0, 0), sun, no_index)) << off;
}

} // namespace
} // namespace keiko
