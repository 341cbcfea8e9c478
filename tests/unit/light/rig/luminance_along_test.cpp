#include "keiko/light/rig/luminance_along.h"

#include "keiko/base/units.h"
#include "keiko/light/fog/transmittance.h"
#include "keiko/light/spotlight/point_light.h"
#include "keiko/light/spotlight/spotlight.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <numbers>

using namespace keiko;

namespace {

PhaseFunction phase_in(const test::OracleRow& row) {
    if (row.text("in.kind") == "hg") return HenyeyGreenstein{row.number("in.par")};
    return HazePhase{row.text("in.kind") == "k16" ? row.number("in.par") : 0};
}

Spotlight light_in(const test::OracleRow& row) {
    const std::string base = row.text("in.base");
    const BeamEdge edge = base == "sharp"  ? BeamEdge::sharp
                          : base == "soft" ? BeamEdge::soft
                                           : BeamEdge::mixed;
    const double q = edge == BeamEdge::mixed ? row.number("in.qmix") : 0;
    return {.position = row.vector("in.Q") * 1000,
            .aim = row.vector("in.C") * 1000,
            .half_angle = row.number("in.gamma_deg"),
            .profile = EdgeProfile{edge, q},
            .intensity = Rgb(row.number("in.I0"))};
}

LightRig rig_in(const test::OracleRow& row) {
    return {.name = "",
            .sources = {CPlane(), light_in(row)},
            .ambient = Rgb(0),
            .medium = Medium{.extinction = Rgb(row.number("in.sigma")),
                             .albedo = Rgb(row.number("in.w0")),
                             .ambient = Rgb(row.number("in.Ja")),
                             .phase = phase_in(row),
                             .dims_light_leg = row.text("in.leg") == "1"}};
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

/// The lit intervals that the oracle lists, along a part of the ray.
IntervalSet lit_of_part(const test::OracleRow& row, const Segment& part) {
    const Segment ray = ray_in(row);
    const double length = (ray.b - ray.a).length();
    const double begin = (part.a - ray.a).length() / length;
    const double end = (part.b - ray.a).length() / length;
    std::vector<ParameterInterval> lit;
    for (const ParameterInterval& piece : lit_in(row).intersect(IntervalSet::whole(begin, end)))
        lit.push_back({(piece.begin - begin) / (end - begin), (piece.end - begin) / (end - begin)});
    return IntervalSet(std::move(lit));
}

} // namespace

TEST(LuminanceAlong, AgreesWithOracle) {
    const test::OracleTable table("light_shaft");
    test::WorstError total("L_total"), scattered("L_scatter"), picture("L_scatter of pictures");
    for (const auto& row : table) {
        const VisibleFrom visible = [&](std::size_t source, const Segment& part) {
            EXPECT_EQ(source, 1u);
            return row.has("in.spheres") ? lit_of_part(row, part) : IntervalSet::whole();
        };
        LightRig rig = rig_in(row);
        const Rgb surface(row.number("in.Ls"));
        total.compare(row, luminance_along(rig, ray_in(row), surface, visible).r,
                      row.number("out.L_total"), 1e-8);
        rig.medium->ambient = Rgb(0);
        scattered.compare(row, luminance_along(rig, ray_in(row), Rgb(0), visible).b,
                          row.number("out.L_scatter"), 1e-8);
        picture.compare(
            row, luminance_along(rig, ray_in(row), Rgb(0), visible, picture_scattering_tolerance).b,
            row.number("out.L_scatter"), 1e-4);
    }
}

TEST(LuminanceAlong, ThroughLayersAgreesWithOracle) {
    const test::OracleTable table("light_shaft_layered");
    test::WorstError total("L_total"), scattered("L_scatter"), depth("tau_total"), lit("E_ratio");
    for (const auto& row : table) {
        const double turn = 2 * std::numbers::pi;
        const Wave wave{
            row.number("in.amp") * 1000,
            {turn * 1000 / row.number("in.kx"), turn * 1000 / row.number("in.ky")},
            {radians_to_degrees(row.number("in.px")), radians_to_degrees(row.number("in.py"))}};
        HeightField border{.height = row.number("in.z0") * 1000};
        if (wave.amplitude != 0) border.waves = {wave};
        LightRig rig{
            .name = "",
            .sources = {light_in(row)},
            .ambient = Rgb(0),
            .medium = Medium{.extinction = Rgb(row.number("in.sig_lo")),
                             .albedo = Rgb(row.number("in.w0")),
                             .ambient = Rgb(row.number("in.Ja")),
                             .phase = phase_in(row),
                             .density = LayeredDensity{border, Rgb(row.number("in.sig_up"))},
                             .dims_light_leg = row.text("in.leg") == "1"}};
        const Segment ray = ray_in(row);
        depth.compare(row, optical_depth(*rig.medium, ray).g, row.number("out.tau_total"), 1e-10);
        lit.compare(row, transmittance(*rig.medium, {row.vector("in.Q") * 1000, ray.b}).g,
                    row.number("out.E_ratio"), 1e-10);
        total.compare(row, luminance_along(rig, ray, Rgb(row.number("in.Ls"))).g,
                      row.number("out.L_total"), 1e-6);
        rig.medium->ambient = Rgb(0);
        scattered.compare(row, luminance_along(rig, ray, Rgb(0)).g, row.number("out.L_scatter"),
                          1e-6);
    }
}

TEST(LuminanceAlong, ThroughVoxelsAgreesWithOracle) {
    const test::OracleTable table("light_shaft_grid");
    test::WorstError scattered("L_scatter"), depth("tau_total");
    for (const auto& row : table) {
        const std::array nodes{row.integer("in.nx"), row.integer("in.ny"), row.integer("in.nz")};
        const auto grid = std::make_shared<const VoxelDensity>(
            row.vector("in.lo") * 1000, row.vector("in.hi") * 1000, nodes, row.list("in.dens"));
        const LightRig rig{.name = "",
                           .sources = {light_in(row)},
                           .ambient = Rgb(0),
                           .medium = Medium{.extinction = Rgb(row.number("in.sscale")),
                                            .albedo = Rgb(row.number("in.w0")),
                                            .phase = phase_in(row),
                                            .density = GridDensity{grid},
                                            .dims_light_leg = row.text("in.leg") == "1"}};
        const Segment ray = ray_in(row);
        depth.compare(row, optical_depth(*rig.medium, ray).g, row.number("out.tau_total"), 1e-11);
        scattered.compare(row, luminance_along(rig, ray, Rgb(0)).g, row.number("out.L_scatter"),
                          1e-6);
    }
}

TEST(LuminanceAlong, BeamIsThatOfTheOracle) {
    for (const std::string name : {"light_shaft", "light_shaft_layered", "light_shaft_grid"}) {
        const test::OracleTable table(name);
        test::WorstError worst("lit of " + name);
        for (const auto& row : table) {
            if (name == "light_shaft" && row.has("in.spheres")) continue;
            const IntervalSet lit = in_beam(light_in(row), ray_in(row)), expected = lit_in(row);
            ASSERT_EQ(lit.size(), expected.size()) << row.id();
            for (std::size_t i = 0; i < lit.size(); ++i) {
                worst.compare(row, lit[i].begin, expected[i].begin, 1e-10);
                worst.compare(row, lit[i].end, expected[i].end, 1e-10);
            }
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
    const auto hidden = [](std::size_t, const Segment&) { return IntervalSet(); };
    EXPECT_GT(luminance_along(rig, ray, Rgb(0)).g, 0);
    EXPECT_EQ(luminance_along(rig, ray, Rgb(0), hidden), Rgb());
}

TEST(LuminanceAlong, ShaftsWithPatternsAreWhatFineSamplingSees) {
    // Dots, petals and hues against the midpoint rule with 200 000 places.
    const Spotlight plain{.position = {0, 0, 4000}, .aim = Vec3(0), .half_angle = 25};
    Spotlight dots = plain, petals = plain, hue = plain, rounded = plain;
    dots.pattern = Dots{.dphi = 30, .dtheta = 4, .q_phi = -0.5, .q_theta = -0.5};
    rounded.pattern = Dots{.dphi = 45, .dtheta = 6, .reading = DotReading::rounded};
    petals.pattern = Petals{.count = 8, .q = -0.4};
    petals.spin = 17;
    hue.hue = true;
    const Segment ray{{-3000, -200, 900}, {3000, 400, 300}};
    const double length = (ray.b - ray.a).length();
    for (const Spotlight& light : {dots, petals, hue, rounded}) {
        const LightRig rig{.name = "",
                           .sources = {light},
                           .ambient = Rgb(0),
                           .medium = Medium{.extinction = Rgb(0.1)}};
        Rgb sum;
        const int count = 200000;
        for (int i = 0; i < count; ++i) {
            const Vec3 p = ray.at((i + 0.5) / count);
            const double r = (p - light.position).length(), s = (p - ray.a).length();
            sum += intensity_towards(light, p) *
                   (0.1 * 0.9 / (4 * std::numbers::pi) * std::exp(-0.1 * (r + s) / 1000) /
                    (r * r / 1e6) * (length / 1000 / count));
        }
        const Rgb found = luminance_along(rig, ray, Rgb(0));
        EXPECT_NEAR(found.r, sum.r, 1e-6 * sum.r);
        EXPECT_NEAR(found.b, sum.b, 1e-6 * sum.b);
        const Rgb picture = luminance_along(rig, ray, Rgb(0), {}, picture_scattering_tolerance);
        EXPECT_NEAR(picture.g, sum.g, 1e-4 * sum.g);
    }
}

TEST(LuminanceAlong, PicturesOfBumpyLayersAreNearTheNumbers) {
    const HeightField border{.height = 400, .waves = noise_waves(170, 1900)};
    const LightRig rig{
        .name = "",
        .sources = {Spotlight{.position = {1000, 2500, 3000}, .aim = Vec3(0)}},
        .ambient = Rgb(0),
        .medium = Medium{.extinction = Rgb(0.8), .density = LayeredDensity{border, Rgb(0.02)}}};
    for (int i = 0; i < 12; ++i) {
        const Segment ray{{-4000, -300, 1500}, {3000, 200.0 * i - 1000, 90.0 * i - 100}};
        const double exact = luminance_along(rig, ray, Rgb(0)).g;
        EXPECT_GT(exact, 0);
        const double shown = luminance_along(rig, ray, Rgb(0), {}, picture_scattering_tolerance).g;
        EXPECT_NEAR(shown, exact, 1e-4 * exact) << i;
    }
}
