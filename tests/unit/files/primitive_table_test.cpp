#include "keiko/files/scene/rig_file.h"
#include "keiko/files/scene/scene_file.h"

#include "tests/support/rig_text.h"
#include <gtest/gtest.h>

#include <numbers>

namespace keiko {
namespace {

using std::numbers::pi;
using test::only_light;
using test::rig_error;

const std::string head = "format = \"keiko-rig/1\"\n[[primitive]]\n";
const std::string cylinder =
    head + "kind = \"cylinder\"\nfrom = [0, 0, 1000]\nto = [0, 0, 1400]\nradius = 50\n";
const std::string cone =
    head + "kind = \"cone\"\nfrom = [0, 0, 1000]\nto = [0, 0, 1400]\nradius = 300\n";
const std::string disc =
    head + "kind = \"disc\"\ncenter = [1, 2, 3]\nnormal = [0, -3, 4]\nradius = 70\n";
const std::string ellipsoid =
    head +
    "kind = \"ellipsoid\"\ncenter = [1, 2, 3]\nu = [9, 0, 0]\nv = [0, 7, 0]\nw = [1, 0, 5]\n";

TEST(PrimitiveTable, CylinderIsItsSideAndItsEnds) {
    const LightRig rig = parse_rig(cylinder + "luminance = 4000\ncolor = [1, 0.5, 0]\n", "a.toml");
    ASSERT_EQ(rig.sources.size(), 3U);
    const auto& side = std::get<FrustumLight>(rig.sources[0]);
    EXPECT_EQ(side.to, Vec3(0, 0, 1400));
    EXPECT_EQ(side.to_radius, 50);
    EXPECT_EQ(side.luminance, Rgb(4000, 2000, 0));
    EXPECT_EQ(std::get<DiscLight>(rig.sources[1]).normal, Vec3(0, 0, -1));
    EXPECT_EQ(std::get<DiscLight>(rig.sources[2]).center, Vec3(0, 0, 1400));
    EXPECT_EQ(only_light<FrustumLight>(cylinder + "open = true\n").radius, 50);
    EXPECT_EQ(parse_rig(cone, "a.toml").sources.size(), 2U); // its tip has no end
}

/// A diffuse surface of A m2 and luminance L emits pi L A.
TEST(PrimitiveTable, FluxBecomesTheLuminanceOfTheWholeSurface) {
    const double slant = 500, side = pi * 300 * slant * 1e-6, end = pi * 0.09;
    EXPECT_NEAR(only_light<FrustumLight>(cone + "open = true\nluminous_flux = 100\n").luminance.r,
                100 / (pi * side), 1e-9);
    const LightRig closed = parse_rig(cone + "luminous_flux = 100\n", "a.toml");
    EXPECT_NEAR(std::get<DiscLight>(closed.sources[1]).luminance.r, 100 / (pi * (side + end)),
                1e-9);
    const auto sphere = only_light<SphereLight>(
        head + "kind = \"sphere\"\ncenter = [0, 0, 0]\nradius = 100\nluminous_flux = 100\n");
    EXPECT_NEAR(sphere.luminance.r, 100 / (4 * pi * pi * 0.01), 1e-9);
}

TEST(PrimitiveTable, PlanesAndBoxesArePanels) {
    const std::string edges = "origin = [0, 0, 0]\nu = [2, 0, 0]\nv = [0, 3, 0]\n";
    const auto panel = only_light<PolygonLight>(head + "kind = \"plane\"\n" + edges);
    EXPECT_EQ(panel.normal(), Vec3(0, 0, 1));
    EXPECT_EQ(panel.corners[2], Vec3(2, 3, 0));
    const LightRig box = parse_rig(head + "kind = \"box\"\n" + edges + "w = [0, 0, 4]\n", "a.toml");
    EXPECT_EQ(box.sources.size(), 6U);
}

TEST(PrimitiveTable, WhatIsWrittenReadsBackTheSame) {
    for (const std::string& text :
         {cylinder, cone + "to_radius = 20\nopen = true\n", disc, ellipsoid + "luminance = 7\n"}) {
        const LightRig rig = parse_rig(text, "rig.toml");
        const LightRig again = parse_rig(rig_text(rig, ""), "again.toml");
        EXPECT_EQ(again.sources.size(), rig.sources.size());
        EXPECT_EQ(rig_text(again, ""), rig_text(rig, ""));
    }
    EXPECT_EQ(only_light<DiscLight>(disc).normal, Vec3(0, -0.6, 0.8));
}

TEST(PrimitiveTable, BadPrimitivesAreNamed) {
    EXPECT_EQ(rig_error(head), "bad.toml:2:1: primitive[0]: 'kind' is missing");
    EXPECT_EQ(rig_error(head + "kind = \"disc\"\ncenter = [0, 0, 0]\nnormal = [0, 0, 0]\n"),
              "bad.toml:5:10: primitive[0].normal: must not be a zero vector");
    EXPECT_EQ(rig_error(head + "kind = \"cylinder\"\nfrom = [0, 0, 0]\nto = [0, 0, 0]\n"),
              "bad.toml:5:6: primitive[0].to: must differ from 'from'");
    EXPECT_EQ(rig_error(head + "kind = \"cone\"\nfrom = [0, 0, 0]\nto = [0, 0, 9]\nradius = 0\n"),
              "bad.toml:6:10: primitive[0].radius: radius and to_radius must not both be 0");
    EXPECT_EQ(
        rig_error(head + "kind = \"plane\"\norigin = [0, 0, 0]\nu = [1, 0, 0]\nv = [2, 0, 0]\n"),
        "bad.toml:6:5: primitive[0].v: u and v must not be parallel");
    EXPECT_EQ(rig_error(head + "kind = \"ellipsoid\"\ncenter = [0, 0, 0]\nu = [1, 0, 0]\n"
                               "v = [0, 1, 0]\nw = [1, 1, 0]\n"),
              "bad.toml:7:5: primitive[0].w: u, v and w must not lie in a plane");
    EXPECT_EQ(rig_error(cylinder + "material = \"concrete\"\n"),
              "bad.toml:7:12: primitive[0].material: belongs to scenes: a lamp of a rig has a "
              "luminance");
    EXPECT_EQ(rig_error(cylinder + "luminance = 1\nluminous_flux = 2\n"),
              "bad.toml:8:17: primitive[0].luminous_flux: give either luminance or luminous_flux, "
              "not both");
}

const std::string scene =
    "format = \"keiko-scene/1\"\n[[primitive]]\nkind = \"cylinder\"\n"
    "from = [0, 0, 0]\nto = [0, 0, 400]\nradius = 50\n";

TEST(PrimitiveTable, MaterialMakesABodyOrALampOfAScene) {
    const SceneSpec body = parse_scene(scene + "material = \"concrete\"\nname = \"post\"\n", "a");
    ASSERT_EQ(body.primitives.size(), 1U);
    EXPECT_FALSE(body.rig);
    EXPECT_EQ(body.primitives[0].name, "post");
    EXPECT_EQ(std::get<FrustumShape>(body.primitives[0].shape).to_radius, 50);
    const std::string lit =
        "[[primitive]]\nkind = \"disc\"\ncenter = [0, 0, 9]\nnormal = [0, 0, 1]\n"
        "radius = 50\nmaterial = { diffuse = 0, emits = [7, 8, 9] }\n";
    const SceneSpec both = parse_scene(scene + "material = \"concrete\"\n" + lit, "a");
    EXPECT_EQ(both.primitives.size(), 1U);
    ASSERT_TRUE(both.rig);
    EXPECT_EQ(std::get<DiscLight>(both.rig->sources.at(0)).luminance, Rgb(7, 8, 9));
}

TEST(PrimitiveTable, BadPrimitivesOfAScene) {
    const auto error = [](const std::string& text) {
        try {
            parse_scene(text, "bad.toml");
        } catch (const Error& refused) {
            return std::string(refused.what());
        }
        return std::string();
    };
    EXPECT_EQ(error(scene),
              "bad.toml:1:1: the scene has no body: neither a [[model]] nor a [[primitive]] that "
              "is one nor a [[polygon]] with a map");
    EXPECT_EQ(error(scene + "material = \"concrete\"\nluminance = 5\n"),
              "bad.toml:7:12: primitive[0].material: give either a material, which may emit, or a "
              "luminance");
    EXPECT_EQ(error(scene + "material = { diffuse = 0, emits = -1 }\n").substr(0, 15),
              "bad.toml:7:35: ");
}

} // namespace
} // namespace keiko
