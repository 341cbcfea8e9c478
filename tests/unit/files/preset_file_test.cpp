#include "keiko/files/scene/preset_file.h"

#include "keiko/base/error.h"

#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

TEST(PresetFile, StandardPresetsAreThoseOfTheRepository) {
    ASSERT_EQ(standard_presets().size(), 7u);
    for (const CriteriaPreset& preset : standard_presets()) {
        EXPECT_EQ(preset,
                  read_preset(test::repository("lightrigs/presets/" + preset.name + ".toml")));
        EXPECT_FALSE(preset.source.empty()) << preset.name;
        EXPECT_FALSE(preset.caveat.empty()) << preset.name;
    }
}

TEST(PresetFile, TheDefaultIsTheFirstAndJudgesSeamsAsItDoesWithoutAFile) {
    CriteriaPreset first = standard_presets().front();
    const CriteriaPreset plain;
    first.source = plain.source, first.caveat = plain.caveat, first.look = plain.look;
    EXPECT_EQ(first, plain);
}

TEST(PresetFile, HoldsTheLimitsOfTheCriteria) {
    struct Row {
        const char* name;
        double gap, angle, curvature;
        CurvatureFormula formula;
    };
    using enum CurvatureFormula;
    for (const Row& row : {Row{"class-a-outer", 0.01, 0.1, 0.1, alias},
                           {"class-a-strict", 0.001, 0.01, 0.02, catia},
                           {"class-b", 0.02, 0.2, 0, alias},
                           {"engineering", 0.05, 0.5, 0, alias},
                           {"vda-4955", 0.02, 0.1, 0.1, alias},
                           {"supplier-nissan", 0.01, 3, 0, alias},
                           {"class-a-waviness", 0.01, 0.1, 0.1, alias}}) {
        const CriteriaPreset& preset = preset_by_name(row.name);
        EXPECT_EQ(preset.gap, row.gap);
        EXPECT_EQ(preset.angle, row.angle);
        EXPECT_EQ(preset.curvature.has_value(), row.curvature > 0) << row.name;
        if (preset.curvature) {
            EXPECT_EQ(*preset.curvature, (CurvatureLimit{row.formula, row.curvature})) << row.name;
        }
        EXPECT_EQ(preset.curvature_slope.has_value(), preset.name == "class-a-strict");
        EXPECT_EQ(preset.feature_angle, 5);
    }
}

TEST(PresetFile, WavinessDiffersFromClassAOuterInItsSurfaceAlone) {
    CriteriaPreset preset = preset_by_name("class-a-waviness");
    const std::vector<WavinessLimit> limits{{0.01, 100}, {0.025, 250, true}, {0.04, 400, true}};
    EXPECT_EQ(preset.surface.waviness, limits);
    CriteriaPreset outer = preset_by_name("class-a-outer");
    preset.name = "class-a-outer", preset.surface = {}, outer.look = {};
    EXPECT_EQ(preset, outer);
}

TEST(PresetFile, HoldsTheLimitsOfJoints) {
    const std::string head =
        "format = \"keiko-preset/1\"\nname = \"x\"\n[seam]\ngap = 1\n"
        "angle = 1\n";
    const auto limits = [&](const std::string& joint) {
        return parse_preset(head + joint, "p.toml").joint;
    };
    EXPECT_EQ(limits(""), JointLimits{});
    const JointLimits all = limits(
        "[joint]\ngap = { nominal = 3.5, tolerance = 0.5 }\nflush = { nominal = -0.2, "
        "tolerance = 0.3 }\nparallelism = 0.4\nradius = 2.5\nwidest = 20\n"
        "largest_radius = 8\ncorner_radius = 50\nspacing = 5\n");
    EXPECT_EQ(all,
              (JointLimits{NominalSize{3.5, 0.5}, NominalSize{-0.2, 0.3}, 0.4, 2.5, 20, 8, 50, 5}));
    EXPECT_THROW(limits("[joint]\ngap = { nominal = 3.5 }\n"), Error);
    EXPECT_THROW(limits("[joint]\ngap = { nominal = 14, tolerance = 1 }\n"), Error);
    EXPECT_THROW(limits("[joint]\nwidth = 3\n"), Error);
}

