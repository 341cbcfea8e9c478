#include "keiko/rig/luminance_along.h"

#include "keiko/spotlight/beam_volume.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

using namespace keiko;

namespace {

LightRig rig_in(const test::OracleRow& row) {
    const std::string base = row.text("in.base");
    const BeamEdge edge = base == "sharp"  ? BeamEdge::sharp
                          : base == "soft" ? BeamEdge::soft
                                           : BeamEdge::mixed;
    const Spotlight light{.position = row.vector("in.Q") * 1000,
                          .aim = row.vector("in.C") * 1000,
                          .half_angle = row.number("in.gamma_deg"),
                          .profile = EdgeProfile{edge, row.number("in.qmix")},
                          .intensity = Rgb(row.number("in.I0"))};
    const double k = row.text("in.kind") == "k16" ? row.number("in.par") : 0;
    return {.name = "",
            .sources = {CPlane(), light},
            .ambient = Rgb(0),
            .medium = Medium{.extinction = Rgb(row.number("in.sigma")),
                             .albedo = Rgb(row.number("in.w0")),
                             .ambient = Rgb(row.number("in.Ja")),
                             .phase_k = k}};
}

Segment ray_in(const test::OracleRow& row) {
    const Vec3 eye = row.vector("in.O") * 1000;
    return {eye, eye + row.unit("in.w") * (row.number("in.l") * 1000)};
}

/// The lit intervals that the oracle lists.
IntervalSet lit_in(const test::OracleRow& row) {
    const std::vector<double> ends = row.list("out.lit");
    std::vector<ParameterInterval> lit;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
        lit.push_back({ends[i] / row.number("in.l"), ends[i + 1] / row.number("in.l")});
    return IntervalSet(std::move(lit));
}

} // namespace

TEST(LuminanceAlong, AgreesWithOracle) {
    const test::OracleTable table("light_shaft");
    test::WorstError total("L_total"), scattered("L_scatter");
    for (const auto& row : table) {
        if (row.text("in.leg") != "1" || row.text("in.kind") == "hg") continue;
        const VisibleFrom visible = [&](const Vec3& apex, const Segment&) {
            EXPECT_EQ(apex, row.vector("in.Q") * 1000);
            return row.has("in.spheres") ? lit_in(row) : IntervalSet::whole();
        };
        LightRig rig = rig_in(row);
        const Rgb surface(row.number("in.Ls"));
        total.compare(row, luminance_along(rig, ray_in(row), surface, visible).r,
                      row.number("out.L_total"), 1e-8);
        rig.medium->ambient = Rgb(0);
        scattered.compare(row, luminance_along(rig, ray_in(row), Rgb(0), visible).b,
                          row.number("out.L_scatter"), 1e-8);
    }
}

TEST(LuminanceAlong, BeamIsThatOfTheOracle) {
    const test::OracleTable table("light_shaft");
    test::WorstError worst("lit");
    for (const auto& row : table) {
        if (row.has("in.spheres")) continue;
        const auto light = std::get<Spotlight>(rig_in(row).sources[1]);
        const IntervalSet lit = in_beam(light, ray_in(row)), expected = lit_in(row);
        ASSERT_EQ(lit.size(), expected.size()) << row.id();
        for (std::size_t i = 0; i < lit.size(); ++i) {
            worst.compare(row, lit[i].begin, expected[i].begin, 1e-10);
            worst.compare(row, lit[i].end, expected[i].end, 1e-10);
        }
    }
}

TEST(LuminanceAlong, IsTheSurfaceWithoutAMedium) {
    const LightRig rig{.name = "", .sources = {Spotlight()}, .ambient = Rgb(3), .medium = {}};
    const Rgb surface(1, 2, 3);
    EXPECT_EQ(luminance_along(rig, {Vec3(0), Vec3(1000)}, surface), surface);
}

TEST(LuminanceAlong, ShadowTakesTheShaftAway) {
    LightRig rig{.name = "",
                 .sources = {Spotlight{.position = {0, 0, 1000}, .aim = Vec3(0)}},
                 .ambient = Rgb(0),
                 .medium = Medium{.extinction = Rgb(0.1)}};
    const Segment ray{{-2000, 0, 0}, {2000, 0, 0}};
    const auto hidden = [](const Vec3&, const Segment&) { return IntervalSet(); };
    EXPECT_GT(luminance_along(rig, ray, Rgb(0)).g, 0);
    EXPECT_EQ(luminance_along(rig, ray, Rgb(0), hidden), Rgb());
}
