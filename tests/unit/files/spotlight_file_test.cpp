#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/files/photometric/intensity_csv.h"
#include "keiko/files/scene/rig_file.h"
#include "keiko/light/spotlight/luminous_flux.h"
#include "keiko/light/spotlight/spotlight.h"

#include "tests/support/paths.h"
#include "tests/support/rig_text.h"
#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <fstream>

namespace keiko {
namespace {
namespace fs = std::filesystem;

const std::string head = "format = \"keiko-rig/1\"\n";
const std::string spot = "[[spotlight]]\nposition = [0, 0, 4000]\naim = [0, 0, 0]\n";
const std::string sun = "[sun]\ndirection = [1, 0, -1]\nilluminance = 60000\n";
const std::string fog = spot + "[fog]\nextinction = 0.1\n";

/// The message of the Error that the tables of a rig cause; "" when there is none.
std::string rig_error(const std::string& tables) {
    return test::rig_error(head + tables);
}

Spotlight spotlight(const std::string& keys) {
    return std::get<Spotlight>(parse_rig(head + spot + keys, "rig.toml").sources.at(0));
}

/// cd at an angle from the axis of the light above, which points down.
double candela(const Spotlight& light, double degrees, double phi) {
    const BeamIntensity intensity(light);
    const Vec3 direction =
        intensity.frame().world(degrees * std::numbers::pi / 180, phi * std::numbers::pi / 180);
    // From so far off that the light's own place does not round the direction away.
    return luminance(intensity(light.position + direction * 1e6));
}

std::string luminaire(const std::string& keys) {
    const fs::path file = test::repository("tests/data/oracle/photometric_files/sym4.ldt");
    return "[[luminaire]]\nfile = \"" + file.string() + "\"\nposition = [0, 0, 3000]\n" + keys;
}

void expect_round_trip(const std::string& text) {
    const std::string written = rig_text(parse_rig(head + text, "rig.toml"));
    EXPECT_EQ(rig_text(parse_rig(written, "written.toml")), written) << written;
}

} // namespace

TEST(SpotlightFile, ProfilesAreReadByTheirEdge) {
    EXPECT_EQ(std::get<CosinePower>(spotlight("edge = \"power\"\nexponent = 3\n").profile),
              CosinePower{3});
    EXPECT_EQ(spotlight("edge = \"power\"\nexponent = 3\n").half_angle, 90);
    const Spotlight polynomial =
        spotlight("edge = \"polynomial\"\ncoefficients = [0.5, 0, 0.5]\nintensity = 10\n");
    EXPECT_NEAR(candela(polynomial, 60, 0), 10 * (0.5 + 0.5 * 0.25), 1e-12);
    EXPECT_EQ(polynomial.half_angle, 180);
    const Spotlight ellipse = spotlight("half_angle = 30\nhalf_angle_across = 10\n");
    EXPECT_GT(candela(ellipse, 20, 0), 0);
    EXPECT_EQ(candela(ellipse, 20, 90), 0);
}

TEST(SpotlightFile, TablesHoldCandelaAndEndWhereTheyAreDark) {
    const std::string table =
        "edge = \"table\"\ntable = { theta = [0, 10, 20, 90], values = [[100, 80, 0, 0]] }\n";
    const Spotlight light = spotlight(table);
    EXPECT_NEAR(candela(light, 10, 77), 80, 1e-12);
    EXPECT_EQ(light.half_angle, 20);
    EXPECT_LT(candela(light, 5, 0), candela(spotlight(table + "intensity = 2\n"), 5, 0));
    EXPECT_GT(candela(light, 5, 0),
              candela(spotlight(table + "interpolation = \"linear\"\n"), 5, 0));
}

TEST(SpotlightFile, TablesWithPlanesAreUnfoldedAndMeetAtTheAxis) {
    const Spotlight light = spotlight(
        "edge = \"table\"\ntable = { theta = [0, 40], phi = [0, 90], "
        "values = [[100, 60], [200, 20]] }\n");
    EXPECT_NEAR(candela(light, 0, 0), 150, 1e-12);
    EXPECT_NEAR(candela(light, 40 - 1e-9, 90), 20, 1e-5);
    EXPECT_NEAR(candela(light, 40 - 1e-9, 180), 60, 1e-5);
    EXPECT_NEAR(candela(light, 40 - 1e-9, 315), 40, 1e-5);
}

TEST(SpotlightFile, TablesOfCsvFilesAreTheSame) {
    const test::TemporaryFolder folder;
    const fs::path csv = folder.path() / "beam.csv", rig = folder.path() / "rig.toml";
    std::ofstream(csv) << "# a beam\ntheta, 0, 90\r\n0, 100, 200\n\n40, 60, 20 # rim\n";
    std::ofstream(rig) << head << spot << "edge = \"table\"\nfile = \"beam.csv\"\n";
    const auto light = std::get<Spotlight>(read_rig(rig).sources.at(0));
    EXPECT_NEAR(candela(light, 0, 0), 150, 1e-12);
    EXPECT_NEAR(candela(light, 40 - 1e-9, 90), 20, 1e-5);

    const auto fault = [&](const std::string& text) {
        std::ofstream(csv) << text;
        try {
            read_intensity_csv(csv);
        } catch (const Error& error) {
            return std::string(error.what()).substr(csv.string().size());
        }
        return std::string();
    };
    EXPECT_EQ(fault("phi, 0\n"), ":1: the first row must be 'theta' and the angles phi");
    EXPECT_EQ(fault("theta, 0\n0, x\n"), ":2: \"x\" is not a number");
    EXPECT_EQ(fault("theta, 0\n\n0, 1, 2\n"), ":3: has 3 fields, the first row 2");
    EXPECT_EQ(fault("theta, 0\n1, 1\n"), ": theta must ascend from 0 to at most 180");
    EXPECT_EQ(fault("theta, 0\n0, -1\n"), ": an intensity must not be negative");
    EXPECT_EQ(fault("theta, 0\n"), ": the table has no row");
}

TEST(SpotlightFile, PatternsAreReadByTheirKind) {
    const Spotlight petals = spotlight("pattern = { kind = \"radial\", dphi = 30, q = -0.5 }\n");
    EXPECT_EQ(std::get<Petals>(petals.pattern), (Petals{12, -0.5}));
    const Spotlight dots = spotlight(
        "pattern = { kind = \"dots\", dphi = 45, dtheta = 4, q = -0.2, "
        "q_theta = 0.1, reading = \"rounded\", hue = true }\n");
    EXPECT_EQ(std::get<Dots>(dots.pattern), (Dots{45, 4, -0.2, 0.1, DotReading::rounded}));
    EXPECT_TRUE(dots.hue);
    const Spotlight hue = spotlight("pattern = { hue = true }\nspin = 12\nreference = [0, 2, 0]\n");
    EXPECT_TRUE(hue.hue);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(hue.pattern));
    EXPECT_EQ(hue.spin, 12);
    EXPECT_EQ(hue.reference, Vec3(0, 2, 0));
    EXPECT_FALSE(spotlight("shaft = false\n").shaft);
}

