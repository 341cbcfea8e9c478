#include "keiko/inspect/basics/line_cells.h"

#include "tests/support/analytic_models.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

constexpr double lamp_pitch = 300; // mm

LineField field_over(LineLook look) {
    CPlane lamps;
    lamps.origin = {-1800, -1800, 2500}, lamps.u = {3600, 500, 0}, lamps.v = {-500, 3600, 0};
    Camera camera;
    camera.eye = {-2500, -600, 1500};
    return {look, LineEye(camera), lamps, Vec3(0)};
}

std::vector<double> levels_of(LineLook look) {
    std::vector<double> levels;
    for (int i = 0; i < 12; ++i)
        levels.push_back(look == LineLook::isophote ? std::cos(0.05 + 0.1 * i)
                                                    : lamp_pitch * (i + 0.5));
    return levels;
}

LineRatio<double> ratio(const BezierPatchView& patch, const LineField& field, const Vec2& uv,
                        double level) {
    const SurfaceDerivatives s = evaluate(patch, uv, 1);
    const Vec3 n = s.du().cross(s.dv());
    return field.ratio(Triple<double>{s.position().x, s.position().y, s.position().z},
                       Triple<double>{n.x, n.y, n.z}, level);
}

double residual(const BezierPatchView& patch, const LineField& field, const Vec2& uv,
                double level) {
    return ratio(patch, field, uv, level).residual(0);
}

int sign(double x) {
    return x < 0 ? -1 : 1;
}

/// Random short chords whose ends lie on two sides of a level must cross one of its cells, where
/// rays run to the lamps.
TEST(LineCells, HoldEveryPlaceWhereTheFieldPassesALevel) {
    test::Random random(9);
    const SurfaceModel model = test::bonnet_model(1200, 1400, 80);
    const BezierPatchView patch = model.patch(0);
    for (const LineLook look : {LineLook::reflection, LineLook::highlight, LineLook::isophote}) {
        const LineField field = field_over(look);
        const std::vector<double> levels = levels_of(look);
        const auto cells = line_cells(patch, field, levels);
        int crossings = 0;
        for (int i = 0; i < 4000; ++i) {
            const Vec2 a(test::uniform(random, 0, 1), test::uniform(random, 0, 1));
            const Vec2 b(a.x, test::uniform(random, 0, 1));
            for (std::uint32_t level = 0; level < levels.size(); ++level) {
                Vec2 low = a, high = b;
                const int at_low = sign(residual(patch, field, low, levels[level]));
                if (at_low == sign(residual(patch, field, high, levels[level]))) continue;
                for (int halving = 0; halving < 50; ++halving) {
                    const Vec2 middle = (low + high) * 0.5;
                    (sign(residual(patch, field, middle, levels[level])) == at_low ? low : high) =
                        middle;
                }
                if (!(ratio(patch, field, low, levels[level]).ahead > 0)) continue;
                ++crossings;
                EXPECT_TRUE(std::any_of(cells.begin(), cells.end(),
                                        [&](const LineCell& cell) {
                                            return cell.level == level &&
                                                   cell.uv.padded(1e-12).contains(low);
                                        }))
                    << name_of(look) << " level " << level << " at " << low;
            }
        }
        EXPECT_GT(crossings, 500) << name_of(look);
    }
}

TEST(LineCells, AreProvedAndFewOnASmoothPanel) {
    const SurfaceModel model = test::bonnet_model(1200, 1400, 80);
    const LineField field = field_over(LineLook::reflection);
    const auto cells = line_cells(model.patch(0), field, levels_of(LineLook::reflection));
    EXPECT_FALSE(cells.empty());
    EXPECT_LT(cells.size(), 2000u);
    RecordProperty("cells", static_cast<int>(cells.size()));
    for (const LineCell& cell : cells) EXPECT_TRUE(cell.proved) << cell.uv.lower;
}

TEST(LineCells, AreNoneWhereNoneAreWanted) {
    const SurfaceModel model = test::bonnet_model(1200, 1400, 80);
    const LineField field = field_over(LineLook::reflection);
    LineCellOptions options;
    options.unwanted = [](const Box2& uv) { return uv.lower.x >= 0.5; };
    const auto levels = levels_of(LineLook::reflection);
    const auto all = line_cells(model.patch(0), field, levels);
    const auto half = line_cells(model.patch(0), field, levels, options);
    EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                            [](const LineCell& cell) { return cell.uv.lower.x >= 0.5; }));
    EXPECT_FALSE(half.empty());
    for (const LineCell& cell : half) EXPECT_LT(cell.uv.lower.x, 0.5);
}

/// A plane has one normal: an isophote of just its angle is everywhere.
TEST(LineCells, TellUnprovedWhereALevelFillsTheSurface) {
    test::ModelBuilder builder;
    builder.plane(Vec3(0), {100, 0, 0}, {0, 100, 0});
    const SurfaceModel model = builder.build();
    LineCellOptions few;
    few.most_boxes = 100;
    const double facing = 1;
    const auto cells =
        line_cells(model.patch(0), field_over(LineLook::isophote), std::span(&facing, 1), few);
    double area = 0;
    for (const LineCell& cell : cells) {
        EXPECT_FALSE(cell.proved);
        area += cell.uv.extent().x * cell.uv.extent().y;
    }
    EXPECT_NEAR(area, 1, 1e-12);
}

} // namespace
} // namespace keiko
