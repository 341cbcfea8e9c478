#include "keiko/render/antialias/edge_refinement.h"

#include "keiko/render/antialias/subpixels.h"

#include "tests/unit/render/stage.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <vector>

using namespace keiko;
using test::dome;
using test::flat_plate;
using test::Stage;

namespace {

/// Mean and second moments of what `holds` of the unit square, by its cells' centres.
template <class Holds>
PixelArea counted(const Holds& holds) {
    constexpr int n = 1000;
    double count = 0;
    Vec2 sum(0);
    double xx = 0, xy = 0, yy = 0;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const Vec2 at((i + 0.5) / n, (j + 0.5) / n);
            if (!holds(at)) continue;
            ++count, sum += at;
            xx += at.x * at.x, xy += at.x * at.y, yy += at.y * at.y;
        }
    const Vec2 mean = sum / count;
    return {mean,
            {xx / count - mean.x * mean.x, xy / count - mean.x * mean.y},
            {0, yy / count - mean.y * mean.y},
            count / (n * n)};
}

/// The cells of all pixels of a stage, with nothing known of them.
std::vector<EdgeCell> all_pixels(const Camera& camera) {
    std::vector<EdgeCell> cells;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            EdgeCell cell;
            cell.pixel = cells.size();
            cell.corner = Vec2(x, y);
            cells.push_back(cell);
        }
    return cells;
}

/// The share of a pixel that rays through the centres of its 32 x 32 cells meet the body in.
double counted_share(const Stage& stage, int x, int y) {
    constexpr int n = 32;
    int hits = 0;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            hits += stage.tracer.nearest(stage.camera.ray(x + (i + 0.5) / n, y + (j + 0.5) / n))
                        .has_value();
    return hits / static_cast<double>(n * n);
}

/// A flat plate with a rounded groove half a pixel wide, askew in the picture.
SurfaceModel grooved_plate() {
    constexpr double w = 25;
    const std::array<Vec2, 7> profile{Vec2(-1000, 0),  Vec2(-2 * w, 0), Vec2(-w, 0),
                                      Vec2(0, -w / 2), Vec2(w, 0),      Vec2(2 * w, 0),
                                      Vec2(1000, 0)};
    NurbsSurface surface;
    surface.degree_u = 1, surface.degree_v = 2;
    surface.knots_u = {0, 0, 1, 1};
    surface.knots_v = {0, 0, 0, 1, 2, 3, 4, 5, 5, 5};
    for (const double x : {-1000.0, 1000.0})
        for (const Vec2& p : profile) surface.points.emplace_back(x, p.x + 0.2 * x, p.y, 1);
    test::ModelBuilder builder;
    builder.nurbs(surface);
    return builder.build();
}

/// Mean luminances of pixels over their 16 x 16 cells, each by a ray with its footprint.
std::vector<double> mean_luminances(const Stage& stage) {
    constexpr int n = 16;
    const PictureScene scene{stage.tracer, stage.materials, stage.rig, Rgb(7)};
    const PictureOptions options;
    const Integrator integrator(scene, options);
    std::vector<double> means;
    for (int y = 0; y < stage.camera.height; ++y)
        for (int x = 0; x < stage.camera.width; ++x) {
            std::vector<Ray> rays;
            for (int i = 0; i < n * n; ++i) {
                rays.push_back(stage.camera.ray(x + (i % n + 0.5) / n, y + (i / n + 0.5) / n));
                rays.back().differentials = rays.back().differentials->scaled(1.0 / n);
            }
            double sum = 0;
            for (const PixelSample& sample : integrator.follow(rays).samples)
                sum += luminance(sample.luminance);
            means.push_back(sum / (n * n));
        }
    return means;
}

/// How far a picture is off these luminances, RMS over the `chosen` pixels.
double rms_off(const Film& film, std::span<const double> truth, const std::vector<bool>& chosen) {
    double squares = 0, count = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        if (!chosen[i]) continue;
        const float* c = &film.color.values[3 * i];
        const double off = luminance(Rgb(double{c[0]}, double{c[1]}, double{c[2]})) - truth[i];
        squares += off * off, ++count;
    }
    return std::sqrt(squares / count);
}

