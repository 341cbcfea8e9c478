#include "keiko/scene/face_selection.h"

#include "keiko/base/error.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

TEST(FaceColor, IsReadAndWrittenInHexadecimal) {
    const FaceColor color = FaceColor::parse("#C0a00f");
    EXPECT_EQ(color.parts, (std::array<std::uint8_t, 3>{0xc0, 0xa0, 0x0f}));
    EXPECT_EQ(color.text(), "#c0a00f");
    for (const char* wrong :
         {"", "#", "red", "c0a00f0", "#c0a00", "#c0a00f0", "#c0a0 f", "#c0a00g"})
        EXPECT_THROW(FaceColor::parse(wrong), Error) << wrong;
}

TEST(FaceColor, OfLinearPartsIsThatOfTheScreen) {
    EXPECT_EQ(FaceColor::of(Rgb(0, 0.5, 1)).text(), "#00bcff"); // 0.5 is shown as 0.7354
    EXPECT_EQ(FaceColor::of(Rgb(-0.1, 0.001, 1.1)).text(), "#0003ff");
}

TEST(FaceSelection, IsStatedInWords) {
    FaceSelection selection;
    EXPECT_TRUE(selection.is_empty());
    EXPECT_EQ(selection.text(), "");
    selection.faces = {"roof*", "12"}, selection.layers = {"SKIN"};
    selection.colors = {FaceColor::parse("#ff0000")};
    selection.box = Box3{Vec3(0, -1.5, 0), Vec3(100, 20, 3)}, selection.visible = 0.25;
    EXPECT_FALSE(selection.is_empty());
    EXPECT_EQ(selection.text(),
              "faces roof*, 12, layers SKIN, colors #ff0000, box (0, -1.5, 0) to (100, 20, 3) mm, "
              "visible on at least 25 % of their area");
}

TEST(FaceSelection, DiffersInAnyCondition) {
    FaceSelection selection, boxed;
    boxed.box = Box3{Vec3(0), Vec3(1)};
    EXPECT_NE(selection, boxed);
    selection.box = Box3{Vec3(0), Vec3(2)};
    EXPECT_NE(selection, boxed);
    selection.box = boxed.box;
    EXPECT_EQ(selection, boxed);
}

TEST(Scope, IsStatedInWords) {
    Scope scope;
    EXPECT_TRUE(scope.is_whole());
    scope.zones = {"A"};
    EXPECT_EQ(scope.text(), "zone A");
    scope.zones = {"A", "B"}, scope.selection.layers = {"1"};
    EXPECT_EQ(scope.text(), "layers 1, zones A, B");
    EXPECT_FALSE(scope.is_whole());
}

} // namespace
} // namespace keiko
