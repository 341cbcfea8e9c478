#include "keiko/import/worker/load_model.h"

#include "tests/support/file_test_name.h"
#include "tests/support/long_run.h"
#include "tests/support/paths.h"
#include "tests/support/piece_rays.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <string>

namespace keiko {
namespace {

/// Width, as a share of the body's size, in which a place of a change may differ between the two
/// methods: that which PieceCensus leaves free beside the ends of pieces.
constexpr double undecided_width = 2e-5;

/// Curves on which Appel's count and rays differ, where a ray of its own decides for one of them.
struct CountTally {
    std::size_t curves = 0;
    std::size_t rays_wrong = 0;    ///< intervals where that ray is against pieces_by_rays()
    std::size_t differing = 0;     ///< curves where it is against the count
    std::size_t contradictory = 0; ///< of these, where the count falls below 0
};

/// Whether a ray is for the first or for the second method in the middle of an interval of a curve
/// on which they differ.
test::RayVerdict verdict_between(const CurvePiece& a, const CountedPiece& b,
                                 const ModelCurve& curve, const test::DrawnBody& body) {
    const double begin = std::max(a.begin, b.begin), end = std::min(a.end, b.end);
    if (!(begin < end) || a.visible == (b.sheets == 0)) return test::RayVerdict::undecided;
    const Vec3 low = curve.course.at(begin), middle = curve.course.at((begin + end) / 2);
    const double length = (middle - low).length() + (curve.course.at(end) - middle).length();
    if (length < undecided_width * body.sight.size()) return test::RayVerdict::undecided;
    return test::verdict_of(middle, curve, body, a.visible);
}

void add(const ModelCurve& curve, const test::DrawnBody& body, CountTally& tally) {
    const auto changes = body.image.along(curve);
    const auto counted = pieces_by_count(curve, changes, body.sight);
    bool differs = false;
    for (const CurvePiece& a : pieces_by_rays(curve, changes, body.sight))
        for (const CountedPiece& b : counted) {
            const test::RayVerdict verdict = verdict_between(a, b, curve, body);
            differs |= verdict == test::RayVerdict::agrees;
            if (verdict == test::RayVerdict::wrong) ++tally.rays_wrong;
        }
    ++tally.curves;
    if (!differs) return;
    ++tally.differing;
    tally.contradictory += std::any_of(counted.begin(), counted.end(),
                                       [](const CountedPiece& piece) { return piece.sheets < 0; });
}

class CountCensus : public testing::TestWithParam<const char*> {
protected:
    CountTally census(const std::filesystem::path& file) {
        const SurfaceModel model = load_model(file);
        CountTally tally;
        test::Random random(test::first_seed());
        for (std::size_t i = 0; i < test::ray_count(2, 60); ++i) {
            const Vec3 direction = test::random_direction(random);
            for (const Projection projection :
                 {Projection::perspective, Projection::orthographic}) {
                const test::DrawnBody body = test::drawn(model, direction, projection);
                for (const ModelCurve* curve : body.curves()) add(*curve, body, tally);
            }
        }
        RecordProperty("curves", std::to_string(tally.curves));
        RecordProperty("differing", std::to_string(tally.differing));
        RecordProperty("contradictory", std::to_string(tally.contradictory));
        return tally;
    }
};

TEST_P(CountCensus, AgreesWithRaysOnClosedSeams) {
    const CountTally tally = census(test::repository(std::string("surfaces/") + GetParam()));
    EXPECT_EQ(tally.rays_wrong, 0u);
    EXPECT_EQ(tally.differing, 0u) << "of " << tally.curves;
}

INSTANTIATE_TEST_SUITE_P(Fixtures, CountCensus,
                         testing::Values("hood.step", "bored-block.step", "dent.step", "pole.step",
                                         "rational-sphere.step", "trimmed-hole.step",
                                         "trimmed-island.step", "trimmed-two-holes.step",
                                         "seam-g1-angle.step", "shut-line.step",
                                         "concept-car.step"),
                         test::file_test_name);

class SharedCountCensus : public CountCensus {};

TEST_P(SharedCountCensus, DiffersFromRaysOnFewCurvesBesideGaps) {
    KEIKO_NEEDS_SHARED_MODEL(GetParam());
    const CountTally tally = census(test::shared_model(GetParam()));
    EXPECT_EQ(tally.rays_wrong, 0u);
    EXPECT_LE(tally.differing, tally.curves / 50) << "of " << tally.curves;
    EXPECT_LE(tally.differing - tally.contradictory, tally.curves / 200) << "of " << tally.curves;
}

INSTANTIATE_TEST_SUITE_P(Panels, SharedCountCensus,
                         testing::Values("car-hood.brep", "car-front-fender.brep",
                                         "car-front-fender-converted.igs",
                                         "car-rear-deck-half-panel.brep"),
                         test::file_test_name);

} // namespace
} // namespace keiko