TEST(SpotlightFile, LuminousFluxIsThatOfTheWholeBeam) {
    for (const std::string keys :
         {"", "edge = \"sharp\"\n", "pattern = { kind = \"radial\", dphi = 90, hue = true }\n"}) {
        const Rgb lumen = luminous_flux(spotlight(keys + "luminous_flux = 700\n"));
        EXPECT_NEAR(luminance(lumen), 700, 1e-9) << keys;
    }
}

TEST(SpotlightFile, LuminairesHangDownAndCanBeTurnedAndDimmed) {
    const auto lamp = [](const std::string& keys) {
        return std::get<Luminaire>(parse_rig(head + luminaire(keys), "rig.toml").sources.at(0));
    };
    const Vec3 side(700, 100, 1800), turned(-100, 700, 1800);
    const Luminaire plain = lamp("");
    EXPECT_EQ(plain.aim, Vec3(0, 0, 2999));
    EXPECT_GT(intensity_towards(plain, side).g, 0);
    EXPECT_NEAR(intensity_towards(lamp("spin = 90\n"), turned).g, intensity_towards(plain, side).g,
                1e-9);
    EXPECT_NEAR(intensity_towards(lamp("reference = [0, 3, 0]\n"), turned).g,
                intensity_towards(plain, side).g, 1e-9);
    EXPECT_NEAR(intensity_towards(lamp("dimming = 0.25\ncolor = [1, 2, 3]\n"), side).b,
                0.75 * intensity_towards(plain, side).g, 1e-9);
    const Luminaire bright = lamp("luminous_flux = 5000\n");
    EXPECT_NEAR(luminance(bright.factor) * luminous_flux(*bright.web), 5000, 1e-9);
}

