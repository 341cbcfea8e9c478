#include "keiko/base/error.h"
#include "keiko/files/scene/rig_file.h"
#include "keiko/files/scene/scene_file.h"
#include "keiko/math/polygon.h"

#include "tests/support/rig_text.h"
#include <gtest/gtest.h>

#include <numbers>

namespace keiko {
namespace {

using test::only_light;
using test::rig_error;

const std::string head = "format = \"keiko-rig/1\"\n";
const std::string panel =
    head +
    "[[polygon]]\ncorners = [[0, 0, 2000], [0, 500, 2000], [1000, 500, 2000], [1000, 0, 2000]]\n";
const std::string globe = head + "[[sphere]]\ncenter = [1, 2, 3]\nradius = 150\n";

TEST(AreaTables, PanelIsRead) {
    const auto light = only_light<PolygonLight>(panel + "luminance = 4000\ncolor = [1, 0.5, 0]\n");
    EXPECT_EQ(light.corners.size(), 4U);
    EXPECT_EQ(light.corners[1], Vec3(0, 500, 2000));
    EXPECT_EQ(light.normal(), Vec3(0, 0, -1)); // shines down
    EXPECT_EQ(light.luminance, Rgb(4000, 2000, 0));
    EXPECT_FALSE(light.two_sided);
}

/// A diffuse surface of A m2 and luminance L emits pi L A.
TEST(AreaTables, FluxBecomesTheLuminanceOfTheWholeSurface) {
    const auto one = only_light<PolygonLight>(panel + "luminous_flux = 1000\n");
    EXPECT_NEAR(one.luminance.r, 1000 / (std::numbers::pi * 0.5), 1e-9);
    const auto both = only_light<PolygonLight>(panel + "luminous_flux = 1000\ntwo_sided = true\n");
    EXPECT_NEAR(both.luminance.r, one.luminance.r / 2, 1e-9);
    const auto sphere = only_light<SphereLight>(globe + "luminous_flux = 1000\n");
    EXPECT_NEAR(sphere.luminance.r, 1000 / (4 * std::numbers::pi * std::numbers::pi * 0.15 * 0.15),
                1e-9);
}

TEST(AreaTables, SourcesKeepTheOrderOfTheFile) {
    const LightRig rig = parse_rig(globe + panel.substr(head.size()), "rig.toml");
    ASSERT_EQ(rig.sources.size(), 2U);
    EXPECT_TRUE(std::holds_alternative<SphereLight>(rig.sources[0]));
    EXPECT_TRUE(std::holds_alternative<PolygonLight>(rig.sources[1]));
}

TEST(AreaTables, WhatIsWrittenReadsBackTheSame) {
    for (const std::string& text : {panel + "luminance = [0.1, 0.7, 3e4]\ntwo_sided = true\n",
                                    globe + "luminous_flux = 333\n"}) {
        const LightRig rig = parse_rig(text, "rig.toml");
        const LightRig again = parse_rig(rig_text(rig, ""), "again.toml");
        if (const auto* light = std::get_if<PolygonLight>(&rig.sources[0]))
            EXPECT_EQ(std::get<PolygonLight>(again.sources.at(0)), *light);
        else
            EXPECT_EQ(std::get<SphereLight>(again.sources.at(0)),
                      std::get<SphereLight>(rig.sources[0]));
    }
}

TEST(AreaTables, BadPanelsAreNamed) {
    const std::string corners = head + "[[polygon]]\ncorners = ";
    const std::string at = "bad.toml:3:11: polygon[0].corners: ";
    EXPECT_EQ(rig_error(head + "[[polygon]]\n"), "bad.toml:2:1: polygon[0]: 'corners' is missing");
    EXPECT_EQ(rig_error(corners + "[[0, 0, 0], [1, 0, 0]]\n"), at + "must be at least 3 corners");
    EXPECT_EQ(rig_error(corners + "[[0, 0, 0], [1, 0], [1, 1, 0]]\n"),
              at + "must be arrays of 3 numbers, corner 2 is not");
    EXPECT_EQ(rig_error(corners + "[[0, 0, 0], [1, 0, 0], [1, nan, 0]]\n"),
              at + "must be a finite number (number 2 of array 3)");
    EXPECT_EQ(rig_error(corners + "[[0, 0, 0], [1, 0, 1e30], [1, 1, 0]]\n"),
              at + "must be at least -1e+09 and at most 1e+09, is 1e+30 (number 3 of array 2)");
    EXPECT_EQ(rig_error(corners + "[[0, 0, 0], [1, 0, 0], [2, 0, 0]]\n"),
              at + "enclose no area: they lie on a line, or sides cross");
    EXPECT_EQ(rig_error(corners + "[[0, 0, 0], [1, 0, 0], [1, 1, 0.1], [0, 1, 0]]\n"),
              at + "must lie in a plane");
    EXPECT_EQ(rig_error(corners + "[[0, 0, 0], [4, 0, 0], [1, 3, 0], [4, 2, 0]]\n"),
              at + "sides 2 and 4 cross each other");
    EXPECT_EQ(rig_error(corners + "[[0, 0, 0], [4, 0, 0], [4, 3, 0], [2, 0, 0], [0, 3, 0]]\n"),
              at + "corner 4 lies on side 1");
    EXPECT_EQ(rig_error(corners + "[[0, 0, 0], [4, 0, 0], [4, 4, 0], [2, 2, 0], [0, 4, 0], "
                                  "[2, 2, 0]]\n"),
              at + "corners 4 and 6 coincide");
    EXPECT_EQ(rig_error(corners + "[[0, 0, 0], [4, 0, 0], [4, 6, 0], [4, 4, 0], [0, 4, 0]]\n"),
              at + "corner 4 lies on side 2"); // a spike
    EXPECT_EQ(rig_error(panel + "luminance = 1\nluminous_flux = 1\n"),
              "bad.toml:5:17: polygon[0].luminous_flux: give either luminance or luminous_flux, "
              "not both");
    EXPECT_TRUE(rig_error(panel + "luminance = -1\n").starts_with("bad.toml:4:13: "))
        << rig_error(panel + "luminance = -1\n");
    EXPECT_TRUE(rig_error(panel + "sides = 2\n").starts_with("bad.toml:4:1: "))
        << rig_error(panel + "sides = 2\n");
    std::string many;
    for (int i = 0; i <= 1000; ++i) many += "[" + std::to_string(i) + ", 0, 0], ";
    EXPECT_EQ(rig_error(corners + "[" + many + "]\n"), at + "must be at most 1000 corners");
}

/// A panel with maps is a body of a scene, and no light of its rig.
TEST(AreaTables, MapMakesABodyOfAPanel) {
    const std::string map = "[[polygon.map]]\ntexture = { kind = \"checker\" }\nlow = 0.2\n";
    const std::string own = panel.substr(head.size());
    const SceneSpec scene = parse_scene("format = \"keiko-scene/1\"\n" + own + own +
                                            "luminance = [1, 2, 3]\ntwo_sided = true\n" + map,
                                        "a");
    ASSERT_TRUE(scene.rig);
    EXPECT_EQ(scene.rig->sources.size(), 1U);
    ASSERT_EQ(scene.primitives.size(), 1U);
    const PrimitiveSpec& body = scene.primitives[0];
    EXPECT_EQ(body.name, "polygon.1");
    EXPECT_EQ(std::get<PolygonShape>(body.shape).corners,
              std::get<PolygonLight>(scene.rig->sources[0]).corners);
    EXPECT_EQ(body.material.emits, Rgb(1, 2, 3));
    EXPECT_TRUE(body.material.emits_both_ways);
    ASSERT_EQ(body.material.maps.size(), 1U);
    EXPECT_EQ(body.material.maps[0].drives, MappedQuantity::emission);
    EXPECT_EQ(body.material.maps[0].low, Rgb(0.2));
    EXPECT_EQ(rig_error(panel + map),
              "bad.toml:4:1: polygon[0].map: belongs to scenes: a panel of a rig is alike all "
              "over");
}

/// Six panels that shine outwards, whichever way the edges turn.
TEST(AreaTables, BoxIsItsFaces) {
    const std::string box = head + "[[box]]\norigin = [1, 2, 3]\nu = [10, 0, 0]\n";
    for (const std::string edges :
         {"v = [0, 20, 0]\nw = [3, 0, 40]\n", "w = [0, 20, 0]\nv = [3, 0, 40]\n"}) {
        const LightRig rig = parse_rig(box + edges + "luminance = 7\n", "rig.toml");
        const Vec3 middle = Vec3(1, 2, 3) + Vec3(13, 20, 40) / 2;
        ASSERT_EQ(rig.sources.size(), 6U);
        Vec3 sum(0);
        for (const LightSource& source : rig.sources) {
            const auto& face = std::get<PolygonLight>(source);
            EXPECT_EQ(face.luminance, Rgb(7));
            EXPECT_FALSE(face.shines_at(middle));
            EXPECT_TRUE(face.shines_at(middle + face.normal() * 100));
            sum += polygon_normal(face.corners);
        }
        EXPECT_LT(sum.length(), 1e-9); // of a closed body
    }
    const auto face = only_light<PolygonLight>(box + "v = [0, 20, 0]\nw = [0, 0, 40]\n" +
                                               "luminous_flux = 100\n");
    EXPECT_NEAR(face.luminance.r, 100 / (std::numbers::pi * 2800e-6), 1e-6);
    EXPECT_EQ(rig_error(box + "v = [0, 20, 0]\nw = [5, 6, 0]\n"),
              "bad.toml:6:5: box[0].w: u, v and w must not lie in a plane");
}

TEST(AreaTables, BadGlobesAreNamed) {
    EXPECT_EQ(rig_error(head + "[[sphere]]\nradius = 3\n"),
              "bad.toml:2:1: sphere[0]: 'center' is missing");
    EXPECT_EQ(rig_error(head + "[[sphere]]\ncenter = [0, 0, 0]\n"),
              "bad.toml:2:1: sphere[0]: 'radius' is missing");
    EXPECT_TRUE(rig_error(head + "[[sphere]]\ncenter = [0, 0, 0]\nradius = 0\n")
                    .starts_with("bad.toml:4:10: sphere[0].radius: "));
}

} // namespace
} // namespace keiko