/// The pixels in which two pictures differ.
std::vector<bool> changed(const Film& a, const Film& b) {
    std::vector<bool> differ;
    for (std::size_t i = 0; i < a.color.values.size(); i += 3)
        differ.push_back(
            !std::equal(&a.color.values[i], &a.color.values[i] + 3, &b.color.values[i]));
    return differ;
}

/// The pixels that see any of the groove in grooved_plate(), split or not.
std::vector<bool> shows_groove(const Stage& stage) {
    constexpr int n = 16;
    std::vector<bool> shows;
    for (int y = 0; y < stage.camera.height; ++y)
        for (int x = 0; x < stage.camera.width; ++x) {
            bool any = false;
            for (int i = 0; i < n * n && !any; ++i) {
                const auto hit = stage.tracer.nearest(
                    stage.camera.ray(x + (i % n + 0.5) / n, y + (i / n + 0.5) / n));
                any = hit && hit->position.z < -1e-6;
            }
            shows.push_back(any);
        }
    return shows;
}

} // namespace

TEST(PixelArea, OfAPolygonHasItsMoments) {
    const std::array corners{Vec2(0, 0.3), Vec2(0.8, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
    const PixelArea part = polygon_part(corners);
    const PixelArea brute = counted([](const Vec2& p) { return p.y > 0.3 * (1 - p.x / 0.8); });
    EXPECT_NEAR(part.area, brute.area, 1e-3);
    EXPECT_LT((part.centre - brute.centre).length(), 1e-3);
    EXPECT_NEAR((part.right.x * part.right.x + part.down.x * part.down.x) / 12, brute.right.x,
                1e-3);
    EXPECT_NEAR((part.right.x * part.right.y + part.down.x * part.down.y) / 12, brute.right.y,
                1e-3);
    EXPECT_NEAR((part.right.y * part.right.y + part.down.y * part.down.y) / 12, brute.down.y, 1e-3);
}

TEST(PixelArea, OfASquareIsTheSquare) {
    const std::array corners{Vec2(2, 3), Vec2(2.5, 3), Vec2(2.5, 3.5), Vec2(2, 3.5)};
    const PixelArea part = polygon_part(corners), square = rectangle_part({2, 3}, Vec2(0.5));
    EXPECT_LT((part.centre - square.centre).length(), 1e-12);
    EXPECT_LT((part.right - square.right).length(), 1e-12);
    EXPECT_LT((part.down - square.down).length(), 1e-12);
    EXPECT_NEAR(part.area, square.area, 1e-12);
}

TEST(OutlineRefinement, FindsHowMuchOfAPixelTheBodyCovers) {
    for (const SurfaceModel& model : {flat_plate(), dome()}) {
        const Stage stage(model);
        const Film film = stage.render();
        int crossed = 0;
        double squares = 0;
        for (int y = 0; y < stage.camera.height; ++y)
            for (int x = 0; x < stage.camera.width; ++x) {
                const double share = counted_share(stage, x, y);
                const double off = double{film.alpha.pixel(x, y)[0]} - share;
                EXPECT_LT(std::abs(off), 0.1) << x << " " << y;
                if (share == 0 || share == 1) continue;
                ++crossed;
                squares += off * off;
            }
        EXPECT_GT(crossed, 100);
        EXPECT_LT(std::sqrt(squares / crossed), 0.008); // 4 x 4 rays: 0.05
    }
}

TEST(OutlineRefinement, MakesPartsThatAreAPixelTogether) {
    const Stage stage(dome());
    const PictureScene scene{stage.tracer, stage.materials, stage.rig, Rgb(7)};
    const PictureOptions options;
    const Integrator integrator(scene, options);
    const RefinedPixels refined =
        refined_pixels(integrator, PreparedCamera(stage.camera), all_pixels(stage.camera), 0.25);
    std::map<std::size_t, double> shares;
    std::size_t last = 0;
    for (const Subpixel& part : refined.parts) {
        EXPECT_GE(part.pixel, last);
        last = part.pixel;
        shares[part.pixel] += part.share;
    }
    EXPECT_EQ(shares.size(), static_cast<std::size_t>(stage.camera.width * stage.camera.height));
    for (const auto& [pixel, share] : shares) EXPECT_NEAR(share, 1, 1e-12) << pixel;
    EXPECT_LT(refined.parts.size(), 2 * shares.size()) << "most pixels show one smooth thing";
}

TEST(OutlineRefinement, LeavesPixelsOutThatTheirCentresTell) {
    const Stage stage(flat_plate());
    const PictureScene scene{stage.tracer, stage.materials, stage.rig, Rgb(7)};
    const PictureOptions options;
    const Integrator integrator(scene, options);
    Rays rays{stage.camera.ray(2.5, 2.5)};
    const SampleBatch centre = integrator.view(rays);
    EdgeCell cell;
    cell.corner = Vec2(2, 2);
    cell.centre = &centre.samples[0];
    const PreparedCamera camera(stage.camera);
    EXPECT_TRUE(refined_pixels(integrator, camera, {cell}, 0.25).parts.empty());
}

TEST(PixelArea, IsCutIntoStripsThatAreThePolygonTogether) {
    const std::array corners{Vec2(0, 0.3), Vec2(0.8, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
    const Vec2 across(0.6, 0.8);
    double area = 0;
    Vec2 centre(0);
    for (int i = 0; i < 7; ++i) {
        const Polygon strip = strip_of(corners, across, 0.2 * i, 0.2 * (i + 1));
        for (const Vec2& corner : strip) {
            EXPECT_GT(across.dot(corner), 0.2 * i - 1e-12);
            EXPECT_LT(across.dot(corner), 0.2 * (i + 1) + 1e-12);
        }
        if (strip.size() < 3) continue;
        const PixelArea part = polygon_part(strip);
        area += part.area, centre += part.centre * part.area;
    }
    const PixelArea whole = polygon_part(corners);
    EXPECT_NEAR(area, whole.area, 1e-12);
    EXPECT_LT((centre / area - whole.centre).length(), 1e-12);
}

TEST(MostBending, RunsAcrossAGroove) {
    const Stage stage(grooved_plate());
    const std::array corners{Vec2(47, 26), Vec2(48, 26), Vec2(48, 27), Vec2(47, 27)};
    Rays rays{stage.camera.ray(47.5, 26.5)};
    for (const Vec2& corner : corners) rays.push_back(stage.camera.ray(corner.x, corner.y));
    const PictureScene scene{stage.tracer, stage.materials, stage.rig, Rgb(7)};
    const PictureOptions options;
    const SampleBatch view = Integrator(scene, options).view(rays);
    std::vector<const PixelSample*> seen;
    for (std::size_t i = 1; i < 5; ++i) seen.push_back(&view.samples[i]);
    const Vec2 across = max_curvature_direction(corners, seen, view.samples[0]);
    // The groove runs along y = x / 5.
    const auto off = [&](std::size_t i) {
        const Vec3& p = view.samples[i].hit->position;
        return p.y - 0.2 * p.x;
    };
    const Vec2 expected =
        Vec2(off(2) + off(3) - off(1) - off(4), off(4) + off(3) - off(1) - off(2)).normalized();
    EXPECT_NEAR(across.length(), 1, 1e-12);
    EXPECT_GT(std::abs(across.dot(expected)), 0.99);
}

TEST(OutlineRefinement, ShowsAGrooveNarrowerThanAPixelAsManyRaysDo) {
    const Stage stage(grooved_plate());
    const std::vector<double> truth = mean_luminances(stage);
    const auto render = [&](int edge_samples) { // lit everywhere, so that none but cut ones change
        return stage.render({.aovs = {}, .edge_samples = edge_samples, .light_error = 0});
    };
    const Film one = render(1), split = render(8);
    const std::vector<bool> cut = changed(one, split), groove = shows_groove(stage);
    const double off = rms_off(split, truth, cut), off_one = rms_off(one, truth, cut);
    EXPECT_GT(off_one, 50); // cd/m2; images of lamps have some 360
    EXPECT_LT(off, 6);
    // With the pixels that no centre nearby tells to hold any of it.
    EXPECT_LT(rms_off(split, truth, groove), 10);
    EXPECT_GT(rms_off(one, truth, groove), 50);
}
