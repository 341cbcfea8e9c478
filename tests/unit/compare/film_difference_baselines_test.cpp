/// Holds film_difference, which lets OpenImageIO do the arithmetic in floats, to its definition in
/// plain loops of doubles, on the pictures of the fixtures' baselines.

#include "keiko/compare/outlines/film_difference.h"
#include "keiko/film/image_file.h"
#include "keiko/math/vec.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <random>

namespace keiko {
namespace {
namespace fs = std::filesystem;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Every view of every baseline.
std::vector<Film> baseline_films() {
    std::map<std::string, std::map<std::string, NamedImage>> views; // by path without layer
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(KEIKO_SOURCE_DIR) / "surfaces" / "baselines")) {
        if (entry.path().extension() != ".exr") continue;
        const fs::path view_and_layer = entry.path().parent_path() / entry.path().stem();
        views[view_and_layer.parent_path() / view_and_layer.stem()]
             [view_and_layer.extension().string().substr(1)] = read_image(entry.path());
    }
    std::vector<Film> films;
    for (const auto& [view, layers] : views) films.push_back(film_of(layers));
    return films;
}

/// Values changed by anything from a rounding to a multiple; some are no numbers, some faces and
/// outlines are others.
class Disturbance {
public:
    void disturb(Film& film) {
        for (float& value : film.color.values) disturb(value);
        for (float& value : film.alpha.values)
            if (one_in(200)) value *= 0.5F;
        for (auto& [aov, image] : film.aovs)
            for (float& value : image.values) {
                if (aov != Aov::face)
                    disturb(value);
                else if (one_in(200))
                    value += 1;
            }
    }

private:
    bool one_in(unsigned count) { return random_() % count == 0; }
    void disturb(float& value) {
        if (one_in(4)) return;
        const double exponent = -9.0 * static_cast<double>(random_()) / 4294967295.0;
        const double change = std::pow(10.0, exponent) * (one_in(2) ? 1 : -1);
        value = static_cast<float>(double{value} * (1 + change));
        if (one_in(5000)) value = std::numeric_limits<float>::quiet_NaN();
        if (one_in(5000)) value = std::numeric_limits<float>::infinity();
    }
    std::mt19937 random_{8};
};

struct Apart {
    double distance = 0, size = 0;
};

Apart apart_by_channel(const float* a, const float* b, int channels) {
    Apart apart;
    for (int c = 0; c < channels; ++c) {
        for (const float value : {a[c], b[c]})
            if (std::isfinite(value)) apart.size = std::max(apart.size, std::abs(double{value}));
        if (a[c] == b[c] || (std::isnan(a[c]) && std::isnan(b[c]))) continue;
        const double distance = std::abs(double{a[c]} - double{b[c]});
        apart.distance = std::max(apart.distance, std::isnan(distance) ? infinity : distance);
    }
    return apart;
}

Apart apart_by_angle(const float* a, const float* b, int) {
    const double angle = angle_between({a[0], a[1], a[2]}, {b[0], b[1], b[2]}) * 180 / M_PI;
    return {std::isnan(angle) ? infinity : angle, 0};
}

bool is_flip(const Film& a, const Film& b, std::size_t pixel) {
    const double covered_a = a.alpha.values[pixel], covered_b = b.alpha.values[pixel];
    const bool outline = std::abs(covered_a - covered_b) > 1.0 / 32;
    return outline || a.aovs.at(Aov::face).values[pixel] != b.aovs.at(Aov::face).values[pixel];
}

using Measure = Apart (*)(const float*, const float*, int);

LayerDifference reference(const Film& a, const Film& b, const Image& of_a, const Image& of_b,
                          const LayerTolerance& tolerance, Measure measure) {
    LayerDifference found;
    double squares = 0, compared = 0;
    for (int y = 0; y < of_a.height; ++y)
        for (int x = 0; x < of_a.width; ++x) {
            if (is_flip(a, b, static_cast<std::size_t>(y * of_a.width + x))) continue;
            const Apart apart = measure(of_a.pixel(x, y), of_b.pixel(x, y), of_a.channels);
            const double allowed = tolerance.absolute + tolerance.relative * apart.size;
            const double excess = apart.distance / allowed;
            found.beyond += excess > 1;
            found.largest = std::max(found.largest, apart.distance);
            if (excess > found.excess) found.excess = excess, found.x = x, found.y = y;
            squares += apart.distance * apart.distance;
            compared += 1;
        }
    found.root_mean_square = std::sqrt(squares / compared);
    found.within = static_cast<double>(found.beyond) <= tolerance.allowed * compared &&
                   found.excess <= tolerance.hard;
    return found;
}

/// Within the roundings of floats.
void expect_near(double found, double expected, const std::string& what) {
    if (std::isinf(expected))
        EXPECT_EQ(found, expected) << what;
    else
        EXPECT_NEAR(found, expected, 1e-6 * expected) << what;
}

void expect_same(const LayerDifference& found, const LayerDifference& expected) {
    EXPECT_EQ(found.beyond, expected.beyond) << found.layer;
    EXPECT_EQ(found.within, expected.within) << found.layer;
    EXPECT_EQ(found.x, expected.x) << found.layer;
    EXPECT_EQ(found.y, expected.y) << found.layer;
    expect_near(found.largest, expected.largest, found.layer + " largest");
    expect_near(found.excess, expected.excess, found.layer + " excess");
    expect_near(found.root_mean_square, expected.root_mean_square, found.layer + " rms");
}

struct LayerCase {
    Aov aov;
    LayerTolerance tolerance;
    Measure measure;
};

/// How many layers were compared.
std::size_t expect_definition(const Film& a, const Film& b, const FilmTolerance& tolerance) {
    const FilmDifference found = film_difference(a, b, tolerance);
    expect_same(found.layers.at(0),
                reference(a, b, a.color, b.color, tolerance.color, apart_by_channel));
    std::size_t next = 1;
    for (const LayerCase& layer : {LayerCase{Aov::normal, tolerance.normal, apart_by_angle},
                                   {Aov::uv, tolerance.uv, apart_by_channel},
                                   {Aov::depth, tolerance.depth, apart_by_channel},
                                   {Aov::c_plane_uv, tolerance.c_plane_uv, apart_by_channel}})
        if (a.aovs.contains(layer.aov))
            expect_same(found.layers.at(next++),
                        reference(a, b, a.aovs.at(layer.aov), b.aovs.at(layer.aov), layer.tolerance,
                                  layer.measure));
    return next;
}

TEST(FilmDifferenceOfBaselines, IsItsDefinitionToTheRoundingsOfFloats) {
    const std::vector<Film> films = baseline_films();
    ASSERT_GE(films.size(), 7u);
    Disturbance disturbance;
    std::size_t layers = 0;
    for (const Film& before : films) {
        Film after = before;
        disturbance.disturb(after);
        layers += expect_definition(before, after, {});
    }
    EXPECT_GE(layers, 20u);
}

TEST(FilmDifferenceOfBaselines, IsNoneBetweenAPictureAndItself) {
    for (const Film& film : baseline_films()) {
        const FilmDifference found = film_difference(film, film);
        EXPECT_TRUE(found.within());
        EXPECT_EQ(found.compared, found.pixels);
        for (const LayerDifference& layer : found.layers) {
            EXPECT_EQ(layer.excess, 0) << layer.layer;
            EXPECT_EQ(layer.root_mean_square, 0) << layer.layer;
        }
    }
}

} // namespace
} // namespace keiko
