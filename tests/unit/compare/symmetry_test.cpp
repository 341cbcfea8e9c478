#include "keiko/compare/shape/symmetry.h"

#include "tests/support/model_builder.h"
#include "tests/unit/inspect/flawed_sheets.h"
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace keiko {
namespace {

/// A domed sheet with a dent 0.1 mm deep at (21, -33), or none, held against its image at y.
Inspection inspected(double dent, double y, double limit) {
    const SurfaceModel model =
        test::sheet(test::bump(21, 20), test::bump(-33, 20), -dent, {-1e-4, -1e-4});
    CriteriaPreset preset;
    preset.surface.symmetry = SymmetryLimit{{1, y}, limit};
    Inspection inspection = inspect(model, preset);
    check_symmetry(model, inspection);
    return inspection;
}

TEST(Symmetry, OfASymmetricBodyPasses) {
    const Inspection found = inspected(0, 0, 1e-5);
    EXPECT_TRUE(found.findings.empty());
    EXPECT_EQ(found.checks.back().code, "KEIKO-SYMMETRY");
    EXPECT_LT(found.checks.back().worst.value, 1e-9);
}

TEST(Symmetry, ShowsADentThatIsOnOneSideAlone) {
    for (const double limit : {0.098, 0.102}) {
        const Inspection found = inspected(0.1, 0, limit);
        const Check& check = found.checks.back();
        EXPECT_NEAR(check.worst.value, 0.1, 1e-4) << check.message;
        EXPECT_NEAR(check.worst.place.x, 21, 0.5);
        EXPECT_NEAR(std::abs(check.worst.place.y), 33, 0.5);
        const Verdict expected = limit < 0.1 ? Verdict::fail : Verdict::pass;
        EXPECT_EQ(check.worst.verdict, expected);
        EXPECT_EQ(found.verdict, expected);
        EXPECT_EQ(found.faces.at(check.face).verdict, expected);
        EXPECT_EQ(found.findings.size(), limit < 0.1 ? 1u : 0u);
        EXPECT_EQ(found.face_counts.fail, limit < 0.1 ? 1u : 0u);
    }
}

/// The image of a body 5 um beside the plane is 10 um beside it, and its border as far from the
/// other's.
TEST(Symmetry, OfABodyBesideItsPlaneIsOffByTwiceTheWay) {
    const Inspection found = inspected(0, 0.005, 0.0098);
    EXPECT_NEAR(found.checks.back().worst.value, 0.01, 1e-4) << found.checks.back().message;
    EXPECT_EQ(found.verdict, Verdict::fail);
}

/// A flat sheet of 2000 x 1200 mm about the origin, in face parameters of mm from its corner.
constexpr double length = 2000, width = 1200;

/// Inside `outline`, without `holes`; held against its image at y = 0.
Check of_flat(const std::vector<Vec2>& outline, const std::vector<std::vector<Vec2>>& holes,
              double limit) {
    test::ModelBuilder builder;
    builder.patch(1, 1,
                  {{-length / 2, -width / 2, 0},
                   {-length / 2, width / 2, 0},
                   {length / 2, -width / 2, 0},
                   {length / 2, width / 2, 0}},
                  {Vec2(-length / 2, -width / 2), Vec2(length / 2, width / 2)});
    builder.polygon(outline);
    for (const std::vector<Vec2>& hole : holes) builder.polygon(hole);
    const SurfaceModel model = builder.build();
    CriteriaPreset preset;
    preset.surface.symmetry = SymmetryLimit{{1, 0}, limit};
    Inspection inspection = inspect(model, preset);
    check_symmetry(model, inspection);
    return inspection.checks.back();
}

std::vector<Vec2> rectangle(const Vec2& a, const Vec2& b) {
    return {a, {b.x, a.y}, b, {a.x, b.y}};
}

std::vector<Vec2> square(const Vec2& middle, double side) {
    return rectangle(middle - Vec2(side / 2), middle + Vec2(side / 2));
}

/// The edge at the end of y is a little further out. No place of the surface need be there.
TEST(Symmetry, ShowsAnEdgeThatIsFurtherOut) {
    for (const double out : {0.5, 0.05})
        for (const double limit : {0.98 * out, 1.02 * out}) {
            const Check check = of_flat(rectangle({-990, -590}, {990, 590 + out}), {}, limit);
            EXPECT_NEAR(check.worst.value, out, 1e-9) << check.message;
            EXPECT_NEAR(std::abs(check.worst.place.y), 590 + out / 2, out);
            EXPECT_EQ(check.worst.verdict, limit < out ? Verdict::fail : Verdict::pass);
        }
}

TEST(Symmetry, ShowsAHoleThatIsOnOneSideAlone) {
    for (const double side : {0.6, 2.0, 6.0}) {
        const Check check =
            of_flat(rectangle({-990, -590}, {990, 590}), {square({311.7, 203.1}, side)}, 0.01);
        EXPECT_GT(check.worst.value, side / 2) << check.message;
        EXPECT_LT((check.worst.place - Vec3(311.7, 203.1, 0)).length(), side);
        EXPECT_EQ(check.worst.verdict, Verdict::fail);
    }
}

TEST(Symmetry, ShowsAHoleBesideTheImageOfTheOther) {
    for (const double limit : {0.98, 1.02}) {
        const Check check =
            of_flat(rectangle({-990, -590}, {990, 590}),
                    {square({311.7, 203.1}, 12), square({312.7, -203.1}, 12)}, limit);
        EXPECT_NEAR(check.worst.value, 1, 1e-3) << check.message;
        EXPECT_EQ(check.worst.verdict, limit < 1 ? Verdict::fail : Verdict::pass);
    }
}

TEST(Symmetry, OfHolesOnBothSidesPasses) {
    const std::vector<Vec2> askew{{300, 200}, {317, 203}, {311, 215}};
    std::vector<Vec2> image;
    for (const Vec2& corner : askew) image.emplace_back(corner.x, -corner.y);
    for (const double limit : {0.01, 1e-4}) {
        const Check check = of_flat(rectangle({-990, -590}, {990, 590}), {askew, image}, limit);
        EXPECT_LT(check.worst.value, 1e-9) << check.message;
        EXPECT_EQ(check.worst.verdict, Verdict::pass);
    }
}

/// A quarter of a circle of this radius on either side of the plane cuts the corners off.
Check of_round_corners(double left, double right, double limit) {
    const auto corner = [](const Vec2& middle, const Vec2& a, const Vec2& b) {
        const double w = std::sqrt(0.5);
        const Vec2 p = middle + a, q = middle + a + b, r = middle + b;
        return std::vector<Vec3>{Vec3(p.x, p.y, 1), Vec3(q.x * w, q.y * w, w), Vec3(r.x, r.y, 1)};
    };
    const auto line = [](const Vec2& a, const Vec2& b) {
        return std::vector<Vec3>{Vec3(a.x, a.y, 1), Vec3(b.x, b.y, 1)};
    };
    test::ModelBuilder builder;
    builder.patch(3, 1,
                  {{-150, -100, 0},
                   {-150, 100, 0},
                   {-50, -100, 20},
                   {-50, 100, 20},
                   {50, -100, 20},
                   {50, 100, 20},
                   {150, -100, 0},
                   {150, 100, 0}},
                  {Vec2(-150, -100), Vec2(150, 100)});
    builder.loop({line({-150, -100}, {150, -100}), line({150, -100}, {150, 100 - right}),
                  corner({150 - right, 100 - right}, {right, 0}, {0, right}),
                  line({150 - right, 100}, {-150 + left, 100}),
                  corner({-150 + left, 100 - left}, {0, left}, {-left, 0}),
                  line({-150, 100 - left}, {-150, -100})});
    const SurfaceModel model = builder.build();
    CriteriaPreset preset;
    preset.surface.symmetry = SymmetryLimit{{0, 0}, limit};
    Inspection inspection = inspect(model, preset);
    check_symmetry(model, inspection);
    return inspection.checks.back();
}

TEST(Symmetry, ComparesRoundBordersOnABentFace) {
    for (const double limit : {0.01, 1e-4}) {
        const Check alike = of_round_corners(40, 40, limit);
        EXPECT_LT(alike.worst.value, 1e-9) << alike.message;
        EXPECT_EQ(alike.worst.verdict, Verdict::pass);
    }
    // The corners are 0.2 (1 / sin 45 - 1) mm apart, in the plane of the parameters.
    const Check other = of_round_corners(40, 40.2, 0.05);
    EXPECT_NEAR(other.worst.value, 0.083, 0.01) << other.message;
    EXPECT_EQ(other.worst.verdict, Verdict::fail);
}

/// The dent is 0.1 mm deep, and narrower than the places are apart.
TEST(Symmetry, TellsWhetherABodyIsItsOwnImage) {
    const auto dented = [](double dent) {
        return test::sheet(test::bump(21, 20), test::bump(-33, 20), -dent, {-1e-4, -1e-4});
    };
    EXPECT_TRUE(is_own_image(dented(0), {1, 0}, 1e-6));
    EXPECT_TRUE(is_own_image(dented(0.1), {1, 0}, 0.1001));
    EXPECT_FALSE(is_own_image(dented(0.1), {1, 0}, 0.0999));
    EXPECT_FALSE(is_own_image(dented(0), {1, 0.005}, 0.0098));
    EXPECT_FALSE(is_own_image(dented(0), {1, 1e4}, 1));
}

TEST(Symmetry, IsNotAskedForWithoutALimit) {
    Inspection found = inspected(0, 0, 1);
    found.preset.surface.symmetry.reset();
    const std::size_t checks = found.checks.size();
    check_symmetry(test::sheet(test::everywhere(), test::everywhere(), 0, {}), found);
    EXPECT_EQ(found.checks.size(), checks);
}

} // namespace
} // namespace keiko