TEST(PresetFile, AnUnknownNameListsTheKnownOnes) {
    try {
        preset_by_name("class-z");
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(error.reason().find("(did you mean 'class-b'?)"), std::string::npos)
            << error.reason();
        EXPECT_NE(error.reason().find("vda-4955"), std::string::npos);
    }
}

std::string refused(const std::string& body) {
    try {
        parse_preset("format = \"keiko-preset/1\"\n" + body, "p.toml");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

/// The column of a key's value.
std::string place_of(const std::string& key) {
    return std::to_string(key.size() + 4);
}

TEST(PresetFile, SaysWhereAFileIsWrong) {
    EXPECT_EQ(refused("name = \"x\"\n"), "p.toml:1:1: 'seam' is missing");
    EXPECT_EQ(refused("name = \"x\"\n[seam]\nangle = 1\n"), "p.toml:3:1: seam: 'gap' is missing");
    EXPECT_EQ(refused("nmae = \"x\"\n"), "p.toml:2:1: unknown key 'nmae' (did you mean 'name'?)");
    EXPECT_EQ(refused("name = \"x\"\n[saem]\n"),
              "p.toml:3:2: unknown key 'saem' (did you mean 'seam'?)");
    EXPECT_EQ(refused("name = \"x\"\n[seam]\ngpa = 1\nangle = 1\n"),
              "p.toml:4:1: unknown key 'seam.gpa' (did you mean 'gap'?)");
    EXPECT_EQ(refused("name = \"x\"\n[seam]\ngap = 0\nangle = 1\n"),
              "p.toml:4:7: seam.gap: must be above 0 and at most 1e+06, is 0");
    EXPECT_EQ(
        refused("name = \"x\"\n[seam]\ngap = 1\nangle = 6\n"),
        "p.toml:3:1: seam.feature_angle: is not above the limit of the angle: no seam could fail");
    EXPECT_EQ(refused("name = \"x\"\n[seam]\ngap = 1\nangle = 1\ncurvatur = 1\n"),
              "p.toml:6:1: unknown key 'seam.curvatur' (did you mean 'curvature'?)");
    EXPECT_EQ(refused("name = \"x\"\n[seam]\ngap = 1\nangle = 1\n[surface]\nradius = 6\n"),
              "p.toml:7:1: unknown key 'surface.radius'");
    EXPECT_EQ(refused("name = \"x\"\n[seam]\ngap = 1\nangle = 1\n[surface]\nminimum_radius = 0\n"),
              "p.toml:7:18: surface.minimum_radius: must be above 0 and at most 1e+06, is 0");
}

TEST(PresetFile, HoldsADraftAndItsPull) {
    const std::string seam = "name = \"x\"\n[seam]\ngap = 1\nangle = 1\n[surface]\n";
    const auto limits = [&](const std::string& surface) {
        return parse_preset("format = \"keiko-preset/1\"\n" + seam + surface, "p.toml").surface;
    };
    EXPECT_EQ(limits("draft = 1.5\n").draft, (DraftLimit{1.5, {0, 0, 1}}));
    EXPECT_EQ(limits("draft = 0\npull = [0, -2, 0]\n").draft, (DraftLimit{0, {0, -1, 0}}));
    EXPECT_FALSE(limits("minimum_radius = 1\n").draft);
    EXPECT_EQ(refused(seam + "draft = 91\n"),
              "p.toml:7:9: surface.draft: must be at least 0 and at most 90, is 91");
    EXPECT_EQ(refused(seam + "draft = 1\npull = [0, 0, 0]\n"),
              "p.toml:8:8: surface.pull: has no direction");
    EXPECT_EQ(refused(seam + "pull = [0, 0, 1]\n"),
              "p.toml:7:8: surface.pull: is the direction of a draft, which is missing");
}

TEST(PresetFile, RefusesALimitThatNothingIsBeyond) {
    const std::string seam = "name = \"x\"\n[seam]\ngap = 1\nangle = 1\n";
    const auto curvature = [&](const std::string& formula, const std::string& limit) {
        return refused(seam + "curvature = { formula = \"" + formula + "\", limit = " + limit +
                       " }\n");
    };
    for (const std::string limit : {"1", "1.5", "2"})
        EXPECT_EQ(curvature("alias", limit),
                  "p.toml:6:42: seam.curvature.limit: must be above 0 and below 1, which nothing "
                  "is beyond, is " +
                      limit);
    EXPECT_EQ(curvature("alias", "0.99"), "");
    EXPECT_EQ(curvature("catia", "1.99"), "");
    for (const std::string limit : {"2", "2.5", "0", "-1"})
        EXPECT_NE(curvature("catia", limit), "");
    const auto refuses = [&](const std::string& line, const std::string& largest) {
        EXPECT_NE(refused(seam + line + " = " + largest + "\n"), "") << line;
        EXPECT_EQ(refused(seam + line + " = 0.99e" + (largest == "90" ? "1" : "2") + "\n"), "");
    };
    refuses("curvature_slope", "180");
    refuses("[lines]\nturn", "90");
    refuses("[lines]\nkink", "180");
    EXPECT_NE(refused(seam + "feature_angle = 1\n"), "");
}

const std::string plain_seam = "name = \"x\"\n[seam]\ngap = 1\nangle = 2.1\n";

TEST(PresetFile, HoldsHowASeamIsCut) {
    const std::string format = "format = \"keiko-preset/1\"\n";
    const CriteriaPreset given =
        parse_preset(format + plain_seam +
                         "fading = 0.003\nlongest_run_out = 70\nnegligible = 0.25\n"
                         "flat_radius = 5000\n",
                     "p.toml");
    EXPECT_EQ(given.fading, 0.003);
    EXPECT_EQ(given.longest_run_out, 70);
    EXPECT_EQ(given.negligible, 0.25);
    EXPECT_EQ(given.flat_radius, 5000);
    const CriteriaPreset left_out = parse_preset(format + plain_seam, "p.toml");
    EXPECT_EQ(left_out.fading, 2.1 / 70); // it follows from the angle
    EXPECT_EQ(left_out.longest_run_out, 200);
    EXPECT_EQ(left_out.negligible, 0.1);
    EXPECT_EQ(left_out.flat_radius, 100000);
}

TEST(PresetFile, RefusesWhatNoSeamCanBeCutBy) {
    const auto refuses = [](const std::string& key, const std::string& value) {
        const std::string message = refused(plain_seam + key + " = " + value + "\n");
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        EXPECT_EQ(message.substr(0, message.find("seam.")), "p.toml:6:" + place_of(key) + ": ")
            << message;
        EXPECT_NE(message.find("seam." + key + ": "), std::string::npos) << message;
    };
    for (const std::string key : {"fading", "longest_run_out", "negligible", "flat_radius"})
        for (const std::string value : {"0", "-1", "nan", "inf", "\"wide\""}) refuses(key, value);
    refuses("longest_run_out", "2e6");
    refuses("negligible", "0.0009");
    refuses("negligible", "1001");
}

TEST(PresetFile, SaysThatAVersionIsNotRead) {
    try {
        parse_preset("format = \"keiko-preset/2\"\n", "p.toml");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.reason(),
                  "format: is 'keiko-preset/2', a version that this program does not read; "
                  "expected format = \"keiko-preset/1\"");
    }
}

TEST(PresetFile, HoldsLimitsOfFaces) {
    EXPECT_EQ(preset_by_name("vda-4955").surface.minimum_radius, 0.5);
    EXPECT_EQ(preset_by_name("class-a-outer").surface, SurfaceLimits{});
}

TEST(PresetFile, HoldsLimitsOfStructure) {
    StructureLimits printed;
    printed.degree = printed.edge_degree = 11, printed.patch_edge = 0.2, printed.corner_angle = 2;
    printed.knot_distance = printed.short_edge = printed.small_face = 0.02;
    printed.identical_face = printed.identical_edge = printed.self_distance = 0.02;
    printed.loop_crossing = printed.edge_gap = printed.edge_knot_distance = 0.02;
    printed.edge_angle = 0.1;
    EXPECT_EQ(preset_by_name("vda-4955").structure, printed);
    EXPECT_EQ(preset_by_name("class-a-outer").structure, StructureLimits{});
    const std::string text =
        "format = \"keiko-preset/1\"\nname = \"x\"\n[seam]\ngap = 1\nangle = "
        "1\n[structure]\nspans = 4\n";
    EXPECT_EQ(parse_preset(text, "p.toml").structure.spans, 4);
    EXPECT_EQ(refused("name = \"x\"\n[seam]\ngap = 1\nangle = 1\n[structure]\nspan = 4\n"),
              "p.toml:7:1: unknown key 'structure.span' (did you mean 'spans'?)");
}

TEST(PresetFile, RefusesLimitsOfStructureThatNothingIsBeyond) {
    const std::string head = "name = \"x\"\n[seam]\ngap = 1\nangle = 1\n[structure]\n";
    EXPECT_EQ(
        refused(head + "control_turn = 180\n"),
        "p.toml:7:16: structure.control_turn: must be above 0 and below 180, which nothing is "
        "beyond, is 180");
    EXPECT_NE(refused(head + "control_ratio = 0.5\n").find("structure.control_ratio"),
              std::string::npos);
    EXPECT_NE(refused(head + "self_distance = 0\n").find("structure.self_distance"),
              std::string::npos);
}

/// The default one reports dents and waves that it does not judge.
TEST(PresetFile, HoldsWhatIsWorthALook) {
    const std::vector<WavinessLimit> limits{{0.01, 100}};
    EXPECT_EQ(preset_by_name("class-a-outer").look.waviness, limits);
    EXPECT_EQ(preset_by_name("class-a-outer").flaw_limits(), limits);
    EXPECT_TRUE(preset_by_name("class-a-waviness").look.waviness.empty());
    EXPECT_EQ(refused("name = \"x\"\n[seam]\ngap = 1\nangle = 1\n"
                      "[surface]\nwaviness = { depth = 0.02, window = 80 }\n"
                      "[look]\nwaviness = { depth = 0.02, window = 80 }\n"),
              "p.toml:9:12: look.waviness: has no use where [surface] limits it");
}

TEST(PresetFile, LimitsDentsAndWaves) {
    const std::string head =
        "format = \"keiko-preset/1\"\nname = \"x\"\n[seam]\ngap = 1\nangle = 1\n";
    const CriteriaPreset preset =
        parse_preset(head + "[surface]\nwaviness = { depth = 0.02, window = 80 }\n", "p.toml");
    EXPECT_EQ(preset.surface.waviness, (std::vector<WavinessLimit>{{0.02, 80}}));
    EXPECT_EQ(refused("name = \"x\"\n[seam]\ngap = 1\nangle = 1\n"
                      "[surface]\nwaviness = { depth = 2, window = 80 }\n"),
              "p.toml:7:22: surface.waviness.depth: is more than a fiftieth of the window: such is "
              "form, no flaw");
}

TEST(PresetFile, LimitsDentsAndWavesInSeveralWindows) {
    const std::string head =
        "name = \"x\"\n[seam]\ngap = 1\nangle = 1\n[surface]\nwaviness = [\n"
        "  { depth = 0.02, window = 80 },\n";
    const CriteriaPreset preset =
        parse_preset("format = \"keiko-preset/1\"\n" + head +
                         "{ depth = 0.1, window = 200, waves_only = true }]\n",
                     "p.toml");
    const std::vector<WavinessLimit> limits{{0.02, 80}, {0.1, 200, true}};
    EXPECT_EQ(preset.surface.waviness, limits);
    EXPECT_EQ(refused(head + "  { depth = 0.01, window = 80 }]\n"),
              "p.toml:9:28: surface.waviness[1].window: is no wider than the one before it");
    EXPECT_EQ(refused(head + "  7]\n"),
              "p.toml:7:12: surface.waviness: must be an array of tables");
}

TEST(PresetFile, IsReadWhereItsPathIsGiven) {
    const test::TemporaryFolder folder;
    const auto path =
        folder.file("mine.toml",
                    "format = \"keiko-preset/1\"\nname = \"mine\"\n[seam]\ngap = 0.5\nangle = 2\n");
    const CriteriaPreset preset = preset_by_name_or_file(path.string());
    EXPECT_EQ(preset.name, "mine");
    EXPECT_EQ(preset.gap, 0.5);
    EXPECT_FALSE(preset.curvature.has_value());
    EXPECT_EQ(preset_by_name_or_file("class-b"), preset_by_name("class-b"));
    EXPECT_THROW(preset_by_name_or_file("missing.toml"), Error);
}

} // namespace
} // namespace keiko
