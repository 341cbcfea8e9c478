#include "keiko/compare/shape/symmetry.h"

#include "tests/unit/inspect/flawed_sheets.h"
#include <gtest/gtest.h>

#include <cmath>

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
