#include "keiko/io/material_file.h"

#include "keiko/base/error.h"

#include "tests/support/paths.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

TEST(MaterialFile, StandardMaterialsAreThoseOfTheRepository) {
    const auto kept = read_materials(test::repository("lightrigs/materials.toml"));
    ASSERT_EQ(kept.size(), standard_materials().size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
        EXPECT_EQ(kept[i].name, standard_materials()[i].name);
        EXPECT_EQ(kept[i].diffuse, standard_materials()[i].diffuse);
    }
    EXPECT_EQ(standard_materials().front().name, "black-show-car");
    EXPECT_EQ(named_material("clay").refractive_index, 1);
}

TEST(MaterialFile, AnUnknownNameListsTheKnownOnes) {
    try {
        named_material("slver");
        FAIL() << "no error";
    } catch (const Error& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("(did you mean 'silver'?)"), std::string::npos) << text;
        EXPECT_NE(text.find("black-show-car"), std::string::npos) << text;
    }
}

TEST(MaterialFile, ImpossiblePaintsAreRefused) {
    const auto refused = [](const std::string& body) {
        try {
            parse_materials("format = \"keiko-materials/1\"\n[[material]]\nname = \"x\"\n" + body,
                            "m.toml");
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(refused("diffuse = 1.5\n"),
              "m.toml:4:11: material[0].diffuse: must be at least 0 and at most 1, is 1.5");
    EXPECT_EQ(refused("diffuse = 0.5\nrefractive_index = 0.9\n"),
              "m.toml:5:20: material[0].refractive_index: must be at least 1, is 0.9");
    EXPECT_EQ(refused("diffuse = 0.5\n[[material]]\nname = \"x\"\ndiffuse = 0\n"),
              "m.toml:6:8: material[1].name: 'x' is there twice");
}

} // namespace
} // namespace keiko
