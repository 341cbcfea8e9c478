#include "keiko/inspect/basics/line_cells.h"

#include "tests/support/analytic_models.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

constexpr double lamp_pitch = 300; // mm

CPlane lamps_over() {
    CPlane lamps;
    lamps.origin = {-1800, -1800, 2500}, lamps.u = {3600, 500, 0}, lamps.v = {-500, 3600, 0};
    return lamps;
}

LineField field_over(LineLook look, const CPlane& lamps = lamps_over(),
                     const Vec3& eye = {-2500, -600, 1500}) {
    Camera camera;
    camera.eye = eye;
    return {look, LineEye(camera), lamps, Vec3(0)};
}

std::vector<double> levels_of(LineLook look) {
    std::vector<double> levels;
    for (int i = 0; i < 12; ++i)
        levels.push_back(look == LineLook::isophote ? std::cos(0.05 + 0.1 * i)
                                                    : lamp_pitch * (i + 0.5));
    return levels;
}

double residual(const BezierPatchView& patch, const LineField& field, const Vec2& uv,
                double level) {
    const SurfaceDerivatives s = evaluate(patch, uv, 1);
    const Vec3 n = s.du().cross(s.dv());
    return field
        .ratio(Triple<double>{s.position().x, s.position().y, s.position().z},
               Triple<double>{n.x, n.y, n.z}, level)
        .residual(0);
}

int sign(double x) {
    return x < 0 ? -1 : 1;
}

/// True if the ray of a place meets the C-plane between the ends of the lamps.
bool meets_lamps(const BezierPatchView& patch, const LineField& field, const Vec2& uv) {
    const SurfaceDerivatives s = evaluate(patch, uv, 1);
    const LineField::Image image = field.image(s.position(), s.du().cross(s.dv()));
    return image.faces && image.along >= 0 && image.along <= field.plane().length;
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
        for (int i = 0; i < 6000; ++i) {
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
                if (!meets_lamps(patch, field, low)) continue;
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

/// The least coordinate along the lamps that a patch mirrors, mm.
double least_along(const BezierPatchView& patch, const LineField& field) {
    double least = 1e9;
    for (double u = 0; u <= 1; u += 1.0 / 32)
        for (double v = 0; v <= 1; v += 1.0 / 32) {
            const SurfaceDerivatives s = evaluate(patch, {u, v}, 1);
            const LineField::Image image = field.image(s.position(), s.du().cross(s.dv()));
            if (image.faces) least = std::min(least, image.along);
        }
    return least;
}

/// A row that ends well before all that the panel mirrors has no lines, and needs no proofs. One
/// that ends a little behind the first mirrored place has some.
TEST(LineCells, AreNoneBeyondTheEndsOfTheLamps) {
    const SurfaceModel model = test::bonnet_model(300, 350, 20);
    const BezierPatchView patch = model.patch(0);
    const CPlane lamps = lamps_over();
    const Vec3 above(-300, -200, 2000);
    for (const LineLook look : {LineLook::reflection, LineLook::highlight}) {
        const double begin = least_along(patch, field_over(look, lamps, above));
        const auto cells_up_to = [&](double end) {
            CPlane moved = lamps;
            moved.origin += lamps.u.normalized() * (end - lamps.u.length());
            return line_cells(patch, field_over(look, moved, above), levels_of(look));
        };
        EXPECT_TRUE(cells_up_to(begin - 1500).empty()) << name_of(look);
        EXPECT_FALSE(cells_up_to(begin + 300).empty()) << name_of(look);
    }
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
