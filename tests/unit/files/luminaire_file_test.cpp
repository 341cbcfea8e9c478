#include "keiko/files/photometric/luminaire_file.h"

#include "keiko/base/error.h"
#include "keiko/light/rig/luminaire_remarks.h"
#include "keiko/light/spotlight/beam_spread.h"
#include "keiko/light/spotlight/luminous_flux.h"

#include "tests/support/oracle.h"
#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <map>

namespace keiko {
namespace {

const std::string head = "IESNA:LM-63-2002\n[LUMINAIRE] spot\nTILT=NONE\n";
/// Lines 4 to 7: two planes that mirror to a full turn.
const std::string whole = head + "1 -1 2 3 2 1 2 0.1 0.2 0\n1 1 10\n0 45 90 0, 90\n1 2 3\n4 5 6\n";

std::string ies_error(const std::string& text) {
    try {
        parse_ies(text, "x.ies");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

/// Isym 1 or 4 of four planes, two angles, one lamp set of 2000 lm.
std::string eulumdat(const std::string& symmetry, const std::string& values) {
    std::string text = "maker\n1\n" + symmetry + "\n4\n90\n2\n90\nreport\nlamp\nno\nfile\ndate\n";
    for (int i = 0; i < 9; ++i) text += "100\n";
    text += "100\n80\n1,0\n0\n1\n1\nLED\n2000\n3000\n90\n15\n";
    for (int i = 0; i < 10; ++i) text += "0.5\n";
    return text + "0\n90\n180\n270\n0\n90\n" + values;
}

std::string eulumdat_error(const std::string& text) {
    try {
        parse_eulumdat(text, "x.ldt");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST(LuminaireFile, AgreesWithOracle) {
    const test::OracleTable table("photometric_lookup");
    test::WorstError worst("I"), angles("I by angles");
    std::map<std::string, PhotometricWeb> webs;
    for (const auto& row : table) {
        const std::string& file = row.text("in.file");
        if (!webs.contains(file))
            webs.emplace(
                file,
                read_luminaire(test::repository("tests/data/oracle/photometric_files/" + file)));
        const PhotometricWeb& web = webs.at(file);
        const std::string& kind = row.text("in.kind");
        EXPECT_EQ(web.type, kind == "A"   ? PhotometricType::a
                            : kind == "B" ? PhotometricType::b
                                          : PhotometricType::c)
            << row.id();
        const double expected = row.number("out.I_cd");
        worst.compare(row, intensity(web, row.unit("in.dir")), expected, 1e-11);
        const Vec3 way = web_direction(web.type, row.number("in.V_deg"), row.number("in.H_deg"));
        angles.compare(row, intensity(web, way), expected, 1e-11);
    }
    EXPECT_EQ(webs.size(), 13u);
}

TEST(LuminaireFile, ReadsWhatAnIesFileTells) {
    const PhotometricWeb web = parse_ies(whole, "x.ies");
    EXPECT_EQ(web.name, "spot");
    EXPECT_EQ(web.type, PhotometricType::c);
    EXPECT_EQ(web.candela.symmetry(), PlaneSymmetry::quadrant);
    EXPECT_EQ(web.candela(45, 180), 4);
    EXPECT_EQ(web.candela(90, 270), 12);
    EXPECT_EQ(web.lamp_flux, 0);
    EXPECT_EQ(web.opening, Vec3(200, 100, 0));
    const PhotometricWeb relative = parse_ies(
        replaced(replaced(whole, "1 -1 2", "2 500 0.5"), "1 2 0.1 0.2 0", "1 1 -1 0 0"), "x.ies");
    EXPECT_EQ(relative.lamp_flux, 1000);
    EXPECT_EQ(relative.candela(45, 0), 1);
    EXPECT_EQ(relative.opening, Vec3(304.8, 304.8, 0));
}

TEST(LuminaireFile, FilesOf1986HaveNoFirstLineOfTheirOwn) {
    EXPECT_EQ(parse_ies(whole.substr(whole.find("TILT")), "x.ies").candela.largest(), 12);
    EXPECT_EQ(
        parse_ies("a lamp\r\nof two lines\r\n" + whole.substr(whole.find("TILT")), "x.ies").name,
        "");
}

TEST(LuminaireFile, TheFactorOfALampThatIsNotTiltedCounts) {
    const std::string tilt = "1\n3\n0 45 90\n0.8 0.7 0.6\n";
    EXPECT_EQ(parse_ies(replaced(whole, "NONE\n", "INCLUDE\n" + tilt), "x.ies").candela(0, 0), 1.6);
    const test::TemporaryFolder folder;
    folder.file("lamp.tlt", tilt);
    const auto file = folder.file("x.IES", replaced(whole, "NONE", "lamp.tlt"));
    EXPECT_EQ(read_luminaire(file).candela(0, 0), 1.6);
    EXPECT_EQ(ies_error(replaced(whole, "NONE", "../lamp.tlt")),
              "x.ies:3: TILT= must be followed by NONE, INCLUDE or the name of a file beside it");
    folder.file("lamp.tlt", "1\n2\n0 45\n0.8 -0.7\n");
    try {
        read_luminaire(file);
        ADD_FAILURE() << "a negative factor was taken";
    } catch (const Error& error) {
        EXPECT_EQ(error.what(),
                  (folder.path() / "lamp.tlt").string() + ":4: a tilt factor must not be negative");
    }
}

TEST(LuminaireFile, FlawsOfIesFilesAreNamedWithTheirLine) {
    EXPECT_EQ(ies_error("IESNA91\nno more\n"),
              "x.ies:2: there is no line TILT=, as every IES LM-63 file has");
    EXPECT_EQ(ies_error(head), "x.ies:4: the file ends before the number of lamps");
    EXPECT_EQ(ies_error(whole.substr(0, whole.size() - 3)),
              "x.ies:8: the file ends before an intensity");
    EXPECT_EQ(ies_error(whole + "7\n"), "x.ies:9: more numbers than the counts say");
    EXPECT_EQ(ies_error(replaced(whole, "4 5 6", "4 five 6")),
              "x.ies:8: expected an intensity, found \"five\"");
    EXPECT_EQ(ies_error(replaced(whole, "4 5 6", "4 -5 6")),
              "x.ies:8: an intensity must not be negative");
    EXPECT_EQ(ies_error(replaced(whole, "4 5 6", "4 nan 6")),
              "x.ies:8: expected an intensity, found \"nan\"");
    EXPECT_EQ(ies_error(replaced(whole, "0 45 90 0", "0 95 90 0")),
              "x.ies:6: vertical angles must ascend");
    EXPECT_EQ(ies_error(replaced(whole, "0 45 90 0", "0 45 190 0")),
              "x.ies:6: vertical angles must be from 0 to 180 degrees");
    EXPECT_EQ(ies_error(replaced(whole, "0, 90", "0, 80")),
              "x.ies:6: no symmetry completes these horizontal angles to a full turn");
    EXPECT_EQ(ies_error(replaced(whole, "3 2 1 2", "3 2 4 2")),
              "x.ies:4: the photometric type must be from 1 to 3");
    EXPECT_EQ(ies_error(replaced(whole, "3 2 1 2", "3.5 2 1 2")),
              "x.ies:4: the number of vertical angles is no count that the file can hold");
    EXPECT_EQ(ies_error(replaced(whole, "3 2 1 2", "3 1e9 1 2")),
              "x.ies:4: the number of horizontal angles is no count that the file can hold");
    EXPECT_EQ(ies_error(replaced(whole, "1 1 10", "0 1 10")),
              "x.ies:5: the ballast factor must be above 0");
}

TEST(LuminaireFile, ReadsWhatAnEulumdatFileTells) {
    const PhotometricWeb axial = parse_eulumdat(eulumdat("1", "100\n50,5\n"), "x.ldt");
    EXPECT_EQ(axial.name, "lamp");
    EXPECT_EQ(axial.lamp_flux, 2000);
    EXPECT_EQ(axial.candela(90, 77), 101);
    EXPECT_EQ(axial.opening, Vec3(100, 100, 100));
    const PhotometricWeb absolute =
        parse_eulumdat(replaced(eulumdat("1", "100\n50\n"), "1\nLED", "-1\nLED"), "x.ldt");
    EXPECT_EQ(absolute.lamp_flux, 0);
    EXPECT_EQ(absolute.candela(0, 0), 200);
    const PhotometricWeb quarter = parse_eulumdat(eulumdat("4", "1\n2\n3\n4\n"), "x.ldt");
    EXPECT_EQ(quarter.candela(90, 0), 4);
    EXPECT_EQ(quarter.candela(90, 270), 8);
    // Stored from C270 over C0 to C90.
    const PhotometricWeb across = parse_eulumdat(eulumdat("3", "1\n2\n3\n4\n5\n6\n"), "x.ldt");
    EXPECT_EQ(across.candela(90, 270), 4);
    EXPECT_EQ(across.candela(90, 0), 8);
    EXPECT_EQ(across.candela(90, 180), 8);
    EXPECT_EQ(across.candela(90, 90), 12);
}

TEST(LuminaireFile, FlawsOfEulumdatFilesAreNamedWithTheirLine) {
    const std::string good = eulumdat("1", "100\n50\n");
    EXPECT_EQ(eulumdat_error("maker\n1\n7\n"),
              "x.ldt:3: the symmetry must be a whole number from 0 to 4");
    EXPECT_EQ(eulumdat_error("maker\n1\n1\n"),
              "x.ldt:4: the file ends before the number of C planes");
    EXPECT_EQ(eulumdat_error(eulumdat("1", "100\n")),
              "x.ldt:50: the file ends before an intensity");
    EXPECT_EQ(eulumdat_error(good + "\n7\n"), "x.ldt:52: more lines than the counts say");
    EXPECT_EQ(eulumdat_error(eulumdat("1", "100\nx\n")),
              "x.ldt:50: expected an intensity, found \"x\"");
    EXPECT_EQ(eulumdat_error(eulumdat("1", "100\n-1\n")),
              "x.ldt:50: an intensity must not be negative");
    EXPECT_EQ(
        eulumdat_error(replaced(eulumdat("4", "1\n2\n3\n4\n"), "90\n180\n270", "80\n180\n270")),
        "x.ldt:46: the C angles do not fit the file's symmetry");
    EXPECT_EQ(eulumdat_error(replaced(good, "180\n270", "270\n180")),
              "x.ldt:46: C angles must ascend");
}

TEST(LuminaireFile, RealFilesAreReadWithPlausibleFlux) {
    KEIKO_NEEDS_SHARED_MODEL("light-road.ldt");
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::shared_model(""))) {
        if (!is_luminaire_file(entry.path())) continue;
        const PhotometricWeb web = read_luminaire(entry.path());
        const double flux = luminous_flux(web);
        EXPECT_GT(flux, 100) << entry.path();
        EXPECT_LT(flux, 40000) << entry.path();
        ++files;
    }
    EXPECT_EQ(files, 20);
}

TEST(LuminaireFile, FluxOfRealFilesIsTheOneTheirMakersTell) {
    KEIKO_NEEDS_SHARED_MODEL("light-road.ldt");
    const auto flux = [](const char* name) {
        return luminous_flux(read_luminaire(test::shared_model(name)));
    };
    // Lamp flux times light output ratio; lumens in the text of the file.
    EXPECT_NEAR(flux("light-road.ldt"), 33200 * 0.8442, 0.02 * 33200);
    EXPECT_NEAR(flux("light-fluorescent-lamp.ldt"), 8100 * 0.403, 0.02 * 8100);
    EXPECT_NEAR(flux("light-bega-24-planes-to-345.ies"), 1221, 0.02 * 1221);
    EXPECT_NEAR(flux("light-bega-garden-axial.ies"), 321, 0.02 * 321);
}

TEST(LuminaireFile, ReadsWhatAnEulumdatHeaderStatesOfTheFlux) {
    const StatedFlux stated = parse_eulumdat(eulumdat("1", "100\n50,5\n"), "x.ldt").stated;
    EXPECT_EQ(stated.output_ratio, 0.8);
    EXPECT_EQ(stated.downward_share, 1.0);
    EXPECT_EQ(stated.reference, 2000);
    for (const char* none : {"0", "", "n/a"}) {
        const std::string text = replaced(eulumdat("1", "100\n50,5\n"), "100\n80\n1,0",
                                          std::string("100\n") + none + "\n1,0");
        EXPECT_FALSE(parse_eulumdat(text, "x.ldt").stated.output_ratio) << none;
    }
}

TEST(LuminaireFile, BeamsOfRealFilesAreNoWiderThanTheirFields) {
    KEIKO_NEEDS_SHARED_MODEL("light-road.ldt");
    for (const auto& entry : std::filesystem::directory_iterator(test::shared_model(""))) {
        if (!is_luminaire_file(entry.path())) continue;
        const PhotometricWeb web = read_luminaire(entry.path());
        for (const double plane : {0.0, 90.0}) {
            const auto beam = beam_spread(web, 0.5, plane), field = beam_spread(web, 0.1, plane);
            ASSERT_TRUE(beam && field) << entry.path();
            EXPECT_LE(beam->positive.angle, field->positive.angle) << entry.path();
            EXPECT_LE(beam->negative.angle, field->negative.angle) << entry.path();
            EXPECT_LE(field->positive.angle, web.candela.vertical().back()) << entry.path();
            EXPECT_TRUE(!beam->full_angle() || *beam->full_angle() < 180) << entry.path();
        }
    }
    const auto field = beam_spread(
        read_luminaire(test::shared_model("light-symmetry-to-c0c90c180c270.ldt")), 0.1, 90);
    EXPECT_EQ(field->positive, (SpreadEdge{90, false}));
    EXPECT_EQ(field->negative, (SpreadEdge{90, false}));
}

TEST(LuminaireFile, RealHeadersThatTheirTablesContradictAreRemarked) {
    KEIKO_NEEDS_SHARED_MODEL("light-road.ldt");
    const auto remarks = [](const char* name) {
        return flux_contradictions(name, read_luminaire(test::shared_model(name))).size();
    };
    EXPECT_EQ(remarks("light-road.ldt"), 0u);
    EXPECT_EQ(remarks("light-relative-photometry-with-multiplier.ies"), 1u);
}

} // namespace keiko
