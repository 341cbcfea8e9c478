#include "keiko/compare/outlines/outline_difference.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace keiko {
namespace {

using test::ModelBuilder;

/// A model with everything that a picture of it is compared by; face i has the name 1 + i.
struct Body {
    explicit Body(const SurfaceModel& model)
        : tracer(model, {.second_derivatives = true}),
          feet(placed_model(model)),
          paints(model.faces.size()),
          names(model.faces.size()) {
        std::iota(names.begin(), names.end(), std::size_t{1});
    }
    OutlineBody view() const { return {tracer, feet, paints, names, names, {}}; }

    Tracer tracer;
    ClosestPointQuery feet;
    std::vector<Material> paints;
    std::vector<std::size_t> names;
};

/// From above onto (50, 50, 0), 100 x 100 pixels.
Camera camera(double pixel) {
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.eye = {50, 50, 500}, camera.target = {50, 50, 0}, camera.up = {0, 1, 0};
    camera.orthographic_height = 100 * pixel;
    camera.width = camera.height = 100;
    return camera;
}

/// A plate of 100 mm with a square hole of 20 mm, whose left side is at `left`.
SurfaceModel holed(double left) {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, 100, 0});
    builder.polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    const double x = left / 100;
    builder.polygon({{x, 0.4}, {x, 0.6}, {x + 0.2, 0.6}, {x + 0.2, 0.4}});
    return builder.build();
}

/// Two plates that meet smoothly at x = `seam`.
SurfaceModel plates(double seam) {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {seam, 0, 0}, {0, 100, 0});
    builder.plane({seam, 0, 0}, {100 - seam, 0, 0}, {0, 100, 0});
    return builder.build();
}

/// The upper half of a cylinder along y about x = 50 - 20.
SurfaceModel cylinder(double radius) {
    const double w = std::sqrt(0.5), r = radius, c = 30;
    ModelBuilder builder;
    const auto arc = [&](double x0, double z0, double x1, double z1, double x2, double z2) {
        std::vector<Vec4> points;
        for (const auto& [x, z, weight] :
             {std::tuple(x0, z0, 1.0), std::tuple(x1, z1, w), std::tuple(x2, z2, 1.0)})
            for (const double y : {0.0, 100.0})
                points.emplace_back((c + x) * weight, y * weight, z * weight, weight);
        builder.rational_patch(2, 1, points);
    };
    // Turned by 45 degrees, so that its contours are inside a face.
    const double h = r * w, d = r / w;
    arc(-h, -h, -d, 0, -h, h), arc(-h, h, 0, d, h, h), arc(h, h, d, 0, h, -h);
    return builder.build();
}

/// A plate with the middle control point of degree 4 raised.
SurfaceModel dented(double height) {
    std::vector<Vec3> points;
    for (int i = 0; i <= 4; ++i)
        for (int j = 0; j <= 4; ++j)
            points.emplace_back(25 * i, 25 * j, i == 2 && j == 2 ? height : 0);
    ModelBuilder builder;
    builder.patch(4, 4, points);
    return builder.build();
}

/// The pixel of a picture that shows a place in its middle row.
int column(const Camera& camera, double x) {
    return static_cast<int>(std::floor(project(camera, {x, 50, 0})->x));
}

PixelOutline between(const SurfaceModel& before, const SurfaceModel& after, const Camera& camera,
                     double x) {
    const Body a(before), b(after);
    const OutlineBody view_a = a.view(), view_b = b.view();
    const OutlineComparison there(view_a, view_b, camera, {}, 20);
    const OutlineComparison back(view_b, view_a, camera, {}, 20);
    const PixelOutline outline = there.in_pixel(column(camera, x), 50);
    EXPECT_EQ(back.in_pixel(column(camera, x), 50).worst.within(), outline.worst.within());
    return outline;
}

/// Just below and just above what is allowed: 0.01 mm where pixels are small, 0.05 pixels else.
/// Outlines are closed in on to a thousandth of a pixel.
template <class Model>
void expect_limits(const Model& model, double place) {
    for (const double pixel : {0.1, 1.0})
        for (const double share : {0.01, 0.9, 0.95, 1.05, 1.1, 3.0})
            for (const double sign : {1.0, -1.0}) {
                const double moved = share * std::max(0.01, 0.05 * pixel);
                const PixelOutline outline =
                    between(model(place), model(place + sign * moved), camera(pixel), place);
                EXPECT_TRUE(outline.found || share > 1) << pixel << " " << share;
                EXPECT_EQ(outline.worst.within(), share < 1) << pixel << " " << share;
                if (outline.worst.within()) {
                    EXPECT_NEAR(outline.worst.distance, moved, 1e-3 * pixel);
                    EXPECT_NEAR(outline.worst.pixels, moved / pixel, 1e-3);
                }
            }
}

TEST(OutlineShift, IsThatOfABorder) {
    expect_limits(holed, 40.03);
}

TEST(OutlineShift, IsThatOfASeamBetweenSmoothFaces) {
    expect_limits(plates, 50.04);
}

TEST(OutlineShift, IsThatOfAContour) {
    const auto contour_at = [](double x) { return cylinder(x - 30); };
    expect_limits(contour_at, 50.037);
}

TEST(OutlineShift, IsBeyondReachWhereAFaceIsMissing) {
    ModelBuilder one;
    one.plane({0, 0, 0}, {50, 0, 0}, {0, 100, 0});
    const PixelOutline outline = between(plates(50), one.build(), camera(1), 70);
    EXPECT_TRUE(std::isinf(outline.worst.distance));
    EXPECT_FALSE(outline.worst.within());
}