TEST(SpotlightFile, WhatIsWrongIsNamedWithItsPlace) {
    EXPECT_EQ(rig_error(spot + "edge = \"power\"\n"),
              "bad.toml:2:1: spotlight[0]: 'exponent' is missing");
    EXPECT_EQ(rig_error(spot + "exponent = 2\n"),
              "bad.toml:5:12: spotlight[0].exponent: belongs to edge = \"power\" alone");
    EXPECT_EQ(rig_error(spot + "edge = \"table\"\n"),
              "bad.toml:2:1: spotlight[0]: 'table' is missing");
    EXPECT_EQ(rig_error(spot + "edge = \"table\"\ntable = { theta = [5], values = [[1]] }\n"),
              "bad.toml:6:9: spotlight[0].table: theta must ascend from 0 to at most 180");
    EXPECT_EQ(rig_error(spot + "edge = \"table\"\ntable = { theta = [0, 5], values = [[1]] }\n"),
              "bad.toml:6:9: spotlight[0].table: needs a value for each theta");
    EXPECT_EQ(rig_error(spot + "half_angle = 120\nhalf_angle_across = 10\n"),
              "bad.toml:6:21: spotlight[0].half_angle_across: needs a half_angle of at most 89");
    EXPECT_EQ(rig_error(spot + "pattern = { kind = \"dots\", dphi = 40, dtheta = 3 }\n"),
              "bad.toml:5:35: spotlight[0].pattern.dphi: must divide 360 an even number of times, "
              "or two lit columns meet at phi = 0");
    EXPECT_EQ(rig_error(spot + "pattern = { kind = \"radial\", dphi = 7 }\n"),
              "bad.toml:5:37: spotlight[0].pattern.dphi: must divide 360, is 7");
    EXPECT_EQ(rig_error(spot + "pattern = { kind = \"radial\", dphi = 9, q = 1 }\n").substr(0, 43),
              "bad.toml:5:44: spotlight[0].pattern.q: must");
    EXPECT_EQ(rig_error(spot + "pattern = { dphi = 9 }\n"),
              "bad.toml:5:13: unknown key 'spotlight[0].pattern.dphi'");
    EXPECT_EQ(rig_error(spot + "shaft = 1\n"),
              "bad.toml:5:9: spotlight[0].shaft: must be true or false");
    EXPECT_EQ(rig_error(spot + "intensity = 5\nluminous_flux = 5\n"),
              "bad.toml:6:17: spotlight[0].luminous_flux: give either intensity or luminous_flux, "
              "not both");
    EXPECT_EQ(rig_error("[[luminaire]]\nposition = [0, 0, 0]\nfile = \"no.ies\"\n").substr(0, 34),
              "bad.toml:4:8: luminaire[0].file: n");
    EXPECT_EQ(rig_error(fog + "phase = { kind = \"henyey-greenstein\", g = 1 }\n").substr(0, 29),
              "bad.toml:7:43: fog.phase.g: m");
    EXPECT_EQ(rig_error(fog + "phase = { kind = \"isotropic\", g = 0.1 }\n"),
              "bad.toml:7:35: fog.phase.g: belongs to kind = \"henyey-greenstein\" alone");
    EXPECT_EQ(rig_error(spot + "[[window]]\ncorners = [[0, 0, 0], [0, 1, 0], [0, 0, 1]]\n"),
              "bad.toml:5:1: window: lets in no light without [sun] or [sky]");
    EXPECT_EQ(rig_error(sun + "[[window]]\ncorners = [[0, 0, 0], [0, 1, 0], [0, 2, 0]]\n"),
              "bad.toml:6:11: window[0].corners: enclose no area: they lie on a line, or "
              "sides cross");
    EXPECT_EQ(
        rig_error(sun + "[[window]]\ncorners = [[0, 0, 0], [0, 1, 0], [0, 1, 1], [0.1, 0, 1]]\n"),
        "bad.toml:6:11: window[0].corners: must lie in a plane");
    EXPECT_EQ(rig_error(sun + "[[window]]\ncorners = [[0, 0, 0], [1, 0, -1], [0, 1, 0]]\n"),
              "bad.toml:6:11: window[0].corners: the sun must not shine along the window");
}

