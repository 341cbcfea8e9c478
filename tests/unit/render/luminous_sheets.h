#pragma once

#include "keiko/geometry/model/outward_side.h"
#include "keiko/light/areas/area_irradiance.h"
#include "keiko/math/axes.h"
#include "keiko/render/shading/traced_lamp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <utility>

namespace keiko::test {

/// A lamp of unit luminance.
inline ContourLight lamp_of(SurfaceModel model, LampSides sides) {
    return {std::make_shared<const TracedLamp>(std::move(model), Job{}, sides), Rgb(1)};
}

/// Projected solid angle by rays in the strata of a hemisphere, cosine-weighted.
inline double by_rays(const SurfaceModel& model, bool both, const Vec3& point, const Vec3& normal) {
    constexpr int side = 400;
    const Tracer tracer(model);
    const Vec3 x = any_perpendicular(normal).normalized(), y = normal.cross(x);
    int lit = 0;
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k) {
            const double sine = std::sqrt((i + 0.5) / side),
                         turn = 2 * std::numbers::pi * (k + 0.5) / side;
            const Ray ray{.origin = point,
                          .direction = (x * std::cos(turn) + y * std::sin(turn)) * sine +
                                       normal * std::sqrt(1 - sine * sine)};
            const auto hit = tracer.nearest(ray);
            lit += hit && (both || hit->normal.dot(ray.direction) *
                                           outward_side(model, hit->instance, hit->patch, hit->uv) <
                                       0);
        }
    return std::numbers::pi * lit / (side * side);
}

/// Expects the light of sheets, on the outer side and on both, to be that of rays.
inline void expect_light_of_rays(const SurfaceModel& model, std::span<const Vec3> points) {
    const ContourLight outer = lamp_of(model, LampSides::outer_side);
    const ContourLight both = lamp_of(model, LampSides::both_sides);
    for (const Vec3& point : points)
        for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(-0.36, 0.48, -0.8)}) {
            EXPECT_NEAR(projected_solid_angle(outer, point, normal),
                        by_rays(model, false, point, normal), 4e-3)
                << "outer side" << point << normal;
            EXPECT_NEAR(projected_solid_angle(both, point, normal),
                        by_rays(model, true, point, normal), 4e-3)
                << "both sides" << point << normal;
        }
}

} // namespace keiko::test