TEST(OutlineShift, IsNoneInsideASurface) {
    const PixelOutline outline = between(holed(40), holed(40), camera(1), 20);
    EXPECT_FALSE(outline.found);
    EXPECT_TRUE(outline.alike);
    EXPECT_EQ(outline.worst.excess, 0);
}

TEST(OutlineShift, ADentIsNoOutlineAndNotAlike) {
    for (const double depth : {0.9 * 5e-4, 1.1 * 5e-4, 0.03}) {
        // The middle of degree 4 has 36 / 256 of its control point; no tilt there.
        const PixelOutline outline = between(dented(0), dented(depth * 256 / 36), camera(0.01), 50);
        EXPECT_FALSE(outline.found);
        EXPECT_EQ(outline.alike, depth < 5e-4) << depth;
    }
}

TEST(OutlineShift, OtherPaintIsNotAlike) {
    const Body a(holed(40));
    Body b(holed(40));
    b.paints[0].diffuse = Rgb(0.5F);
    const OutlineBody view_a = a.view(), view_b = b.view();
    const OutlineComparison outlines(view_a, view_b, camera(1), {}, 20);
    EXPECT_FALSE(outlines.in_pixel(20, 50).alike);
}

/// Film of a picture that shows the body at the middle of each pixel.
Film film(const OutlineBody& body, const Camera& camera) {
    Film film{Image(100, 100, 3), Image(100, 100, 1), {}};
    film.aovs[Aov::face] = Image(100, 100, 1, -1);
    film.aovs[Aov::normal] = Image(100, 100, 3);
    film.aovs[Aov::depth] = Image(100, 100, 1, std::numeric_limits<float>::infinity());
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x)
            if (const auto hit = body.tracer.nearest(camera.ray(x + 0.5, y + 0.5))) {
                *film.alpha.pixel(x, y) = 1;
                *film.aovs[Aov::face].pixel(x, y) =
                    static_cast<float>(body.visible_names[hit->face]);
                *film.aovs[Aov::depth].pixel(x, y) = static_cast<float>(hit->t);
                for (unsigned k = 0; k < 3; ++k)
                    film.aovs[Aov::normal].pixel(x, y)[k] = static_cast<float>(hit->normal[k]);
            }
    return film;
}

OutlineDifference difference(const SurfaceModel& before, const SurfaceModel& after,
                             const Camera& camera, const std::function<void(Film&)>& change = {},
                             const Job& job = {}) {
    const Body a(before), b(after);
    const OutlineBody view_a = a.view(), view_b = b.view();
    const Film film_a = film(view_a, camera);
    Film film_b = film(view_b, camera);
    if (change) change(film_b);
    return outline_difference({view_a, view_b, camera, {}, 20}, film_a, film_b,
                              film_difference(film_a, film_b), camera, job);
}

/// A hole whose left side runs through the middles of the pixels of a column, so that the least
/// shift flips them.
TEST(OutlineDifference, ExcusesPixelsThatFlipByALittleShift) {
    const double left = 40.5;
    const OutlineDifference found = difference(holed(left - 1e-4), holed(left + 1e-4), camera(1));
    EXPECT_EQ(found.moved, 0u);
    EXPECT_GE(found.excused, 20u);
    EXPECT_NEAR(found.worst.distance, 2e-4, 1.3e-4); // outlines are found to that
    EXPECT_EQ(std::accumulate(found.left_out.values.begin(), found.left_out.values.end(), 0.0),
              double(found.excused));
}

TEST(OutlineDifference, FindsTheShiftOfAHole) {
    const OutlineDifference found = difference(holed(40.5 - 0.03), holed(40.5 + 0.03), camera(1));
    EXPECT_GE(found.moved, 20u);
    EXPECT_EQ(found.excused, 0u);
    EXPECT_FALSE(found.within());
    EXPECT_NEAR(found.worst.distance, 0.06, 1e-3);
    EXPECT_NEAR(found.worst.pixels, 0.06, 1e-3);
    EXPECT_EQ(found.x, 40);
}

TEST(OutlineDifference, LeavesASurfaceThatMovedToTheLayers) {
    const OutlineDifference found = difference(dented(0), dented(2), camera(1));
    EXPECT_EQ(found.excused + found.moved + found.alike, 0u);
}

/// Noise of coverage and colour without any cause on the bodies.
TEST(OutlineDifference, IsNotMisledByNoise) {
    const auto noise = [](Film& film) {
        *film.color.pixel(20, 20) = 500;  // inside
        *film.color.pixel(40, 50) = 500;  // at the side of the hole
        *film.alpha.pixel(40, 51) = 0.25; // there, too
        *film.alpha.pixel(20, 30) = 0.75; // inside
    };
    const OutlineDifference found = difference(holed(40.3), holed(40.3), camera(1), noise);
    EXPECT_EQ(found.moved, 0u);
    EXPECT_EQ(found.alike, 1u);
    EXPECT_EQ(found.excused, 3u);
    EXPECT_LT(found.worst.distance, 1e-9);
}

TEST(OutlineDifference, IsTheSameForAnyNumberOfThreads) {
    const auto one = difference(holed(40.4), holed(40.6), camera(1), {}, {.threads = 1});
    const auto two = difference(holed(40.4), holed(40.6), camera(1), {}, {.threads = 2});
    EXPECT_EQ(one.moved, two.moved);
    EXPECT_EQ(one.worst.distance, two.worst.distance);
    EXPECT_EQ(one.worst.place, two.worst.place);
    EXPECT_EQ(one.left_out.values, two.left_out.values);
}

} // namespace
} // namespace keiko
