#include "keiko/film/stereo_film.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

/// A film of 2 x 2 pixels whose numbers start at `first`, with a layer.
Film film_of(float first) {
    Film film{Image(2, 2, 3), Image(2, 2, 1), {}};
    for (float& value : film.color.values) value = first++;
    for (float& value : film.alpha.values) value = first++ / 100;
    film.aovs.emplace(Aov::depth, Image(2, 2, 1, first));
    return film;
}

TEST(StereoFilm, SideBySideHasBothFilmsAndTheirLayers) {
    const Film left = film_of(1), right = film_of(40), both = side_by_side(left, right);
    ASSERT_EQ(both.color.width, 4);
    ASSERT_EQ(both.color.height, 2);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 2; ++x) {
            for (int c = 0; c < 3; ++c) {
                EXPECT_EQ(both.color.pixel(x, y)[c], left.color.pixel(x, y)[c]);
                EXPECT_EQ(both.color.pixel(2 + x, y)[c], right.color.pixel(x, y)[c]);
            }
            EXPECT_EQ(*both.alpha.pixel(2 + x, y), *right.alpha.pixel(x, y));
            EXPECT_EQ(*both.aovs.at(Aov::depth).pixel(x, y), 17);
            EXPECT_EQ(*both.aovs.at(Aov::depth).pixel(2 + x, y), 56);
        }
}

TEST(StereoFilm, AnaglyphHasTheLeftLuminanceInRedAndTheRightEyesCyan) {
    const Film left = film_of(1), right = film_of(40), both = anaglyph(left, right);
    const float* l = left.color.pixel(1, 0);
    const float* r = right.color.pixel(1, 0);
    EXPECT_FLOAT_EQ(both.color.pixel(1, 0)[0], 0.2126F * l[0] + 0.7152F * l[1] + 0.0722F * l[2]);
    EXPECT_EQ(both.color.pixel(1, 0)[1], r[1]);
    EXPECT_EQ(both.color.pixel(1, 0)[2], r[2]);
    EXPECT_EQ(*both.alpha.pixel(1, 0), *right.alpha.pixel(1, 0));
    EXPECT_EQ(*anaglyph(right, left).alpha.pixel(1, 0), *right.alpha.pixel(1, 0));
    EXPECT_TRUE(both.aovs.empty());
}

} // namespace
} // namespace keiko
