#include "keiko/base/error.h"
#include "keiko/files/scene/material_file.h"

#include <gtest/gtest.h>

#include <string>

namespace keiko {
namespace {

const std::string paint = "format = \"keiko-materials/1\"\n[[material]]\nname = \"x\"\n";

Material read(const std::string& body) {
    return parse_materials(paint + body, "m.toml").front();
}

std::string refused(const std::string& body) {
    try {
        read(body);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(MapTable, ReadsEveryKeyOfAMap) {
    const Material material = read(R"(diffuse = 0.5
[[material.map]]
drives = "diffuse"
texture = { kind = "marble", size = 40, seed = 7, octaves = 3, gain = 0.4, lacunarity = 2.5, distortion = 4 }
low = [0.1, 0.2, 0.3]
high = 0.9
factor = 0.75
[material.map.region]
projection = { kind = "spherical", origin = [1, 2, 3], axis = [0, 1, 0], u = [0, 0, 1], scale = [2, 3], offset = [0.5, -1] }
corners = [[0, 0], [1, 0], [1, 1]]
[[material.map]]
drives = "bump"
texture = { kind = "orange-peel", bands = [0.1, 0.2, 0.3, 0.4, 0.5] }
)");
    ASSERT_EQ(material.maps.size(), 2U);
    const MaterialMap& marble = material.maps[0];
    EXPECT_EQ(marble.drives, MappedQuantity::diffuse);
    EXPECT_EQ(marble.projection, MapProjection());
    const TextureSpec expected{.kind = TextureKind::marble,
                               .size = 40,
                               .seed = 7,
                               .octaves = 3,
                               .gain = 0.4,
                               .lacunarity = 2.5,
                               .distortion = 4};
    EXPECT_EQ(marble.texture, expected);
    EXPECT_EQ(marble.low, Rgb(0.1, 0.2, 0.3));
    EXPECT_EQ(marble.high, Rgb(0.9));
    EXPECT_EQ(marble.factor, 0.75);
    ASSERT_TRUE(marble.region);
    EXPECT_EQ(marble.region->projection.scale, Vec2(2, 3));
    EXPECT_EQ(marble.region->projection.offset, Vec2(0.5, -1));
    EXPECT_EQ(marble.region->corners.size(), 3U);
    EXPECT_EQ(material.maps[1].texture.bands[4], 0.5);
    EXPECT_EQ(material.maps[1].texture.size, 1);
    EXPECT_EQ(material.maps[1].high, Rgb(1));
}

TEST(MapTable, FlatTexturesLieOnTheFaceUnlessTold) {
    const Material material = read(R"(diffuse = 0.5
map = [ { drives = "diffuse", texture = { kind = "reaction-diffusion", feed = 0.05, kill = 0.06 } },
        { drives = "bump", height = -2, texture = { kind = "brick", brick = [2, 1], mortar = 0.2 } } ]
)");
    EXPECT_EQ(material.maps[0].projection.kind, ProjectionKind::parameter);
    EXPECT_EQ(material.maps[0].texture.feed, 0.05);
    EXPECT_EQ(material.maps[1].high, Rgb(-2));
    EXPECT_EQ(material.maps[1].texture.brick, Vec3(2, 1, 0.2));
}

TEST(MapTable, RefusesWhatAMaterialOrATextureDoesNotHave) {
    const auto map = [](const std::string& keys) {
        return refused("diffuse = 0.5\n[[material.map]]\n" + keys);
    };
    const std::string noise = "texture = { kind = \"noise\" }\n";
    EXPECT_EQ(map("drives = \"difuse\"\n" + noise),
              "m.toml:6:10: material[0].map[0].drives: 'difuse' is none of diffuse, roughness, "
              "gloss, transmission, bump, normal, emission (did you mean 'diffuse'?)");
    EXPECT_EQ(map("drives = \"emission\"\n" + noise),
              "m.toml:6:10: material[0].map[0].drives: needs a material that emits");
    EXPECT_EQ(map("drives = \"roughness\"\n" + noise),
              "m.toml:6:10: material[0].map[0].drives: needs a material with roughness");
    EXPECT_EQ(map("drives = \"transmission\"\n" + noise),
              "m.toml:6:10: material[0].map[0].drives: needs glass");
    EXPECT_EQ(refused("metal = { n = 1, k = 4 }\n[[material.map]]\ndrives = \"diffuse\"\n" + noise),
              "m.toml:6:10: material[0].map[0].drives: needs a paint, not a metal or glass");
    EXPECT_EQ(
        refused("diffuse = 0.5\nrefractive_index = 1\n[[material.map]]\ndrives = \"gloss\"\n" +
                noise),
        "m.toml:7:10: material[0].map[0].drives: needs a border: a refractive_index above 1, "
        "or a metal");
    EXPECT_EQ(map("drives = \"bump\"\n" + noise),
              "m.toml:5:1: material[0].map[0]: 'height' is missing");
    EXPECT_EQ(map("drives = \"bump\"\nheight = 2000\n" + noise),
              "m.toml:7:10: material[0].map[0].height: must be at least -1000 and at most 1000, is "
              "2000");
    EXPECT_EQ(map("drives = \"diffuse\"\ntexture = { kind = \"noise\", octaves = 3 }\n"),
              "m.toml:7:29: unknown key 'material[0].map[0].texture.octaves'");
    EXPECT_EQ(map("drives = \"normal\"\n" + noise),
              "m.toml:7:11: material[0].map[0].texture: a normal map is a picture");
    EXPECT_EQ(map("drives = \"diffuse\"\ntexture = { kind = \"picture\", file = \"none.png\" }\n")
                  .substr(0, 54),
              "m.toml:7:38: material[0].map[0].texture.file: none.png");
    EXPECT_EQ(
        map("drives = \"gloss\"\ntexture = { kind = \"orange-peel\", bands = [1,1,1,1,1] }\n"),
        "m.toml:7:11: material[0].map[0].texture: orange-peel is a height: drives = \"bump\"");
    EXPECT_EQ(map("drives = \"gloss\"\ntexture = { kind = \"reaction-diffusion\" }\n"
                  "projection = { kind = \"solid\" }\n"),
              "m.toml:8:14: material[0].map[0].projection: a picture fills no space: it needs "
              "another kind");
    EXPECT_EQ(map("drives = \"gloss\"\ntexture = { kind = \"checker\", size = 4 }\n"
                  "projection = { kind = \"planar\" }\n"),
              "m.toml:7:38: material[0].map[0].texture.size: belongs to textures in space; a "
              "projection has a scale");
    EXPECT_EQ(map("drives = \"gloss\"\n" + noise +
                  "projection = { kind = \"planar\", u = [1, 0, 0], v = [-2, 0, 0] }\n"),
              "m.toml:8:52: material[0].map[0].projection.v: must not be parallel to u");
    EXPECT_EQ(map("drives = \"gloss\"\n" + noise + "region = { corners = [[0, 0], [1, 0]] }\n"),
              "m.toml:8:22: material[0].map[0].region.corners: must be at least 3 corners");
    EXPECT_EQ(map("drives = \"gloss\"\n" + noise +
                  "region = { corners = [[0, 0], [4, 0], [1, 2], [3, 2]] }\n"),
              "m.toml:8:22: material[0].map[0].region.corners: sides 2 and 4 cross each other");
    EXPECT_EQ(
        map("drives = \"gloss\"\ntexture = { kind = \"brick\", mortar = 0.6 }\n"),
        "m.toml:7:38: material[0].map[0].texture.mortar: must be thinner than a brick is wide "
        "and high");
}

} // namespace
} // namespace keiko
