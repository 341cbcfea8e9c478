#include "keiko/files/scene/fixture_file.h"

#include "keiko/base/error.h"
#include "keiko/files/toml/toml_document.h"

#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

std::string surface(const std::string& name) {
    return test::repository("surfaces/" + name).string();
}

FixtureSpec parsed(const std::string& lines) {
    return parse_fixture("format = \"keiko-fixture/1\"\n" + lines, surface("probe.toml"));
}

std::string refusal(const std::string& lines) {
    try {
        parsed(lines);
    } catch (const Error& error) {
        return error.where() + ": " + error.reason();
    }
    return "accepted";
}

TEST(FixtureFile, HoldsWhatStandsInItWithPathsFromItsFolder) {
    const FixtureSpec fixture = parsed(R"(
model = ["hood.step", "dome.bpt"]
material = "silver"
views = ["top", "front"]
size = [40, 30]
rig = "../lightrigs/bench-6.toml"
layers = ["face", "uv"]
shadows = true
preset = "vda-4955"
join = 0.2
checks = ["seams", "pictures"]
[tolerance]
gap = 0.5
area = { relative = 0.25 }
[picture_tolerance]
flips = 0.5
depth = { hard = 7 }
)");
    EXPECT_EQ(fixture.name, "probe");
    EXPECT_EQ(fixture.models,
              (std::vector<std::filesystem::path>{surface("hood.step"), surface("dome.bpt")}));
    EXPECT_EQ(fixture.material, "silver");
    EXPECT_EQ(fixture.views, (std::vector<std::string>{"top", "front"}));
    EXPECT_EQ(fixture.width * 1000 + fixture.height, 40030);
    EXPECT_EQ(fixture.rig, test::repository("lightrigs/bench-6.toml"));
    EXPECT_EQ(fixture.layers, (std::vector<std::string>{"face", "uv"}));
    EXPECT_TRUE(fixture.shadows);
    EXPECT_EQ(fixture.preset.name, "vda-4955");
    EXPECT_EQ(fixture.join, 0.2);
    EXPECT_EQ(fixture.checks, (FixtureChecks{false, true, false, true}));
    EXPECT_EQ(fixture.metric_tolerance[Quantity::gap], (MetricTolerance{0.5, 0}));
    const MetricTolerance usual = MetricTolerances{}[Quantity::area];
    EXPECT_EQ(fixture.metric_tolerance[Quantity::area], (MetricTolerance{usual.absolute, 0.25}));
    EXPECT_EQ(fixture.film_tolerance.flips, 0.5);
    EXPECT_EQ(fixture.film_tolerance.depth.hard, 7);
    EXPECT_EQ(fixture.film_tolerance.depth.absolute, FilmTolerance{}.depth.absolute);
}

TEST(FixtureFile, WhatIsWrongIsToldWithItsPlace) {
    EXPECT_EQ(refusal("view = \"top\"\nmodel = \"dome.bpt\""),
              "2:1: unknown key 'view' (did you mean 'views'?)");
    EXPECT_TRUE(refusal("views = []").ends_with(": 'model' is missing"));
    EXPECT_EQ(refusal("modle = \"dome.bpt\""), "2:1: unknown key 'modle' (did you mean 'model'?)");
    EXPECT_TRUE(refusal("model = \"dome.bpt\"\nviews = [\"auto\"]")
                    .starts_with("3:9: views: unknown 'auto'"));
    EXPECT_TRUE(refusal("model = \"dome.bpt\"\nlayers = [\"patch\"]")
                    .starts_with("3:10: layers: unknown 'patch'"));
    EXPECT_EQ(refusal("model = \"dome.bpt\"\nviews = [\"top\", \"top\"]"),
              "3:9: views: names 'top' twice");
    EXPECT_EQ(refusal("scene = \"hood-scene.toml\"\nmaterial = \"clay\""),
              "3:12: material: stands in the scene where there is one");
    EXPECT_EQ(refusal("model = \"dome.bpt\"\nshadows = 1"), "3:11: shadows: must be true or false");
    EXPECT_EQ(refusal("model = \"dome.bpt\"\nchecks = []"), "3:10: checks: must name at least one");
    EXPECT_EQ(refusal("model = \"dome.bpt\"\n[tolerance]\nverdict = 1"),
              "4:1: unknown key 'tolerance.verdict'");
    EXPECT_EQ(refusal("model = \"dome.bpt\"\n[picture_tolerance]\ncolor = { hard = 0.5 }"),
              "4:18: picture_tolerance.color.hard: must be at least 1, is 0.5");
    EXPECT_NE(refusal("model = \"nowhere.step\"").find("no such file"), std::string::npos);
}

TEST(FixtureFile, PathsThatEndEarlyAreRefused) {
    // The file system reads dome.bpt and leaves the rest.
    const std::string why = " has a NUL character, written \\u0000";
    EXPECT_EQ(refusal("model = \"dome.bpt\\u0000.evil\""), "2:9: model: \"dome.bpt?.evil\"" + why);
    EXPECT_EQ(refusal("model = [\"dome.bpt\", \"dome.bpt\\u0000.evil\"]"),
              "2:9: model: \"dome.bpt?.evil\"" + why);
    for (const std::string key : {"scene", "rig", "preset"})
        EXPECT_NE(refusal((key == "scene" ? "" : "model = \"dome.bpt\"\n") + key +
                          " = \"x.toml\\u0000.evil\"")
                      .find(key + ": \"x.toml?.evil\"" + why),
                  std::string::npos);
}

TEST(FixtureFile, AFolderGivesItsFixturesByNameAndPassesOtherFormatsOver) {
    const test::TemporaryFolder folder;
    folder.file("m.bpt", "1\n");
    for (const char* name : {"b.toml", "a.toml"})
        folder.file(name, "format = \"keiko-fixture/1\"\nmodel = \"m.bpt\"\n");
    folder.file("scene.toml", "format = \"keiko-scene/1\"\n");
    std::vector<FixtureFile> fixtures = fixture_files(folder.path());
    ASSERT_EQ(fixtures.size(), 2u);
    EXPECT_EQ(fixtures[0].name + fixtures[1].name, "ab");
    folder.file("none.toml", "model = \"m.bpt\"\n");
    fixtures = fixture_files(folder.path());
    ASSERT_EQ(fixtures.size(), 3u) << "it may be a fixture whose format is misspelt";
    EXPECT_THROW(read_fixture(fixtures[2].file), Error);
    EXPECT_THROW(fixture_files(folder.path() / "nowhere"), Error);
}

TEST(NamedFiles, AreFollowedThroughTomlFilesAndListedOnce) {
    const test::TemporaryFolder folder;
    const auto model = folder.file("m.step", "x");
    const auto rig = folder.file("rig.toml", "file = \"lamp.ies\"\nname = \"no file\"\n");
    const auto lamp = folder.file("lamp.ies", "x");
    const auto cut = folder.file("cut.toml", "file = \"m.step\\u0000.evil\"\n");
    EXPECT_EQ(files_named_by(cut), std::vector<std::filesystem::path>{cut});
    const auto scene = folder.file("s.toml",
                                   "model = [{ file = \"m.step\" }, { file = \"m.step\" }]\n"
                                   "[rig]\nfile = \"rig.toml\"\n");
    EXPECT_EQ(files_named_by(scene), (std::vector<std::filesystem::path>{lamp, model, rig, scene}));
}

} // namespace
} // namespace keiko
