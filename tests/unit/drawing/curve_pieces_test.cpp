#include "keiko/drawing/hidden/curve_pieces.h"

#include "keiko/import/worker/load_model.h"

#include "tests/support/long_run.h"
#include "tests/support/paths.h"
#include "tests/support/piece_rays.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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
