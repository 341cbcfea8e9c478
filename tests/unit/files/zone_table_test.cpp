#include "keiko/base/error.h"
#include "keiko/files/scene/fixture_file.h"
#include "keiko/files/scene/preset_file.h"

#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <fstream>

namespace keiko {
namespace {

const std::string head =
    "format = \"keiko-preset/1\"\nname = \"own\"\n[seam]\ngap = 0.01\n"
    "angle = 0.1\ncurvature = { formula = \"alias\", limit = 0.1 }\n"
    "negligible = 0.2\n[lines]\nturn = 0.1\n";

CriteriaPreset parsed(const std::string& zones) {
    return parse_preset(head + zones, "own.toml");
}

std::string error_of(const std::string& zones) {
    try {
        parsed(zones);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(ZoneTable, HasFacesAndLimits) {
    const CriteriaPreset preset = parsed(
        "[[zone]]\nname = \"B\"\nfaces = [\"door*\", \"7\"]\nlayers = [\"L\"]\n"
        "colors = [\"#FF0000\"]\nbox = [[0, 1, 2], [3, 4, 5]]\nvisible = 0.5\n"
        "[zone.seam]\ngap = 0.02\nangle = 0.7\n[zone.surface]\nminimum_radius = 3\n"
        "[[zone]]\nname = \"all\"\nfaces = [\"*\"]\n");
    ASSERT_EQ(preset.zones.size(), 2u);
    const Zone& b = preset.zones[0];
    EXPECT_EQ(b.name, "B");
    EXPECT_EQ(b.file, "own.toml");
    EXPECT_EQ(b.selection.text(),
              "faces door*, 7, layers L, colors #ff0000, box (0, 1, 2) to (3, 4, 5) mm, visible "
              "on at least 50 % of their area");
    EXPECT_EQ(b.limits.gap, 0.02);
    EXPECT_EQ(b.limits.angle, 0.7);
    EXPECT_EQ(b.limits.fading, 0.01);
    EXPECT_FALSE(b.limits.curvature) << "a table of limits is complete";
    EXPECT_EQ(b.limits.negligible, 0.2) << "of the preset";
    EXPECT_EQ(b.limits.lines.turn, 0.1) << "of the preset: it has no table";
    EXPECT_EQ(b.limits.surface.minimum_radius, 3);
    CriteriaPreset plain = preset;
    plain.zones.clear();
    EXPECT_EQ(preset.zones[1].limits, plain) << "without tables";
}

TEST(ZoneTable, TakesLimitsOfAnotherPreset) {
    const Zone zone =
        parsed("[[zone]]\nname = \"C\"\nfaces = [\"*\"]\npreset = \"engineering\"\n").zones[0];
    EXPECT_EQ(zone.limits.gap, 0.05);
    EXPECT_EQ(zone.limits.angle, 0.5);
    EXPECT_FALSE(zone.limits.curvature);
    EXPECT_EQ(zone.limits.negligible, 0.2) << "what a scrap is does not depend on the zone";
    EXPECT_EQ(zone.limits.name, "own");
}

TEST(ZoneTable, TakesLimitsOfAFileBesideItsOwn) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.path() / "loose.toml")
        << "format = \"keiko-preset/1\"\nname = \"loose\"\n[seam]\ngap = 1\nangle = 2\n";
    const auto own = folder.path() / "own.toml";
    std::ofstream(own) << head
                       << "[[zone]]\nname = \"C\"\nfaces = [\"*\"]\npreset = \"loose.toml\"\n";
    EXPECT_EQ(read_preset(own).zones.at(0).limits.gap, 1);
    std::ofstream(folder.path() / "loose.toml", std::ios::app)
        << "[[zone]]\nname = \"D\"\nfaces = [\"*\"]\npreset = \"own.toml\"\n";
    try {
        read_preset(own);
        FAIL() << "zones in zones";
    } catch (const Error& error) {
        EXPECT_EQ(error.file(), (folder.path() / "loose.toml").string());
        EXPECT_NE(error.reason().find("has no place in a preset"), std::string::npos);
    }
}

TEST(ZoneTable, RefusesWhatMakesNoSense) {
    const std::string zone = "[[zone]]\nname = \"A\"\n", all = zone + "faces = [\"*\"]\n";
    struct Row {
        std::string zones, reason;
    };
    for (const Row& row : {
             Row{"[[zone]]\nfaces = [\"*\"]\n", "name"},
             {"[[zone]]\nname = \"\"\nfaces = [\"*\"]\n", "is empty"},
             {"[[zone]]\nname = \"outer-skin\"\nfaces = [\"*\"]\n", "is that of the scope"},
             {all + all, "'A' is that of an earlier zone"},
             {zone, "selects no faces"},
             {zone + "facs = [\"*\"]\n", "did you mean 'faces'"},
             {zone + "faces = []\n", "must name at least one"},
             {zone + "layers = [\"\"]\n", "holds an empty name"},
             {zone + "colors = [\"red\"]\n", "'red' is no colour"},
             {zone + "box = [[0, 0, 0]]\n", "two corners"},
             {zone + "box = [[0, 0], [1, 1]]\n", "two corners"},
             {zone + "box = [[0, 0, 0], [1, -1, 1]]\n", "lower corner first"},
             {zone + "visible = 0\n", "visible"},
             {zone + "visible = 1.5\n", "visible"},
             {all + "preset = \"class-x\"\n", "unknown preset 'class-x'"},
             {all + "presset = \"class-b\"\n", "presset"},
             {all + "[zone.seam]\nangle = 0.1\n", "gap"},
             {all + "[zone.seam]\ngap = 0\nangle = 0.1\n", "gap"},
             {all + "[zone.seam]\ngap = 0.1\nangle = 5\n", "not below the feature angle"},
             {all + "[zone.seam]\ngap = 0.1\nangle = 1\nnegligible = 1\n", "is the same in all"},
             {all + "[zone.surface]\nsymmetry = { plane = \"y\", distance = 1 }\n", "as a whole"},
             {all + "[zone.structure]\ndegree = 0\n", "degree"},
             {all + "[zone.look]\nwaviness = { depth = 0.01, window = 100 }\n", "look"},
         }) {
        const std::string error = error_of(row.zones);
        EXPECT_EQ(error.substr(0, 9), "own.toml:") << row.zones << error;
        EXPECT_NE(error.find(row.reason), std::string::npos) << row.zones << error;
    }
}

TEST(ZoneTable, OfAFixtureComesBeforeThoseOfItsPreset) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.path() / "own.toml")
        << head << "[[zone]]\nname = \"B\"\nfaces = [\"*\"]\n";
    std::ofstream(folder.path() / "part.bpt") << "1\n";
    const auto fixture = [&](const std::string& name) {
        const auto path = folder.path() / "part.toml";
        std::ofstream(path) << "format = \"keiko-fixture/1\"\nmodel = \"part.bpt\"\n"
                               "preset = \"own.toml\"\n[[zone]]\nname = \"" +
                                   name + "\"\nlayers = [\"1\"]\npreset = \"class-b\"\n";
        return read_fixture(path).preset;
    };
    const CriteriaPreset preset = fixture("A");
    ASSERT_EQ(preset.zones.size(), 2u);
    EXPECT_EQ(preset.zones[0].name, "A");
    EXPECT_EQ(preset.zones[0].limits.gap, 0.02);
    EXPECT_EQ(preset.zones[1].name, "B");
    EXPECT_THROW(fixture("B"), Error);
}

} // namespace
} // namespace keiko
