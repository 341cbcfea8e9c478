#include "keiko/base/error.h"
#include "keiko/files/scene/material_file.h"

#include <gtest/gtest.h>

#include <string>

namespace keiko {
namespace {

const std::string head =
    "format = \"keiko-materials/1\"\n[[material]]\nname = \"a\"\n"
    "diffuse = 0.1\n[material.texels]\n";

TexelSpec read(const std::string& keys) {
    return parse_materials(head + keys, "paints.toml").front().texels.value();
}

std::string refused(const std::string& keys) {
    try {
        read(keys);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(TexelTable, ReadsEveryKeyOfFur) {
    const TexelSpec texels = read(R"(kind = "fur"
thickness = 30
hairs = 50
length = 40
variation = 0.1
width = 0.2
lean = 10
droop = 60
toward = -90
disorder = 5
curl = { radius = 2, turns = 3 }
block = 25
seed = 7
voxels = 32
diffuse = [0.3, 0.2, 0.1]
specular = 0.4
exponent = 50
)");
    const TexelSpec expected{.fibres = FurSpec{.hairs = 50,
                                               .length = 40,
                                               .variation = 0.1,
                                               .width = 0.2,
                                               .lean = 10,
                                               .droop = 60,
                                               .toward = -90,
                                               .disorder = 5,
                                               .curl_radius = 2,
                                               .curl_turns = 3,
                                               .block = 25},
                             .thickness = 30,
                             .voxels = 32,
                             .seed = 7,
                             .diffuse = Rgb(0.3, 0.2, 0.1),
                             .specular = Rgb(0.4),
                             .exponent = 50};
    EXPECT_EQ(texels, expected);
    EXPECT_EQ(std::get<FurSpec>(read("kind = \"fur\"\nthickness = 3").fibres).length, 3);
}

TEST(TexelTable, ReadsEveryKeyOfCloth) {
    const TexelSpec texels = read(
        "kind = \"cloth\"\nthickness = 1\nweave = \"satin\"\nspacing = 0.5\nextinction = 20\n");
    EXPECT_EQ(std::get<ClothSpec>(texels.fibres), (ClothSpec{Weave::satin, 0.5, 20}));
}

TEST(TexelTable, RefusesWithLineColumnAndRange) {
    EXPECT_EQ(refused("thickness = 1"), "paints.toml:5:1: material[0].texels: 'kind' is missing");
    EXPECT_EQ(refused("kind = \"fur\""),
              "paints.toml:5:1: material[0].texels: 'thickness' is missing");
    EXPECT_EQ(refused("kind = \"fur\"\nthickness = 0"),
              "paints.toml:7:13: material[0].texels.thickness: must be at least 0.01 and at most "
              "10000, is 0");
    EXPECT_EQ(refused("kind = \"fur\"\nthickness = 5\nweave = \"twill\""),
              "paints.toml:8:9: material[0].texels.weave: belongs to kind = \"cloth\"");
    EXPECT_EQ(refused("kind = \"cloth\"\nthickness = 5\nhairs = 3"),
              "paints.toml:8:9: material[0].texels.hairs: belongs to kind = \"fur\"");
    EXPECT_EQ(refused("kind = \"fur\"\nthickness = 5\nvoxels = 48"),
              "paints.toml:8:10: material[0].texels.voxels: must be a power of two: 8, 16, 32, 64 "
              "or 128");
    EXPECT_EQ(
        refused("kind = \"fur\"\nthickness = 5\nhairs = 30000"),
        "paints.toml:8:9: material[0].texels.hairs: are 120000 in a block of which it may have "
        "100000");
    EXPECT_EQ(refused("kind = \"fur\"\nthickness = 5\nhairs = 3\nblock = 5"),
              "paints.toml:9:9: material[0].texels.block: a block has less than one hair: make it "
              "larger");
    EXPECT_EQ(refused("kind = \"fur\"\nthickness = 5\nhairs = 1000\ncurl = { radius = 100, turns "
                      "= 9 }"),
              "paints.toml:8:9: material[0].texels.hairs: pass more than 10000000 voxels of a "
              "block: take fewer, shorter or less curled ones");
    EXPECT_EQ(refused("kind = \"fur\"\nthickness = 5\nhairs = 0.2"),
              "paints.toml:8:9: material[0].texels.hairs: a block has less than one hair: make it "
              "larger");
    EXPECT_EQ(
        refused("kind = \"fur\"\nthickness = 5\ndiffuse = 0.7\nspecular = 0.4"),
        "paints.toml:9:12: material[0].texels.specular: reflects with diffuse more light than "
        "arrives: their sum is above 1");
}

} // namespace
} // namespace keiko
