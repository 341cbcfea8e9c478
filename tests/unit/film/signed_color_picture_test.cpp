#include "keiko/film/signed_color_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

namespace keiko {
namespace {

TEST(SignedColor, IsBlueBelowGreyAtAndRedAboveZero) {
    const Rgb below = signed_color(-0.5), zero = signed_color(0), above = signed_color(0.5);
    EXPECT_GT(below.b, below.r);
    EXPECT_GT(above.r, above.b);
    EXPECT_EQ(zero, Rgb(zero.r));
    EXPECT_EQ(signed_color(-7), signed_color(-1));
    EXPECT_EQ(signed_color(7), signed_color(1));
}

TEST(SignedColor, PictureMarksWhatIsOutOfReachAndHasALegend) {
    Image values(3, 200, 1, 0.0F);
    *values.pixel(1, 0) = std::numeric_limits<float>::infinity();
    *values.pixel(2, 0) = std::numeric_limits<float>::quiet_NaN();
    *values.pixel(2, 1) = std::numeric_limits<float>::quiet_NaN();
    Image facing(3, 200, 1, 1.0F);
    *facing.pixel(2, 1) = 0;
    const Image picture = signed_color_picture(values, facing, {-0.5, 0.5}, "mm");
    EXPECT_GT(picture.width, values.width);
    EXPECT_EQ(picture.height, values.height);
    const float* far = picture.pixel(1, 0);
    EXPECT_EQ((std::array{far[0], far[1], far[2]}), (std::array{1.0F, 0.0F, 1.0F}));
    EXPECT_FLOAT_EQ(*picture.pixel(2, 0), 0.25F); // on the body
    EXPECT_LT(*picture.pixel(2, 1), 0.1F);        // beside it
    EXPECT_GT(*picture.pixel(0, 0), 0.8F);
}

/// Zero is grey wherever it lies in the range; a range beside it begins in grey.
TEST(SignedColor, KeepsZeroGreyInUnevenRanges) {
    Image values(4, 200, 1, 0.0F);
    const std::array<float, 4> row{0.0F, 3.0F, 1.0F, -1.0F};
    std::copy(row.begin(), row.end(), values.pixel(0, 0));
    const Image facing(4, 200, 1, 1.0F);
    const auto red = [](const Image& picture, int x) {
        return picture.pixel(x, 0)[0] - picture.pixel(x, 0)[2];
    };
    const Image uneven = signed_color_picture(values, facing, {-1, 3}, "mm");
    EXPECT_EQ(red(uneven, 0), 0.0F);
    EXPECT_FLOAT_EQ(uneven.pixel(1, 0)[0], static_cast<float>(signed_color(1).r));
    EXPECT_FLOAT_EQ(uneven.pixel(3, 0)[2], static_cast<float>(signed_color(-1).b));
    const Image above = signed_color_picture(values, facing, {1, 3}, "mm");
    EXPECT_EQ(red(above, 2), 0.0F);
    EXPECT_EQ(red(above, 3), 0.0F);
    EXPECT_GT(red(above, 1), 0.3F);
}

TEST(SignedColor, ScalesAreRound) {
    EXPECT_DOUBLE_EQ(round_scale(0.00031), 0.0005);
    EXPECT_DOUBLE_EQ(round_scale(1), 1);
    EXPECT_DOUBLE_EQ(round_scale(1.2), 2);
    EXPECT_DOUBLE_EQ(round_scale(60), 100);
}

} // namespace
} // namespace keiko
