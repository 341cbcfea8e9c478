#include "keiko/compare/image_difference.h"

#include "keiko/base/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace keiko {
namespace {

TEST(ImageDifference, TellsChannelsApart) {
    Image a(4, 3, 2, 1.0f), b = a;
    b.pixel(2, 1)[1] += 0.5f;
    b.pixel(3, 2)[1] -= 0.25f;
    const auto difference = image_difference(a, b);
    ASSERT_EQ(difference.size(), 2u);
    EXPECT_EQ(difference[0].largest, 0);
    EXPECT_EQ(difference[0].root_mean_square, 0);
    EXPECT_EQ(difference[1].largest, 0.5);
    EXPECT_EQ(difference[1].x, 2);
    EXPECT_EQ(difference[1].y, 1);
    EXPECT_NEAR(difference[1].root_mean_square, std::sqrt((0.25 + 0.0625) / 12), 1e-15);
}

TEST(ImageDifference, TakesEqualInfinitiesAndNansForEqual) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    Image a(2, 1, 1), b(2, 1, 1);
    a.values = {infinity, nan};
    b.values = {infinity, nan};
    EXPECT_EQ(image_difference(a, b)[0].largest, 0);
    b.values = {infinity, 3};
    EXPECT_TRUE(std::isinf(image_difference(a, b)[0].largest));
    EXPECT_EQ(image_difference(a, b)[0].x, 1);
}

TEST(ImageDifference, RefusesPicturesOfDifferentShape) {
    EXPECT_THROW(image_difference(Image(2, 3, 1), Image(3, 2, 1)), Error);
    EXPECT_THROW(image_difference(Image(2, 3, 1), Image(2, 3, 3)), Error);
}

} // namespace
} // namespace keiko
