#include "keiko/export/page_drawing.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace keiko {
namespace {

SheetView rectangle(const std::string& name, double width, double height) {
    SheetView view{name, {}, true, width, height};
    view.strokes.push_back(
        {CurveKind::edge, true, {{0, 0}, {width, 0}, {width, height}, {0, height}, {0, 0}}});
    return view;
}

bool has(const std::string& svg, const std::string& text) {
    return svg.find(text) != std::string::npos;
}

TEST(PageDrawing, ThreeViewsShareTheWidthInOneScale) {
    // 1000 units less margins of 28 and a gap of 56 are for 4000 + 1800 mm: 0.153103 of a unit
    // each.
    const std::array views{rectangle("left", 4000, 1400), rectangle("front", 1800, 1400),
                           rectangle("top", 4000, 1800)};
    const std::string svg = page_drawing(views, {});
    EXPECT_TRUE(has(svg, "d=\"M28 242.3l612.4 0 0 -214.3 -612.4 0 0 214.3\"")) << svg;
    EXPECT_TRUE(has(svg, "d=\"M696.4 242.3l275.6 0 0 -214.3 -275.6 0 0 214.3\"")) << svg;
    EXPECT_TRUE(has(svg, "d=\"M28 573.9l612.4 0 0 -275.6 -612.4 0 0 275.6\"")) << svg;
    EXPECT_TRUE(has(svg, ">4000.0 × 1400.0 mm<")) << svg;
}

TEST(PageDrawing, HiddenLinesAreAClassOfTheirOwnWithoutHiddenSeams) {
    SheetView view = rectangle("left", 100, 50);
    view.strokes.push_back({CurveKind::crease, false, {{0, 0}, {100, 50}}});
    view.strokes.push_back({CurveKind::seam, false, {{0, 50}, {100, 0}}});
    const std::string svg = page_drawing({&view, 1}, {});
    EXPECT_TRUE(has(svg, "class=\"edges\""));
    EXPECT_TRUE(has(svg, "class=\"creases hidden\""));
    EXPECT_FALSE(has(svg, "class=\"seams"));
}

TEST(PageDrawing, MarksThatWouldCoverEachOtherAreOneInTheWorstTone) {
    SheetView view = rectangle("left", 100, 50);
    view.marks = {
        {{10, 10}, 1, true}, {{10.1, 10}, 2, false}, {{90, 40}, 3, false}, {{11, 10}, 4, true}};
    const std::array<std::string, 4> tones{"undecided", "fail", "undecided", "undecided"};
    const std::string svg = page_drawing({&view, 1}, tones);
    EXPECT_TRUE(
        has(svg, "href=\"#finding-1\" class=\"mark fail\"><title>findings 1, 2, 4</title>"));
    EXPECT_TRUE(has(svg, ">1 +2</text>"));
    EXPECT_FALSE(has(svg, "#finding-2"));
    EXPECT_TRUE(
        has(svg, "href=\"#finding-3\" class=\"mark undecided hidden\"><title>finding 3, hidden<"));
}

} // namespace
} // namespace keiko
