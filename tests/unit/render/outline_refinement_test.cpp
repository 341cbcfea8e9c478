#include "keiko/render/outline_refinement.h"

#include "keiko/render/picture_part.h"

#include "tests/unit/render/stage.h"
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

using namespace keiko;
using test::dome;
using test::flat_plate;
using test::Stage;

namespace {

/// Mean and second moments of what `holds` of the unit square, by its cells' centres.
template <class Holds>
PicturePart counted(const Holds& holds) {
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
std::vector<OutlineCell> all_pixels(const Camera& camera) {
    std::vector<OutlineCell> cells;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            OutlineCell cell;
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

} // namespace

TEST(PicturePart, OfAPolygonHasItsMoments) {
    const std::array corners{Vec2(0, 0.3), Vec2(0.8, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
    const PicturePart part = polygon_part(corners);
    const PicturePart brute = counted([](const Vec2& p) { return p.y > 0.3 * (1 - p.x / 0.8); });
    EXPECT_NEAR(part.area, brute.area, 1e-3);
    EXPECT_LT((part.centre - brute.centre).length(), 1e-3);
    EXPECT_NEAR((part.right.x * part.right.x + part.down.x * part.down.x) / 12, brute.right.x,
                1e-3);
    EXPECT_NEAR((part.right.x * part.right.y + part.down.x * part.down.y) / 12, brute.right.y,
                1e-3);
    EXPECT_NEAR((part.right.y * part.right.y + part.down.y * part.down.y) / 12, brute.down.y, 1e-3);
}

TEST(PicturePart, OfASquareIsTheSquare) {
    const std::array corners{Vec2(2, 3), Vec2(2.5, 3), Vec2(2.5, 3.5), Vec2(2, 3.5)};
    const PicturePart part = polygon_part(corners), square = square_part({2, 3}, 0.5);
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
        EXPECT_LT(std::sqrt(squares / crossed), 0.02); // 4 x 4 rays: 0.05
    }
}

TEST(OutlineRefinement, MakesPartsThatAreAPixelTogether) {
    const Stage stage(dome());
    const PictureScene scene{stage.tracer, stage.materials, stage.rig, Rgb(7)};
    const PictureOptions options;
    const Integrator integrator(scene, options);
    const RefinedPixels refined =
        refined_pixels(integrator, PreparedCamera(stage.camera), all_pixels(stage.camera), 2);
    std::map<std::size_t, double> shares;
    std::size_t last = 0;
    for (const PixelPart& part : refined.parts) {
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
    std::vector<Ray> rays{stage.camera.ray(2.5, 2.5)};
    const EyeView centre = integrator.view(rays);
    OutlineCell cell;
    cell.corner = Vec2(2, 2);
    cell.centre = &centre.samples[0];
    const PreparedCamera camera(stage.camera);
    EXPECT_TRUE(refined_pixels(integrator, camera, {cell}, 2).parts.empty());
}
