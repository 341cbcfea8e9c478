#include "keiko/compare/outlines/film_difference.h"

#include "keiko/base/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace keiko {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// 100 x 10 pixels of one face, seen squarely from 1000 mm.
Film film() {
    Film film{Image(100, 10, 3, 50.0F), Image(100, 10, 1, 1.0F), {}};
    film.aovs[Aov::normal] = Image(100, 10, 3);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 100; ++x) film.aovs[Aov::normal].pixel(x, y)[2] = 1;
    film.aovs[Aov::depth] = Image(100, 10, 1, 1000.0F);
    film.aovs[Aov::face] = Image(100, 10, 1, 7.0F);
    return film;
}

const LayerDifference& layer(const FilmDifference& difference, const std::string& name) {
    for (const LayerDifference& l : difference.layers)
        if (l.layer == name) return l;
    throw std::runtime_error("no layer " + name);
}

TEST(FilmDifference, FindsNoneBetweenEqualPictures) {
    const FilmDifference difference = film_difference(film(), film());
    EXPECT_TRUE(difference.within());
    EXPECT_EQ(difference.compared, 1000u);
    EXPECT_EQ(difference.coverage_flips + difference.face_flips, 0u);
    ASSERT_EQ(difference.layers.size(), 3u);
    for (const LayerDifference& l : difference.layers) EXPECT_EQ(l.largest, 0) << l.layer;
}

TEST(FilmDifference, JudgesColourRelativeToItsLuminance) {
    Film b = film();
    b.color.pixel(3, 2)[1] = 50.05F; // 0.1 %
    EXPECT_EQ(layer(film_difference(film(), b), "color").beyond, 0u);
    b.color.pixel(3, 2)[1] = 50.5F; // 1 %
    const FilmDifference difference = film_difference(film(), b);
    const LayerDifference& color = layer(difference, "color");
    EXPECT_EQ(color.beyond, 1u);
    EXPECT_NEAR(color.largest, 0.5, 1e-5);
    EXPECT_NEAR(color.root_mean_square, 0.5 / std::sqrt(1000), 1e-6);
    EXPECT_EQ(color.x, 3);
    EXPECT_EQ(color.y, 2);
    EXPECT_NEAR(color.excess, 0.5 / (0.01 + 2e-3 * 50.5), 1e-4);
    EXPECT_NEAR(*difference.excess.pixel(3, 2), color.excess, 1e-4);
}

TEST(FilmDifference, AllowsAShareOfThePixelsAndNoneBeyondTheHardLimit) {
    FilmTolerance tolerance;
    tolerance.color = {.relative = 0, .absolute = 1, .allowed = 2e-3, .hard = 5};
    Film b = film();
    for (int x = 0; x < 2; ++x) *b.color.pixel(x, 0) = 54;
    EXPECT_TRUE(film_difference(film(), b, tolerance).within());
    *b.color.pixel(2, 0) = 54; // the third of 1000
    EXPECT_FALSE(film_difference(film(), b, tolerance).within());
    b = film();
    *b.color.pixel(0, 0) = 56;
    EXPECT_FALSE(film_difference(film(), b, tolerance).within());
}

TEST(FilmDifference, TakesTheAngleBetweenNormals) {
    Film b = film();
    const double tilt = 0.02 * std::acos(-1.0) / 180;
    for (int x = 0; x < 100; ++x) {
        b.aovs[Aov::normal].pixel(x, 0)[0] = static_cast<float>(std::sin(tilt));
        b.aovs[Aov::normal].pixel(x, 0)[2] = static_cast<float>(std::cos(tilt));
    }
    const FilmDifference difference = film_difference(film(), b);
    EXPECT_NEAR(layer(difference, "normal").largest, 0.02, 1e-5);
    EXPECT_EQ(layer(difference, "normal").beyond, 100u);
    EXPECT_FALSE(difference.within());
}

TEST(FilmDifference, CountsSilhouetteFlipsApart) {
    Film b = film();
    *b.alpha.pixel(0, 0) = 1 - 1.0F / 16; // one sample of an outline
    *b.color.pixel(0, 0) = 10;
    *b.aovs[Aov::depth].pixel(0, 0) = infinity;
    *b.aovs[Aov::face].pixel(1, 0) = 8;
    *b.aovs[Aov::depth].pixel(1, 0) = 900;
    const FilmDifference difference = film_difference(film(), b);
    EXPECT_EQ(difference.coverage_flips, 1u);
    EXPECT_EQ(difference.face_flips, 1u);
    EXPECT_EQ(difference.compared, 998u);
    EXPECT_EQ(layer(difference, "depth").beyond, 0u);
    EXPECT_EQ(layer(difference, "color").largest, 0);
    EXPECT_TRUE(std::isinf(*difference.excess.pixel(0, 0)));
    EXPECT_TRUE(difference.within());
    *b.aovs[Aov::face].pixel(2, 0) = 8;
    EXPECT_FALSE(film_difference(film(), b).within()); // 3 of 1000
}

TEST(FilmDifference, TakesEqualInfinitiesForEqualAndOtherNumbersNot) {
    Film a = film(), b = film();
    *a.aovs[Aov::depth].pixel(0, 0) = infinity;
    EXPECT_TRUE(std::isinf(layer(film_difference(a, b), "depth").largest));
    EXPECT_FALSE(film_difference(a, b).within());
    *b.aovs[Aov::depth].pixel(0, 0) = infinity;
    EXPECT_TRUE(film_difference(a, b).within());
    *a.color.pixel(4, 4) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(film_difference(a, b).within());
    *b.color.pixel(4, 4) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(film_difference(a, b).within());
}

TEST(FilmDifference, RefusesPicturesOfDifferentSize) {
    EXPECT_THROW(film_difference(film(), Film{Image(99, 10, 3), {}, {}}), Error);
}

} // namespace
} // namespace keiko
