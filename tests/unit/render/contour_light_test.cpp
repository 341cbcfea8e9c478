// Luminous bodies by their contour, held against closed forms, the oracle and rays.
#include "keiko/geometry/model/primitive.h"
#include "keiko/light/areas/area_irradiance.h"
#include "keiko/light/areas/area_penumbra.h"
#include "keiko/light/areas/contour_width.h"
#include "keiko/light/rig/body_lamps.h"
#include "keiko/math/axes.h"
#include "keiko/render/shading/occluded_visibility.h"
#include "keiko/render/shading/traced_lamp.h"

#include "tests/support/curved_row.h"
#include "tests/support/oracle.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"
#include "tests/unit/render/plates.h"
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using std::numbers::pi;

ContourLight lamp_of(SurfaceModel model) {
    return {std::make_shared<const TracedLamp>(std::move(model)), Rgb(1)};
}

ContourLight lamp_of(const PrimitiveShape& shape) {
    return lamp_of(primitive_model(shape, "lamp"));
}

/// Faces of a solid between an outline and the same at another height, z upwards.
SurfaceModel prism(const std::vector<Vec2>& outline, double low, double high) {
    std::vector<SurfaceModel> faces;
    const auto at = [](const Vec2& p, double z) { return Vec3(p.x, p.y, z); };
    PolygonShape top, bottom;
    for (const Vec2& p : outline) top.corners.push_back(at(p, high));
    bottom.corners.assign(outline.size(), Vec3(0));
    for (std::size_t i = 0; i < outline.size(); ++i)
        bottom.corners[outline.size() - 1 - i] = at(outline[i], low);
    faces.push_back(primitive_model(top, "top"));
    faces.push_back(primitive_model(bottom, "bottom"));
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec3 from = at(outline[i], low), to = at(outline[(i + 1) % outline.size()], low);
        faces.push_back(
            primitive_model(PlaneShape{from, to - from, Vec3(0, 0, high - low)}, "side"));
    }
    return merge(faces);
}

/// An L of legs 600 mm long and 200 mm wide, 150 mm high.
SurfaceModel angle_bracket(double z) {
    return prism({{0, 0}, {600, 0}, {600, 200}, {200, 200}, {200, 600}, {0, 600}}, z, z + 150);
}

SurfaceModel ring(double z) {
    test::ShapeBuilder shapes;
    shapes.face(test::torus(500, 80));
    shapes.place({Affine::translate({0, 0, z})});
    return shapes.model();
}

/// Projected solid angle by rays in the strata of a hemisphere, cosine-weighted.
double by_rays(const Tracer& lamp, const Tracer* others, const Vec3& point, const Vec3& normal) {
    constexpr int side = 600;
    const Vec3 x = any_perpendicular(normal).normalized(), y = normal.cross(x);
    std::vector<Ray> rays;
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k) {
            const double sine = std::sqrt((i + 0.5) / side), turn = 2 * pi * (k + 0.5) / side;
            rays.push_back({.origin = point,
                            .direction = (x * std::cos(turn) + y * std::sin(turn)) * sine +
                                         normal * std::sqrt(1 - sine * sine)});
        }
    const auto met = lamp.nearest_crossings(rays);
    int lit = 0;
    for (std::size_t i = 0; i < rays.size(); ++i)
        if (met[i]) {
            rays[i].t_max = met[i].t;
            lit += others && others->any(rays[i]) ? 0 : 1;
        }
    return pi * lit / (side * side);
}

TEST(ContourLight, CurvedBodiesHaveTheirClosedForms) {
    test::Random random(7);
    for (int i = 0; i < 60; ++i) {
        const Vec3 center = test::random_direction(random) * test::uniform(random, 700, 2500);
        const Vec3 along = test::random_direction(random) * test::uniform(random, 50, 500);
        const double radius = test::uniform(random, 20, 400);
        const double other = i % 2 ? radius : test::uniform(random, 20, 400);
        const Vec3 normal = test::random_direction(random);
        const FrustumShape shape{center - along, center + along, radius, other, false};
        const FrustumLight side{shape.from, shape.to, radius, other, Rgb(1)};
        const double cone =
            projected_solid_angle(side, Vec3(0), normal) +
            projected_solid_angle(DiscLight{shape.from, -side.along(), radius, Rgb(1)}, Vec3(0),
                                  normal) +
            projected_solid_angle(DiscLight{shape.to, side.along(), other, Rgb(1)}, Vec3(0),
                                  normal);
        EXPECT_NEAR(projected_solid_angle(lamp_of(shape), Vec3(0), normal), cone, 2e-6 * pi) << i;
        const EllipsoidShape egg{center, along, along.cross(normal).normalized() * radius,
                                 along.cross(normal).cross(along).normalized() * other};
        const EllipsoidLight exact{egg.center, egg.u, egg.v, egg.w, Rgb(1)};
        EXPECT_NEAR(projected_solid_angle(lamp_of(egg), Vec3(0), normal),
                    projected_solid_angle(exact, Vec3(0), normal), 2e-6 * pi)
            << i;
    }
}

/// Bodies of exact patches behind plates, to the accuracy that their closed forms have there.
TEST(ContourLight, BodiesBehindPlatesMeetTheOracle) {
    const auto compare = [](const test::OracleRow& row, const PrimitiveShape& shape) {
        const test::Plates plates(row);
        const double lx = row.number("in.L") * plates.seen(lamp_of(shape), test::of_numbers);
        EXPECT_NEAR(lx, row.number("out.E"), 1e-4 * row.number("out.E_unocc") + 1e-9) << row.id();
    };
    for (const test::OracleRow& row : test::OracleTable("area_curved")) {
        const auto part = test::parts_of(row).front();
        if (const auto* egg = std::get_if<EllipsoidLight>(&part))
            compare(row, EllipsoidShape{egg->center, egg->u, egg->v, egg->w});
        else {
            const auto& side = std::get<FrustumLight>(part);
            compare(row, FrustumShape{side.from, side.to, side.radius, side.to_radius, false});
        }
    }
    for (const test::OracleRow& row : test::OracleTable("area_sphere")) {
        const double r = row.number("in.R");
        compare(row, EllipsoidShape{row.vector("in.C"), {r, 0, 0}, {0, r, 0}, {0, 0, r}});
    }
}

