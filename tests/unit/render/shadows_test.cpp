#include "keiko/light/tubes/tube_penumbra.h"
#include "keiko/render/shading/direct_lighting.h"
#include "keiko/render/shading/occluded_visibility.h"

#include "tests/support/occluder_row.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using namespace test;

/// A row of lamp_occluded: its occluders, its lamp and its receiver.
struct Shade {
    SurfaceModel model;
    Tracer tracer;
    Occluders occluders;
    TubeLamp lamp;
    Vec3 point, normal;
    std::vector<Vec3> region;

    explicit Shade(const OracleRow& row)
        : model(occluders_of(row)),
          tracer(model),
          occluders(model, tracer),
          lamp{row.vector("in.A"), row.vector("in.B"), row.number("in.d"), Rgb(row.number("in.L"))},
          point(row.vector("in.P")),
          normal(row.unit("in.N")) {
        const double r = lamp.diameter;
        for (const Vec3& end : {lamp.a, lamp.b})
            for (const double x : {-r, r})
                for (const double y : {-r, r})
                    for (const double z : {-r, r}) region.push_back(end + Vec3(x, y, z));
    }
    OccludedVisibility visible() const {
        return {&occluders, tracer, Viewpoint::at(point), region};
    }
};

TEST(Shadows, MeetTheOracleOfOccludedLampsByTheAxis) {
    WorstError line("E_line"), rectangle("E_rect_iv");
    for (const OracleRow& row : OracleTable("lamp_occluded")) {
        const Shade shade(row);
        const IntervalSet seen = shade.visible().intervals({shade.lamp.a, shade.lamp.b});
        const auto lit = [&](TubeModel model) {
            return irradiance(shade.lamp, shade.point, shade.normal, seen, model).r;
        };
        line.compare(row, lit(TubeModel::line), row.number("out.E_line"), 1e-11);
        rectangle.compare(row, lit(TubeModel::rectangle), row.number("out.E_rect_iv"), 1e-11);
    }
}

TEST(Shadows, MeetTheOracleOfPenumbraeAcrossTheWidth) {
    WorstError area("E_rect_area");
    for (const OracleRow& row : OracleTable("lamp_occluded")) {
        if (!row.has("out.E_rect_area")) continue;
        const Shade shade(row);
        const OccludedVisibility visible = shade.visible();
        const double whole = irradiance(shade.lamp, shade.point, shade.normal, IntervalSet::whole(),
                                        TubeModel::rectangle)
                                 .r;
        for (const double tolerance : {1e-4, 1e-7}) {
            const std::vector<LightVisibility> seen =
                seen_tubes({&shade.lamp, 1}, shade.point, shade.normal, visible,
                           {tolerance, TubeShape::rectangle});
            area.compare(row, whole * seen[0].share, row.number("out.E_rect_area"), tolerance,
                         1e-9);
        }
    }
}

/// A plate under one lamp; a board hides half of the lamp from the plate's middle.
TEST(Shadows, TakeHalfOfALampThatABoardHalfHides) {
    ModelBuilder builder;
    builder.plane({-100, -100, 0}, {200, 0, 0}, {0, 200, 0});
    builder.plane({0, -500, 500}, {500, 0, 0}, {0, 1000, 0});
    const SurfaceModel model = builder.build();
    const Tracer tracer(model);
    const Occluders occluders(model, tracer);
    LightRig rig;
    rig.sources = {
        CPlane{.origin = {-600, -500, 1000}, .u = {1200, 0, 0}, .v = {0, 1000, 0}, .lamps = 1}};
    Ray down;
    down.origin = {0, 0, 100};
    down.direction = {0, 0, -1};
    const auto hit = tracer.nearest(down);
    ASSERT_TRUE(hit);
    const auto under = [&](const LightRig& lights, const Occluders* shadows) {
        constexpr TubeModel asked = TubeModel::automatic;
        const Vec3 up(0, 0, 1);
        const PreparedRig prepared(lights);
        const DirectLighting shadowed(prepared, shadows, tracer);
        const PointLighting lit(
            prepared, hit->position, up, asked, shadowed.lights(),
            shadowed.light_visibility(hit->position, up, hit->root, shadowed.lights(), asked));
        return lit.illuminance_by_light()[0].r;
    };
    for (const TubeModel named : {TubeModel::automatic, TubeModel::cylinder, TubeModel::strip}) {
        LightRig own = rig;
        std::get<CPlane>(own.sources[0]).diffuse = named;
        EXPECT_GT(under(own, nullptr), 10);
        EXPECT_NEAR(under(own, &occluders), under(own, nullptr) / 2, 1e-4 * under(own, nullptr))
            << "by symmetry; a row that names its model has the same penumbra";
    }
}

} // namespace
} // namespace keiko
