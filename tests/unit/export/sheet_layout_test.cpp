#include "keiko/drawing/sheet/sheet_layout.h"

#include "keiko/base/error.h"
#include "keiko/math/bounds.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace keiko {
namespace {

SheetView rectangle(const std::string& name, double width, double height) {
    SheetView view{name, {}, true, width, height};
    view.strokes.push_back(
        {CurveKind::edge, true, {{0, 0}, {width, 0}, {width, height}, {0, height}, {0, 0}}});
    view.strokes.push_back({CurveKind::crease, false, {{0, 0}, {width, height}}});
    return view;
}

/// Boxes of the lines of a layer, in order.
std::vector<Box2> boxes_of(const Sheet& sheet, const std::string& layer) {
    std::vector<Box2> boxes;
    for (const SheetLayer& some : sheet.layers)
        if (some.name == layer)
            for (const auto& line : some.lines) {
                boxes.emplace_back();
                for (const Vec2& point : line) boxes.back().extend(point);
            }
    return boxes;
}

bool has_text(const Sheet& sheet, const std::string& text) {
    return std::any_of(sheet.texts.begin(), sheet.texts.end(),
                       [&](const SheetText& some) { return some.text == text; });
}

TEST(SheetLayout, ScalesAreUsualOnes) {
    EXPECT_DOUBLE_EQ(usual_scale(0.07), 0.05);
    EXPECT_DOUBLE_EQ(usual_scale(0.0499), 0.02);
    EXPECT_DOUBLE_EQ(usual_scale(3), 2);
    EXPECT_DOUBLE_EQ(usual_scale(1), 1);
    EXPECT_EQ(scale_text(0.05), "1:20");
    EXPECT_EQ(scale_text(1), "1:1");
    EXPECT_EQ(scale_text(10), "10:1");
}

TEST(SheetLayout, ThreeViewsAreAlignedAndInOneScale) {
    SheetOptions options;
    options.three_views = true, options.dash_hidden = true, options.title = "body";
    const std::array views{rectangle("left", 4000, 1400), rectangle("front", 1800, 1400),
                           rectangle("top", 4000, 1800)};
    const Sheet sheet = laid_out(views, options);
    const std::vector<Box2> boxes = boxes_of(sheet, "edges");
    ASSERT_EQ(boxes.size(), 3u);
    EXPECT_DOUBLE_EQ(boxes[0].lower.y, boxes[1].lower.y); // side by side
    EXPECT_DOUBLE_EQ(boxes[0].lower.x, boxes[2].lower.x); // one below the other
    EXPECT_GT(boxes[1].lower.x, boxes[0].upper.x);
    EXPECT_LT(boxes[2].upper.y, boxes[0].lower.y);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(boxes[i].extent().x, *views[i].width / 20, 1e-9);
    EXPECT_EQ(boxes_of(sheet, "creases hidden").size(), 3u);
    EXPECT_TRUE(has_text(sheet, "scale 1:20, dimensions in mm"));
    EXPECT_TRUE(has_text(sheet, "first-angle projection"));
    EXPECT_TRUE(has_text(sheet, "1400"));
    EXPECT_TRUE(has_text(sheet, "body"));
}

TEST(SheetLayout, EverythingIsWithinThePaper) {
    std::vector<SheetView> views;
    for (const char* name : {"a", "b", "c", "d", "e"}) views.push_back(rectangle(name, 30, 90));
    views[2].parallel = false;
    const Sheet sheet = laid_out(views, {});
    const Box2 paper{Vec2(0), sheet.size};
    for (const SheetLayer& layer : sheet.layers)
        for (const auto& line : layer.lines)
            for (const Vec2& point : line) EXPECT_TRUE(paper.contains(point));
    EXPECT_TRUE(boxes_of(sheet, "creases hidden").empty()); // removed unless dashed
}

TEST(SheetLayout, AViewWithoutLinesIsAnError) {
    EXPECT_THROW(laid_out(std::vector<SheetView>{{"empty", {}}}, {}), Error);
}

} // namespace
} // namespace keiko
