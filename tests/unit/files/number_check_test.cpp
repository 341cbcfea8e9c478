#include "keiko/base/error.h"
#include "keiko/files/model/cad_text.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

std::string refusal(ModelFormat format, const std::string& text) {
    try {
        require_numbers(text, format, "m");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

std::string step(const std::string& parameters) {
    return refusal(ModelFormat::step, "ISO-10303-21;\nDATA;\n#7=AXIS();\n#12 = POINT('nan',\n" +
                                          parameters + ");\nENDSEC;\n");
}

TEST(NumberCheck, NamesLineAndEntityOfANumberThatNoDoubleHolds) {
    EXPECT_EQ(step("(0.,1E999,2.)"), "m:5: entity #12: 1E999 is no finite number");
    EXPECT_EQ(step("(0.,-1.5E+0400,2.)"), "m:5: entity #12: -1.5E+0400 is no finite number");
    EXPECT_EQ(step("(nan)"), "m:5: entity #12: nan is no finite number");
    EXPECT_EQ(step("(0.,-Infinity)"), "m:5: entity #12: -Infinity is no finite number");
    EXPECT_EQ(step("(1.#QNAN,0.)"), "m:5: entity #12: 1.#QNAN is no finite number");
    EXPECT_EQ(step("(-1.#INF)"), "m:5: entity #12: -1.#INF is no finite number");
    EXPECT_EQ(step("(" + std::string(400, '9') + ".)").substr(0, 20), "m:5: entity #12: 999");
}

TEST(NumberCheck, LetsEveryDoublePass) {
    EXPECT_EQ(step("(1.E308,-1.7976931348623157E+308,4.9E-324,1.E-999,1.E0000000000000005)"), "");
    EXPECT_EQ(step("(0." + std::string(400, '1') + ",.5,+3,-0.,1.E+99,.25E2)"), "");
    EXPECT_EQ(step("(.NAN.,.INF.,$,*,#12,NANO(1.),1.,#13)"), "") << "no numbers at all";
}

TEST(NumberCheck, NamesWhatStepDoesNotTakeForANumber) {
    const std::string reason =
        " is no number of STEP (ISO 10303-21: digits, a point, E before an exponent)";
    for (const std::string word : {"1.5e3", "1.5D3", "1E3", "1.2.3", "--1.2", "0x1p3", "1_000.",
                                   "1.E", "1.E2.5", "-.", "+", "1.5E+-3", ".5e1"})
        EXPECT_EQ(step("(0.," + word + ",2.)"), "m:5: entity #12: " + word + reason);
}

TEST(NumberCheck, LooksIntoNeitherTextsNorComments) {
    EXPECT_EQ(step("'it''s 1E999',\"0FF\",/* nan */(1.)"), "");
    EXPECT_EQ(step("'open nan"), "");
    EXPECT_EQ(step("/* open nan"), "");
}

/// A line of parameters of directory entry 41.
std::string line(const std::string& data, char section = 'P') {
    std::string text = data;
    text.resize(64, ' ');
    return text + "      41" + section + "      7\r\n";
}

TEST(NumberCheck, NamesTheDirectoryEntryOfAnIgesFile) {
    const auto iges = [](const std::string& text) { return refusal(ModelFormat::iges, text); };
    EXPECT_EQ(iges(line("header nan", 'S') + line("110,0.,1D999,2.;")),
              "m:2: entity D41: 1D999 is no finite number");
    EXPECT_EQ(iges(line("110,0.,1.D99,-2.E-999;") + line("1E999", 'T')), "");
    EXPECT_EQ(iges(line("406,1,5H1E999,3Hnan;")), "");
    const std::string tail(62, 'x');
    EXPECT_EQ(iges(line("406,1,75H" + tail.substr(7)) + line("xxxxxx nan 1E999 inf")), "")
        << "a text of 75 characters runs on";
    EXPECT_EQ(iges(line("406,1,60H" + tail.substr(7)) + line("xxxxx,inf;")),
              "m:2: entity D41: inf is no finite number");
}

TEST(NumberCheck, NamesWhatIgesDoesNotTakeForANumber) {
    const auto iges = [](const std::string& text) { return refusal(ModelFormat::iges, text); };
    EXPECT_EQ(iges(line("110,0.,1.5,2,+3.E1,-4e2,5.d-3,6D1,.5;")), "");
    for (const std::string word : {"900.1.9", "0x3p8", "--9", "9.E2.5", "1.F3", "-"})
        EXPECT_EQ(iges(line("110,0.," + word + ",2.;")),
                  "m:1: entity D41: " + word + " is no number of IGES");
}

TEST(NumberCheck, NamesTheLineOfABrepFile) {
    EXPECT_EQ(refusal(ModelFormat::brep, "CASCADE Topology V1\n1 0 0 nan \n"),
              "m:2: nan is no finite number");
    EXPECT_EQ(refusal(ModelFormat::brep, "1 0 1e200 -2e-310"), "");
}

} // namespace
} // namespace keiko
