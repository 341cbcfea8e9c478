#include "keiko/drawing/hidden/curve_pieces.h"

#include "keiko/import/worker/load_model.h"

#include "tests/support/long_run.h"
#include "tests/support/paths.h"
#include "tests/support/piece_rays.h"
#include "tests/support/shapes.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <span>
#include <string>

namespace keiko {
namespace {

/// Views from general directions, in which no two edges coincide.
constexpr std::array directions{std::array{-3.0, -2.0, 1.0}, std::array{2.1, 1.3, 1.7}};

/// Chord error for Appel's count, which one crossing that chords miss makes wrong to the end of a
/// curve.
constexpr double fine_error = 1e-6;

Vec3 vec(const std::array<double, 3>& a) {
    return {a[0], a[1], a[2]};
}

/// mm of a curve on which counted pieces are not as those of rays.
double differing(const ModelCurve& curve, std::span<const CurvePiece> by_rays,
                 std::span<const CountedPiece> by_count) {
    double parameters = 0;
    for (const CurvePiece& a : by_rays)
        for (const CountedPiece& b : by_count)
            if (a.visible != (b.sheets == 0))
                parameters += std::max(0.0, std::min(a.end, b.end) - std::max(a.begin, b.begin));
    return parameters * curve.course.length() / curve.course.end();
}

class CurvePieces : public testing::TestWithParam<std::string> {
protected:
    SurfaceModel model() const {
        return load_model(test::repository("surfaces/" + GetParam() + ".step"));
    }
};

TEST_P(CurvePieces, AreAsRaysAlongThemTell) {
    const SurfaceModel body = model();
    for (const Projection projection : {Projection::perspective, Projection::orthographic})
        for (const auto& direction : directions) {
            const auto tally = test::rays_along(test::drawn(body, vec(direction), projection),
                                                test::ray_count(5, 500));
            EXPECT_EQ(tally.wrong, 0u);
            EXPECT_LT(tally.undecided, tally.places / 2);
        }
}

TEST_P(CurvePieces, AgreeWithQuantitativeInvisibility) {
    const SurfaceModel fixture = model();
    for (const auto& direction : directions) {
        const auto body = test::drawn(fixture, vec(direction), Projection::perspective, fine_error);
        for (const ModelCurve* curve : body.curves()) {
            const auto changes = body.image.along(*curve);
            const double off = differing(*curve, pieces_by_rays(*curve, changes, body.sight),
                                         pieces_by_count(*curve, changes, body.sight));
            EXPECT_LT(off, 1e-3) << name_of(curve->kind) << " of face " << curve->faces[0].face;
        }
    }
}

/// A curve below two plates with a slit between them, which ends, or begins, just behind the slit.
/// Lengths are millionths of the plates' diagonal.
std::vector<CurvePiece> behind_slit(double slit, double beyond, bool begins) {
    constexpr double half = 50;
    const double unit = 2e-6 * std::numbers::sqrt2 * half;
    const SurfaceModel plates =
        test::ShapeBuilder()
            .face({test::rectangle(-half, 0, -half, half, 0)})
            .face({test::rectangle(slit * unit, slit * unit + half, -half, half, 0)})
            .model();
    const Camera above =
        test::camera_along(Projection::orthographic, {0, 0, 100}, {0, 0, -1}, {0, 1, 0});
    const test::DrawnBody body(plates, above);
    ModelCurve curve;
    curve.kind = CurveKind::section;
    curve.course.points = {Vec3(-half / 2, 1, -10), Vec3((slit + beyond) * unit, 1, -10)};
    if (begins) std::reverse(curve.course.points.begin(), curve.course.points.end());
    EXPECT_TRUE(body.sight.visible(Vec3(slit * unit / 2, 1, -10), curve));
    const std::vector<CountChange> changes = body.image.along(curve);
    EXPECT_EQ(changes.size(), 2u);
    return pieces_by_rays(curve, changes, body.sight);
}

TEST(CurvePiecesBehindSlits, AreHiddenWhereLinesOfSightCannotTellThemFromTheSlit) {
    for (const bool begins : {false, true})
        for (const double beyond : {2.3, 2.6, 2.9}) {
            const auto pieces = behind_slit(2, beyond, begins);
            EXPECT_EQ(pieces.size(), 1u) << beyond;
            EXPECT_FALSE(pieces.front().visible) << beyond;
        }
}

TEST(CurvePiecesBehindSlits, ShowInWiderSlits) {
    for (const bool begins : {false, true}) EXPECT_EQ(behind_slit(9, 9, begins).size(), 3u);
}

INSTANTIATE_TEST_SUITE_P(Fixtures, CurvePieces,
                         testing::Values("hood", "bored-block", "dent", "pole", "rational-sphere",
                                         "trimmed-two-holes", "shut-line", "concept-car"),
                         [](const auto& fixture) {
                             std::string name = fixture.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

} // namespace
} // namespace keiko
