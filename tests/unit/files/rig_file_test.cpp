#include "keiko/files/scene/rig_file.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/files/toml/toml_reader.h"

#include "tests/support/paths.h"
#include "tests/support/rig_text.h"
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

namespace keiko {
namespace {

using test::rig_error;
namespace fs = std::filesystem;

const std::string head = "format = \"keiko-rig/1\"\n";
const std::string plane = "[[c_plane]]\norigin = [0, 0, 2000]\nu = [1000, 0, 0]\n";
const std::string whole_plane = plane + "v = [0, 1200, 0]\n";
const std::string spot = "[[spotlight]]\nposition = [0, 0, 4000]\naim = [0, 0, 0]\n";

CPlane only_plane(const std::string& text) {
    return std::get<CPlane>(parse_rig(text, "rig.toml").sources.at(0));
}

TEST(RigFile, ReadsTheExampleOfTheDesign) {
    const LightRig rig = parse_rig(head + R"(name = "demo"
ambient = 20
[[spotlight]]
position = [0, 0, 4000]
aim = [0, 0, 0]
half_angle = 25
edge = "mixed"
q = 0.25
intensity = 5000
color = [1, 0.9, 0.8]
[[c_plane]]
origin = [-1500, -1000, 2500]
u = [0, 2000, 0]
v = [3000, 0, 0]
lamps = 10
pitch = 250
diameter = 38
luminance = 8000
color = [1, 1, 0.5]
[[spotlight]]
position = [1, 2, 3]
aim = [0, 0, 0]
[fog]
extinction = 0.02
albedo = [0.9, 0.8, 0.7]
phase = { kind = "fog", k = 8 }
ambient = [0.5, 0.5, 0.55]
)",
                                   "demo.toml");
    EXPECT_EQ(rig.name, "demo");
    EXPECT_EQ(rig.ambient, Rgb(20));
    ASSERT_EQ(rig.sources.size(), 3u);
    const auto& first = std::get<Spotlight>(rig.sources[0]); // in the order of the file
    EXPECT_EQ(first.position, Vec3(0, 0, 4000));
    EXPECT_EQ(first.half_angle, 25);
    EXPECT_EQ(std::get<EdgeProfile>(first.profile), (EdgeProfile{BeamEdge::mixed, 0.25}));
    EXPECT_EQ(first.intensity, Rgb(1, 0.9, 0.8) * 5000.0);
    const auto& lamps = std::get<CPlane>(rig.sources[1]);
    EXPECT_EQ(lamps.origin, Vec3(-1500, -1000, 2500));
    EXPECT_EQ(lamps.u, Vec3(0, 2000, 0));
    EXPECT_EQ(lamps.v, Vec3(3000, 0, 0));
    EXPECT_EQ(lamps.lamps, 10);
    EXPECT_EQ(lamps.spacing(), 250);
    EXPECT_EQ(lamps.diameter, 38);
    EXPECT_EQ(lamps.luminance, Rgb(8000, 8000, 4000));
    EXPECT_EQ(std::get<Spotlight>(rig.sources[2]).position, Vec3(1, 2, 3));
    EXPECT_EQ(rig.medium.value().extinction, Rgb(0.02));
    EXPECT_EQ(rig.medium->albedo, Rgb(0.9, 0.8, 0.7));
    EXPECT_EQ(rig.medium->phase, PhaseFunction(HazePhase{8}));
    EXPECT_EQ(rig.medium->ambient, Rgb(0.5, 0.5, 0.55));
}

TEST(RigFile, DefaultsAreThoseOfTheStructs) {
    const CPlane read = only_plane(head + whole_plane);
    EXPECT_EQ(read.lamps, CPlane{}.lamps);
    EXPECT_EQ(read.pitch, 0);
    EXPECT_EQ(read.spacing(), 100);
    EXPECT_EQ(read.diameter, CPlane{}.diameter);
    EXPECT_EQ(read.luminance, CPlane{}.luminance);
}

TEST(RigFile, LuminousFluxBecomesLuminance) {
    const CPlane read = only_plane(head + whole_plane + "luminous_flux = 3350\n");
    const double pi = std::numbers::pi;
    // M = flux / lateral area, L = M / pi; 1 m long, 26 mm thick.
    EXPECT_NEAR(read.luminance.g, 3350 / (pi * 0.026 * 1.0) / pi, 1e-8);
}

TEST(RigFile, VIsMadeOrthogonalToU) {
    const CPlane read = only_plane(head + plane + "v = [300, 1200, 0]\n");
    EXPECT_LT((read.v - Vec3(0, 1200, 0)).length(), 1e-9);
}

TEST(RigFile, AWrittenRigReadsBackBitForBit) {
    LightRig rig;
    rig.name = "a \"quoted\" \\ name\nof\x7f 蛍光灯";
    rig.ambient = {0.1, 1.0 / 3, 1e-300};
    CPlane skew;
    skew.origin = {-0.0, 1e9, 900719925.4740993};
    skew.u = Vec3(1, 2, 3).normalized() * 1234.5678901234567;
    skew.v = skew.u.cross(Vec3(0.3, -0.1, 0.7)).normalized() * std::sqrt(2e6);
    skew.lamps = 7;
    skew.pitch = 200.0 / 3;
    skew.luminance = {9000.1, 8000, 7000};
    rig.sources = {
        Spotlight{.position = {1, 2, 3}, .profile = EdgeProfile{BeamEdge::mixed, 0.3}}, skew,
        Spotlight{.position = {0.1, 0, 0}, .profile = EdgeProfile{BeamEdge::sharp}}, CPlane{}};
    rig.medium =
        Medium{.extinction = {0.1, 0.2, 0.7}, .ambient = Rgb(0.2), .phase = HazePhase{8.1}};

    const LightRig back = parse_rig(rig_text(rig), "back.toml");
    EXPECT_EQ(back.name, rig.name);
    EXPECT_EQ(back.ambient, rig.ambient);
    ASSERT_EQ(back.sources.size(), 4u);
    const auto& plane_back = std::get<CPlane>(back.sources[1]);
    EXPECT_EQ(plane_back.origin, skew.origin);
    EXPECT_TRUE(std::signbit(plane_back.origin.x));
    EXPECT_EQ(plane_back.u, skew.u);
    EXPECT_EQ(plane_back.v, skew.v);
    EXPECT_EQ(plane_back.pitch, skew.pitch);
    EXPECT_EQ(plane_back.luminance, skew.luminance);
    EXPECT_EQ(std::get<Spotlight>(back.sources[0]).profile,
              std::get<Spotlight>(rig.sources[0]).profile);
    EXPECT_EQ(std::get<Spotlight>(back.sources[2]).position.x, 0.1);
    EXPECT_EQ(back.medium->extinction, rig.medium->extinction);
    EXPECT_EQ(back.medium->phase, PhaseFunction(HazePhase{8.1}));
    EXPECT_EQ(rig_text(back), rig_text(rig));
}

TEST(RigFile, RefusesToWriteWhatCannotBeRead) {
    LightRig rig;
    rig.sources = {CPlane{.diameter = std::nan("")}};
    EXPECT_THROW(rig_text(rig), Error);
}

TEST(RigFile, WritesAFileThatReadsBack) {
    const fs::path path = fs::path(testing::TempDir()) / "keiko-written-rig.toml";
    write_rig(path, {"written", {CPlane{}}, {}, Rgb(0), {}});
    EXPECT_EQ(read_rig(path).name, "written");
    EXPECT_NE(read_file(path).find("# cd/m2"), std::string::npos);
    fs::remove(path);
}

TEST(RigFile, AMisspeltKeyIsNamedWithItsPlace) {
    EXPECT_EQ(rig_error(head + whole_plane + "lamps = 12\n  ptich = 90\n"),
              "bad.toml:7:3: unknown key 'c_plane[0].ptich' (did you mean 'pitch'?)");
    EXPECT_EQ(rig_error(head + "nmae = \"x\"\n" + whole_plane),
              "bad.toml:2:1: unknown key 'nmae' (did you mean 'name'?)");
    EXPECT_EQ(rig_error(head + whole_plane + "[fgo]\nextinction = 1\n"),
              "bad.toml:6:2: unknown key 'fgo' (did you mean 'fog'?)");
}

TEST(RigFile, ARequiredKeyThatIsMisspeltIsNamedRatherThanMissing) {
    EXPECT_EQ(rig_error("formt = \"keiko-rig/1\"\n" + whole_plane),
              "bad.toml:1:1: unknown key 'formt' (did you mean 'format'?)");
    EXPECT_EQ(rig_error(head + "[[c_plane]]\norigni = [0, 0, 0]\nu = [1, 0, 0]\nv = [0, 1, 0]\n"),
              "bad.toml:3:1: unknown key 'c_plane[0].origni' (did you mean 'origin'?)");
    EXPECT_EQ(rig_error(head + "[snu]\n[[window]]\n"),
              "bad.toml:2:2: unknown key 'snu' (did you mean 'sun'?)");
    EXPECT_EQ(rig_error(head + "[fog]\nextinction = 1\nlayer = { height = 1, extinction_above = 0, "
                               "bump = \"waves\", wave = [] }\n"),
              "bad.toml:4:61: unknown key 'fog.layer.wave' (did you mean 'waves'?)");
    // Another required key of the table is no misspelling of the one that is missing.
    EXPECT_EQ(rig_error(head + "[[c_plane]]\norigin = [0, 0, 0]\nv = [0, 1, 0]\n"),
              "bad.toml:2:1: c_plane[0]: 'u' is missing");
}

TEST(RigFile, AWrongValueIsNamedWithItsPlace) {
    EXPECT_EQ(rig_error(head + whole_plane + "pitch = 0\n"),
              "bad.toml:6:9: c_plane[0].pitch: must be at least 1e-06 and at most 1e+09, is 0");
    EXPECT_EQ(rig_error(head + whole_plane + "pitch = \"wide\"\n"),
              "bad.toml:6:9: c_plane[0].pitch: must be a number");
    EXPECT_EQ(rig_error(head + whole_plane + "diameter = inf\n"),
              "bad.toml:6:12: c_plane[0].diameter: must be a finite number");
    EXPECT_EQ(
        rig_error(head + whole_plane + "diameter = -1\n"),
        "bad.toml:6:12: c_plane[0].diameter: must be at least 1e-06 and at most 1e+09, is -1");
    EXPECT_EQ(rig_error(head + whole_plane + "lamps = 0\n"),
              "bad.toml:6:9: c_plane[0].lamps: must be at least 1 and at most 1000, is 0");
    EXPECT_EQ(rig_error(head + whole_plane + "lamps = 2.5\n"),
              "bad.toml:6:9: c_plane[0].lamps: must be a whole number");
    EXPECT_EQ(rig_error(head + whole_plane + "lamps = 1e9\n"),
              "bad.toml:6:9: c_plane[0].lamps: must be at least 1 and at most 1000, is 1e+09");
    EXPECT_EQ(rig_error(head + whole_plane + "lamps = \"5\"\n"),
              "bad.toml:6:9: c_plane[0].lamps: must be a whole number");
    EXPECT_EQ(only_plane(head + whole_plane + "lamps = 1e1\n").lamps, 10);
    EXPECT_EQ(rig_error(head + whole_plane + "color = [1, 2]\n"),
              "bad.toml:6:9: c_plane[0].color: must be an array of 3 numbers");
    EXPECT_EQ(rig_error(head + plane + "v = [0, nan, 0]\n"),
              "bad.toml:5:5: c_plane[0].v: must be a finite number");
    EXPECT_EQ(rig_error(head + plane + "v = [0, 0, 0]\n"),
              "bad.toml:5:5: c_plane[0].v: must not be a zero vector");
    EXPECT_EQ(rig_error(head + plane + "v = [2, 0, 0]\n"),
              "bad.toml:5:5: c_plane[0].v: must not be parallel to u");
    EXPECT_EQ(rig_error(head + "[[c_plane]]\norigin = [0, 0, 0]\nu = [0, 0, 0]\nv = [1, 0, 0]\n"),
              "bad.toml:4:5: c_plane[0].u: must not be a zero vector");
}

TEST(RigFile, WhatIsMissingOrContradictsIsNamed) {
    EXPECT_EQ(rig_error(head + plane), "bad.toml:2:1: c_plane[0]: 'v' is missing");
    EXPECT_EQ(rig_error(head + whole_plane + "luminance = 1\nluminous_flux = 2\n"),
              "bad.toml:7:17: c_plane[0].luminous_flux: give either luminance or luminous_flux, "
              "not both");
    EXPECT_EQ(rig_error(head + whole_plane + "diameter = 120\n"),
              "bad.toml:2:1: c_plane[0].lamps: lamps of diameter 120 mm overlap at a pitch of "
              "100 mm");
    EXPECT_EQ(rig_error(head + whole_plane + "pitch = 200\n"),
              "bad.toml:2:1: c_plane[0].lamps: 12 lamps need 2226 mm, but v is 1200 mm long");
    EXPECT_EQ(rig_error(head + spot + "q = 0.5\n"),
              "bad.toml:5:5: spotlight[0].q: belongs to edge = \"mixed\" alone");
    EXPECT_EQ(rig_error(head + "[[spotlight]]\nposition = [1, 1, 1]\naim = [1, 1, 1]\n"),
              "bad.toml:4:7: spotlight[0].aim: must differ from position");
    EXPECT_EQ(rig_error(head + spot + "edge = \"sfot\"\n"),
              "bad.toml:5:8: spotlight[0].edge: 'sfot' is none of sharp, soft, mixed, power, "
              "polynomial, table (did you mean 'soft'?)");
    EXPECT_EQ(rig_error(head),
              "bad.toml:1:1: the rig has no light: neither [[c_plane]] nor [[spotlight]] "
              "nor [[luminaire]] nor [[polygon]] nor [[sphere]] nor [[box]] nor [[primitive]] nor "
              "[[sign]] nor "
              "[[point]] nor [[line]] "
              "nor [sun] nor [sky]");
}

TEST(RigFile, WhatIsNotSupportedYetSaysSo) {
    EXPECT_EQ(rig_error(head + whole_plane + "reflector = 3\n"),
              "bad.toml:6:13: c_plane[0].reflector: is not supported yet");
}

TEST(RigFile, AForeignOrBrokenFileIsRefused) {
    EXPECT_EQ(
        rig_error("format = \"keiko-scene/1\"\n"),
        "bad.toml:1:10: format: is 'keiko-scene/1', a scene: inspect, check, render and trace take "
        "it, as FILE.toml; expected format = \"keiko-rig/1\"");
    EXPECT_EQ(rig_error(whole_plane),
              "bad.toml:1:1: the file must begin with format = \"keiko-rig/1\"");
    EXPECT_TRUE(rig_error(head + "name = \n").starts_with("bad.toml:2:")) << rig_error("name =");
    EXPECT_TRUE(rig_error(head + "name = 1\nname = 2\n").starts_with("bad.toml:3:"));
    EXPECT_THROW(read_rig("no-such-rig.toml"), Error);
}

TEST(RigFile, NamesWhatLampsAreTakenFor) {
    EXPECT_EQ(only_plane(head + whole_plane).diffuse, TubeModel::automatic);
    const CPlane paper = only_plane(head + whole_plane + "fidelity = \"paper\"\n");
    EXPECT_EQ(paper.diffuse, TubeModel::nishita);
    EXPECT_EQ(paper.mirror, MirrorModel::flat);
    const CPlane mixed =
        only_plane(head + whole_plane + "fidelity = \"exact\"\ndiffuse = \"line\"\n");
    EXPECT_EQ(mixed.diffuse, TubeModel::line);
    EXPECT_EQ(mixed.mirror, MirrorModel::exact);
    EXPECT_EQ(rig_error(head + whole_plane + "diffuse = \"stripe\"\n"),
              "bad.toml:6:11: c_plane[0].diffuse: 'stripe' is none of automatic, strip, cylinder, "
              "rectangle, line, nishita (did you mean 'strip'?)");
}

TEST(RigFile, LuminousCapsShareTheFlux) {
    const std::string lamp = whole_plane + "luminous_flux = 3350\n";
    const CPlane dark = only_plane(head + lamp);
    const CPlane lit = only_plane(head + lamp + "caps = \"luminous\"\n");
    EXPECT_FALSE(dark.luminous_caps);
    EXPECT_TRUE(lit.luminous_caps);
    EXPECT_NEAR(dark.luminance.g / lit.luminance.g, 1 + 26.0 / 2000, 1e-12);
}

TEST(RigFile, WrittenLampsKeepTheirCapsAndModels) {
    for (const auto model : {TubeModel::automatic, TubeModel::strip, TubeModel::cylinder,
                             TubeModel::rectangle, TubeModel::line, TubeModel::nishita}) {
        for (const auto look : {MirrorModel::tube, MirrorModel::flat, MirrorModel::exact}) {
            LightRig rig;
            rig.sources = {CPlane{.luminous_caps = true, .diffuse = model, .mirror = look}};
            const CPlane back = only_plane(rig_text(rig));
            EXPECT_TRUE(back.luminous_caps);
            EXPECT_EQ(back.diffuse, model);
            EXPECT_EQ(back.mirror, look);
        }
    }
}

TEST(RigFile, ReadsAndWritesTheSun) {
    const std::string text =
        head + "[sun]\ndirection = [1, 0, -2]\nilluminance = 60000\ncolor = [1, 0.9, 0.8]\n";
    const LightRig rig = parse_rig(text, "rig.toml");
    const Sun& sun = std::get<Sun>(rig.sources.at(0));
    EXPECT_EQ(sun.direction, Vec3(1, 0, -2));
    EXPECT_EQ(sun.illuminance, Rgb(60000, 54000, 48000));
    const LightRig back = parse_rig(rig_text(rig), "rig.toml");
    EXPECT_EQ(std::get<Sun>(back.sources.at(0)).illuminance, sun.illuminance);
    EXPECT_EQ(rig_error(head + "[sun]\nilluminance = 1\n"),
              "bad.toml:2:1: sun: 'direction' is missing");
    EXPECT_EQ(rig_error(head + "[sun]\ndirection = [0, 0, 0]\nilluminance = 1\n"),
              "bad.toml:3:13: sun.direction: must not be a zero vector");
    LightRig two = rig;
    two.sources.emplace_back(Sun());
    EXPECT_THROW(rig_text(two), Error);
}

} // namespace
} // namespace keiko
