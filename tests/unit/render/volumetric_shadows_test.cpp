#include "keiko/render/shading/occluded_visibility.h"

#include "tests/support/occluder_row.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using namespace test;

/// The spheres of a row, mm.
SurfaceModel spheres_of(const OracleRow& row) {
    std::vector<SurfaceModel> models;
    const std::vector<double> numbers = row.list("in.spheres");
    for (std::size_t i = 0; i + 3 < numbers.size(); i += 4) {
        const Vec3 center(numbers[i], numbers[i + 1], numbers[i + 2]);
        models.push_back(
            sphere_model(Affine::translate(center * 1000) * Affine::scale(numbers[i + 3] * 1000)));
    }
    return merge(models);
}

LightRig rig_of(const OracleRow& row) {
    const std::string base = row.text("in.base");
    const BeamEdge edge = base == "sharp"  ? BeamEdge::sharp
                          : base == "soft" ? BeamEdge::soft
                                           : BeamEdge::mixed;
    const double q = edge == BeamEdge::mixed ? row.number("in.qmix") : 0;
    const std::string phase = row.text("in.kind");
    Medium medium{.extinction = Rgb(row.number("in.sigma")),
                  .albedo = Rgb(row.number("in.w0")),
                  .phase = HazePhase{phase == "k16" ? row.number("in.par") : 0},
                  .dims_light_leg = row.text("in.leg") == "1"};
    if (phase == "hg") medium.phase = HenyeyGreenstein{row.number("in.par")};
    return {.name = "",
            .sources = {Spotlight{.position = row.vector("in.Q") * 1000,
                                  .aim = row.vector("in.C") * 1000,
                                  .half_angle = row.number("in.gamma_deg"),
                                  .profile = EdgeProfile{edge, q},
                                  .intensity = Rgb(row.number("in.I0"))}},
            .ambient = Rgb(0),
            .medium = medium};
}

} // namespace

/// Only the scene is taken from the table: the lit parts are Keiko's own.
TEST(VolumetricShadows, MeetTheOracleOfShaftsPastSpheres) {
    WorstError lit("lit"), light("L_scatter");
    for (const OracleRow& row : OracleTable("light_shaft")) {
        if (!row.has("in.spheres")) continue;
        const SurfaceModel model = spheres_of(row);
        const Tracer tracer(model);
        const Occluders occluders(model, tracer);
        const LightRig rig = rig_of(row);
        const Vec3 eye = row.vector("in.O") * 1000;
        const double length = row.number("in.l");
        const Segment ray{eye, eye + row.unit("in.w") * (length * 1000)};
        const VolumetricShadows shadows(rig, &occluders, tracer, std::span(&ray, 1));
        const VisibleFrom visible = shadows.visible();

        std::vector<double> ends;
        for (const ParameterInterval& part : in_light(rig.sources[0], ray))
            for (const ParameterInterval& seen : visible(0, {ray.at(part.begin), ray.at(part.end)}))
                for (const double t : {seen.begin, seen.end})
                    ends.push_back(part.begin + t * part.length());
        const std::vector<double> expected = row.list("out.lit");
        ASSERT_EQ(ends.size(), expected.size()) << row.id();
        for (std::size_t i = 0; i < ends.size(); ++i)
            lit.compare(row, ends[i], expected[i] / length, 1e-10, 1e-10);
        light.compare(row, luminance_along(rig, ray, Rgb(0), visible).g,
                      row.number("out.L_scatter"), 1e-8);
    }
}

} // namespace keiko