TEST(SpotlightFile, MediaOfTwoLayersAndOfGridsAreRead) {
    const LightRig valley = parse_rig(
        head + fog +
            "layer = { height = 900, extinction_above = [0.01, 0.02, 0.03], "
            "bump = \"noise\", amplitude = 100, wavelength = 800 }\nlight_leg = \"clear\"\n",
        "rig.toml");
    const auto& layers = std::get<LayeredDensity>(valley.medium->density);
    EXPECT_EQ(layers.border.height, 900);
    EXPECT_EQ(layers.extinction_above, Rgb(0.01, 0.02, 0.03));
    EXPECT_EQ(layers.border.waves, noise_waves(100, 800));
    EXPECT_FALSE(valley.medium->dims_light_leg);

    const test::TemporaryFolder folder;
    std::ofstream(folder.path() / "smoke.txt")
        << "keiko-density/1 # by hand\nnodes 2 2 2\nlow 0 0 0\nhigh 100 100 100\n"
           "values 1 1 1 1 3 3 3 3\n";
    std::ofstream(folder.path() / "rig.toml") << head << fog << "density = \"smoke.txt\"\n";
    LightRig smoke = read_rig(folder.path() / "rig.toml");
    EXPECT_NEAR((*std::get<GridDensity>(smoke.medium->density).grid)({20, 60, 50}), 2, 1e-15);
    write_rig(folder.path() / "again.toml", smoke);
    EXPECT_NE(read_file(folder.path() / "again.toml").find("density = \"smoke.txt\""),
              std::string::npos);
    std::ofstream(folder.path() / "smoke.txt") << "keiko-density/1\nnodes 2 2 1\n";
    EXPECT_THROW(read_rig(folder.path() / "rig.toml"), Error);
}

TEST(SpotlightFile, EveryKindReadsBackBitForBit) {
    expect_round_trip(spot + "edge = \"power\"\nexponent = 2.3\nshaft = false\nspin = 7.7\n");
    expect_round_trip(spot +
                      "edge = \"polynomial\"\ncoefficients = [0.1, 0.7]\n"
                      "pattern = { kind = \"polynomial\", coefficients = [1, 0.5] }\n");
    expect_round_trip(spot +
                      "half_angle_across = 7\nreference = [0.1, 0.3, 0]\n"
                      "pattern = { kind = \"radial\", dphi = 51.42857142857143, q = 0.1 }\n");
    expect_round_trip(spot +
                      "pattern = { kind = \"dots\", dphi = 25.714285714285715, "
                      "dtheta = 0.7, hue = true }\nluminous_flux = 333\n");
    expect_round_trip(spot +
                      "edge = \"table\"\ntable = { theta = [0, 180], phi = [0, 120, 240], "
                      "values = [[0.1, 0.2], [0.1, 0.2], [0.3, 0.2]] }\n");
    expect_round_trip(luminaire("aim = [1, 2, 3]\nspin = 5\nflip_h = true\ndimming = 0.3\n"));
    expect_round_trip(sun +
                      "shaft = false\n[[window]]\ncorners = [[0, 0, 0], [0, 1, 0], [0, 0, 1]]\n");
    expect_round_trip(fog +
                      "fidelity = \"paper\"\nlight_leg = \"clear\"\n"
                      "phase = { kind = \"henyey-greenstein\", g = -0.3 }\n"
                      "layer = { height = 0.1, extinction_above = 0.2, bump = \"noise\", "
                      "amplitude = 100, wavelength = 700 }\n");
}

} // namespace keiko
