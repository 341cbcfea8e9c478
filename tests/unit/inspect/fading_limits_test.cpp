#include "keiko/files/scene/preset_file.h"
#include "keiko/inspect/seams/seam_measure.h"

#include "tests/unit/inspect/sloped_seam.h"
#include <gtest/gtest.h>

#include <algorithm>

namespace keiko {
namespace {

/// A crease of 8 degrees that fades over 150 mm and meets the plane at `slope` degrees/mm.
test::SeamSlope fading_to(double slope) {
    return {{{200, {8, 8, 8, 8}}, {350, {8, 8, slope * 150 / 3, 0}}, {400, {0, 0, 0, 0}}}};
}

std::vector<MeasuredSeam> measured(const test::SeamSlope& slope, const CriteriaPreset& preset) {
    const test::SlopedSeam seam(slope);
    return measure_seams(seam.model(), seam.seams(), preset, 0.5).seams;
}

Verdict worst_of(const std::vector<MeasuredSeam>& seams) {
    Verdict verdict = Verdict::pass;
    for (const MeasuredSeam& seam : seams) verdict = std::max(verdict, seam.verdict);
    return verdict;
}

TEST(FadingLimits, EachPresetPassesLessAndFailsMore) {
    for (const CriteriaPreset& preset : standard_presets()) {
        SCOPED_TRACE(preset.name);
        EXPECT_NEAR(preset.fading, preset.angle / 70, 0.03 * preset.angle / 70);
        for (const double share : {0.98, 1.02}) {
            const auto seams = measured(fading_to(share * preset.fading), preset);
            const auto crease =
                std::find_if(seams.begin(), seams.end(),
                             [](const MeasuredSeam& seam) { return seam.fading.has_value(); });
            ASSERT_NE(crease, seams.end());
            EXPECT_EQ(crease->kind, SeamClass::crease);
            EXPECT_NEAR(crease->fading->value, share * preset.fading, 0.005 * preset.fading);
            EXPECT_NEAR(crease->fading->place.x, 350, 1e-6);
            EXPECT_EQ(crease->verdict, share < 1 ? Verdict::pass : Verdict::fail);
            EXPECT_EQ(worst_of(seams), crease->verdict);
        }
    }
}

} // namespace
} // namespace keiko
