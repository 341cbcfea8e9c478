#include "keiko/report/content/comparison.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace keiko {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Comparison same_parts() {
    Comparison c;
    c.tool_version = "9.9";
    c.before = "a <1>.step", c.after = "b.step";
    c.faces_before = {"face 1"}, c.faces_after = {"face 1 (\"roof\")"};
    c.deviation.faces.resize(1);
    c.deviation.faces[0].partner = 0;
    c.missing.faces = c.deviation.faces;
    LineShift line;
    line.length = 100, line.largest = 0.05;
    c.views = {{.picture = {.view = "front", .pixels = 4, .layers = {{.layer = "color"}}},
                .lines = {line}}};
    return c;
}

bool within(const Comparison& c, const std::string& name) {
    for (const ComparisonCheck& check : comparison_checks(c))
        if (check.name == name) return check.within;
    ADD_FAILURE() << name;
    return false;
}

TEST(Comparison, IsTheSameWithinItsTolerances) {
    EXPECT_TRUE(same_parts().same());
}

TEST(Comparison, EveryCheckCanFailOnItsOwn) {
    const auto fails = [](const std::string& check, const auto& change) {
        Comparison c = same_parts();
        change(c);
        EXPECT_FALSE(within(c, check)) << check;
        EXPECT_FALSE(c.same()) << check;
    };
    fails("deviation", [](Comparison& c) { c.deviation.worst.value = -0.001; });
    fails("missing", [](Comparison& c) { c.missing.worst.value = infinity; });
    fails("normals", [](Comparison& c) { c.missing.worst_normal.value = 0.02; });
    fails("borders", [](Comparison& c) { c.deviation.worst_border.value = 0.002; });
    fails("faces", [](Comparison& c) { c.missing.faces[0].beside = 0.8; });
    fails("faces", [](Comparison& c) { c.deviation.faces[0].turned = 1; });
    fails("seams", [](Comparison& c) {
        c.seams.removed = {0};
        c.inspection_before.seams.resize(1);
    });
    fails("findings", [](Comparison& c) { c.seams.new_findings.resize(1); });
    fails("front: lines", [](Comparison& c) { c.views[0].lines[0].largest = 0.2; });
    fails("front: lines", [](Comparison& c) { c.views[0].lines[0].alone = 50; });
}

TEST(Comparison, PicturesThatDifferMakePartsDifferent) {
    Comparison c = same_parts();
    c.views[0].picture.layers[0].within = false;
    EXPECT_FALSE(c.same());
    EXPECT_NE(comparison_junit(c).find("failures=\"1\""), std::string::npos);
}

TEST(Comparison, MarksADeviationThatAloneIsBeyondWhatIsAllowed) {
    Comparison c = same_parts();
    EXPECT_EQ(comparison_text(c).find("! "), std::string::npos);
    c.deviation.worst.value = -0.001;
    const std::string text = comparison_text(c);
    EXPECT_EQ(text.find("different\n! deviation of b.step: at most 0.001 mm at "), 0u) << text;
    EXPECT_NE(text.find("; 0.0005 mm allowed; "), std::string::npos) << text;
    EXPECT_NE(text.find("\n  deviation of a"), std::string::npos) << text;
    c.deviation.beyond = 1;
    EXPECT_EQ(comparison_text(c).find("different\n! deviation of b.step: everywhere "), 0u);
}

TEST(Comparison, TellsWhatIsBeyondReachInWords) {
    Comparison c = same_parts();
    c.deviation.worst.value = infinity, c.deviation.reach = 50, c.deviation.beyond = 0.25;
    EXPECT_NE(comparison_text(c).find("b.step: further than 50 mm at"), std::string::npos);
    EXPECT_NE(comparison_html(c).find("further than 50 mm"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(comparison_json(c))["deviation"]["worst"]["value"], "inf");
}

TEST(Comparison, EscapesNames) {
    const std::string html = comparison_html(same_parts()), xml = comparison_junit(same_parts());
    EXPECT_NE(html.find("a &lt;1&gt;.step"), std::string::npos);
    EXPECT_EQ(html.find("<1>"), std::string::npos);
    EXPECT_NE(xml.find("a &lt;1&gt;.step"), std::string::npos);
}

} // namespace
} // namespace keiko