/// Bodies that hide parts of themselves, from below, from aside, and from within their boxes.
TEST(ContourLight, HollowBodiesHideThemselves) {
    const std::array<Vec3, 5> points{Vec3(0, 0, 0), Vec3(900, -300, 650), Vec3(300, 300, 560),
                                     Vec3(-100, 250, 300), Vec3(350, 350, 700)};
    const std::array<Vec3, 3> normals{Vec3(0, 0, 1), Vec3(-0.8, 0, 0.6), Vec3(0.36, -0.8, 0.48)};
    for (const SurfaceModel& model : {angle_bracket(500), ring(600)}) {
        const Tracer tracer(model);
        const ContourLight light = lamp_of(model);
        for (const Vec3& point : points)
            for (const Vec3& normal : normals)
                EXPECT_NEAR(projected_solid_angle(light, point, normal),
                            by_rays(tracer, nullptr, point, normal), 3e-3)
                    << model.faces.size() << ' ' << point << ' ' << normal;
    }
}

/// A wall behind a ring hides nothing of it, a plate before it some, one within its hole a little.
TEST(ContourLight, BodiesBeforeAndBehindAreToldApart) {
    const ContourLight light = lamp_of(ring(600));
    const Tracer lamp(ring(600));
    const Vec3 point(100, -50, 0), normal(0, 0, 1);
    const auto hidden_by = [&](const PrimitiveShape& shape) {
        const SurfaceModel model = primitive_model(shape, "other");
        const Tracer tracer(model);
        const Occluders occluders(model, tracer);
        const OccludedVisibility visible(&occluders, tracer, Viewpoint::at(point), bounds_of(light),
                                         {}, normal);
        const double all = projected_solid_angle(light, point, normal);
        const double seen = all * visible_share(light, point, normal, visible, test::of_numbers);
        EXPECT_NEAR(seen, by_rays(lamp, &tracer, point, normal), 2e-3);
        return (all - seen) / all;
    };
    EXPECT_EQ(hidden_by(PlaneShape{{-2000, -2000, 700}, {4000, 0, 0}, {0, 4000, 0}}), 0);
    EXPECT_GT(hidden_by(DiscShape{{200, 0, 300}, {0, 0, 1}, 250}), 0.1);
    // Half of the plate is behind the ring, half before it.
    const double part = hidden_by(PlaneShape{{-700, -40, 450}, {0, 80, 0}, {1400, 0, 300}});
    EXPECT_GT(part, 0.001);
    EXPECT_LT(part, 0.1);
}

TEST(ContourLight, OpenBodiesAreNone) {
    const FrustumShape can{{0, 0, 0}, {0, 0, 300}, 80, 50, false};
    FrustumShape pipe = can;
    pipe.open = true;
    EXPECT_TRUE(TracedLamp(primitive_model(can, "can")).is_closed());
    EXPECT_FALSE(TracedLamp(primitive_model(pipe, "pipe")).is_closed());
    EXPECT_TRUE(TracedLamp(angle_bracket(0)).is_closed());
    EXPECT_TRUE(TracedLamp(ring(0)).is_closed());
    SurfaceModel inwards = primitive_model(can, "can");
    for (Face& face : inwards.faces) face.reversed = true;
    EXPECT_FALSE(TracedLamp(inwards).is_closed());
}

TEST(ContourLight, MovesWithItsBody) {
    const FrustumShape can{{200, 300, 900}, {250, 100, 1300}, 80, 50, false};
    Affine motion = Affine::rotate({1, 2, 3}, 0.7) * Affine::translate({50, 20, -70});
    motion.rows[0] = -motion.rows[0]; // mirrored
    motion.translation.x = -motion.translation.x;
    const ContourLight light = lamp_of(can);
    LightRig rig;
    rig.sources = {light};
    EXPECT_TRUE(shines_by_bodies_alone(rig));
    move_body_lamps(motion, rig);
    const auto& moved = std::get<ContourLight>(rig.sources[0]);
    const Vec3 point(30, 10, 0), normal = Vec3(0.3, 0, 1).normalized();
    EXPECT_NEAR(projected_solid_angle(moved, motion.point(point), motion.vector(normal)),
                projected_solid_angle(light, point, normal), 1e-9);
    EXPECT_TRUE(holds(moved, motion.point({225, 200, 1100})));
    EXPECT_FALSE(holds(moved, motion.point({225, 500, 1100})));
}

/// Light of a place on the body itself comes from the other parts alone.
TEST(ContourLight, BodyLightsItselfWhereItIsHollow) {
    const ContourLight light = lamp_of(angle_bracket(0));
    // On the inner side of one leg: the other one is a rectangle at a right angle to it.
    const Vec3 point(400, 200, 75), normal(0, 1, 0);
    const PolygonLight leg{
        {{200, 200, 0}, {200, 200, 150}, {200, 600, 150}, {200, 600, 0}}, Rgb(1), true};
    EXPECT_NEAR(projected_solid_angle(light, point, normal),
                projected_solid_angle(leg, point, normal), 1e-4);
    EXPECT_NEAR(projected_solid_angle(light, {300, 0, 75}, {0, -1, 0}), 0, 1e-9);
}

} // namespace
} // namespace keiko
