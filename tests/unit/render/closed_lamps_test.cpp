#include "keiko/geometry/model/primitive.h"
#include "keiko/render/shading/traced_lamp.h"

#include <gtest/gtest.h>

#include <array>

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

} // namespace
} // namespace keiko
