#include "keiko/maps/picture_texture.h"

#include "keiko/film/image_file.h"

#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace keiko {
namespace {

Image waves(int width, int height) {
    Image image(width, height, 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            *image.pixel(x, y) =
                static_cast<float>(0.5 + 0.3 * std::sin(2 * std::numbers::pi * (x + 0.5) / width) *
                                             std::cos(2 * std::numbers::pi * (y + 0.5) / height));
    return image;
}

TEST(PictureTexture, RepeatsBeyondItsBorders) {
    const PictureTexture texture(waves(16, 12));
    const double here = texture.value({Vec3(0.03, 0.98, 0)}).g;
    EXPECT_NEAR(texture.value({Vec3(5.03, -2.02, 0)}).g, here, 1e-9);
    EXPECT_NEAR(here, (texture.value({Vec3(0.03 - 1, 0.98 - 1, 0)}).g), 1e-9);
}

TEST(PictureTexture, ClampsWhereItIsTold) {
    Image image(2, 1, 1);
    image.values = {0.25F, 0.75F};
    const PictureTexture texture(image, Wrap::clamp, Wrap::clamp);
    EXPECT_EQ(texture.value({Vec3(-3, 0.5, 0)}).r, 0.25);
    EXPECT_EQ(texture.value({Vec3(0.5, 9, 0)}).r, 0.5);
    EXPECT_EQ(texture.value({Vec3(2, 0.5, 0)}).r, 0.75);
}

/// A picture of odd size keeps its mean in every smaller version.
TEST(PictureTexture, WidePixelsShowTheMean) {
    Image image = waves(37, 21);
    *image.pixel(5, 5) = 40;
    double mean = 0;
    for (const float v : image.values)
        mean += static_cast<double>(v) / static_cast<double>(image.values.size());
    const PictureTexture texture(image);
    EXPECT_NEAR(texture.value({Vec3(0.2, 0.7, 0), Vec3(3, 0, 0), Vec3(0, 3, 0)}).g, mean, 1e-6);
}

/// Stripes across a long pixel are averaged, those along it stay.
TEST(PictureTexture, LongPixelsBlurAlongThemselvesOnly) {
    Image image(64, 64, 1);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) *image.pixel(x, y) = static_cast<float>(x / 8 % 2);
    const PictureTexture texture(image);
    const Vec3 thin(1 / 64.0, 0, 0), tall(0, 0.12, 0), wide(0.5, 0, 0), low(0, 1 / 64.0, 0);
    EXPECT_NEAR(texture.value({Vec3(12.0 / 64, 0.4, 0), thin, tall}).g, 1, 1e-6);
    EXPECT_NEAR(texture.value({Vec3(12.0 / 64, 0.4, 0), wide, low}).g, 0.5, 0.05);
}

TEST(PictureTexture, ReadsSrgbAsLinearLight) {
    const test::TemporaryFolder folder;
    Image grey(1, 1, 3, static_cast<float>(188.0 / 255));
    write_png(folder.path() / "grey.png", grey);
    EXPECT_NEAR(read_linear_image(folder.path() / "grey.png", true).values[0], 0.5029, 1e-3);
    EXPECT_NEAR(read_linear_image(folder.path() / "grey.png", false).values[0], 188.0 / 255, 1e-6);
}

TEST(PictureTexture, RefusesPixelsThatAreNoNumbers) {
    const test::TemporaryFolder folder;
    Film film{Image(1, 1, 3, std::numeric_limits<float>::quiet_NaN()), {}, {}};
    write_film(folder.path() / "nan.exr", film);
    EXPECT_THROW(read_linear_image(folder.path() / "nan.exr", false), std::exception);
}

} // namespace
} // namespace keiko
