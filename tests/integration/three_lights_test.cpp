#include "keiko/files/scene/material_file.h"

#include "tests/support/light_trial.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using namespace test;

/// The closing claim of [NishitaTubes]: what is wrong with a surface shows under parallel tubes.
/// The sizes are a fifth of the smallest that the others show anywhere; docs/placement.md has the
/// table.
TEST(ThreeLights, TubesShowDefectsEverywhereThatOthersShowNowhere) {
    const LightTrial trial(standard_materials().front(), 300);
    for (const auto& [defect, size] :
         {std::pair(Defect::dent, 0.24), std::pair(Defect::wave, 0.16),
          std::pair(Defect::kink, 0.6), std::pair(Defect::bend, 0.7)}) {
        SCOPED_TRACE(size);
        EXPECT_EQ(trial.seen(TrialLight::tubes, defect, size), 9);
        EXPECT_EQ(trial.seen(TrialLight::point, defect, size), 0);
        EXPECT_EQ(trial.seen(TrialLight::parallel, defect, size), 0);
    }
}

TEST(ThreeLights, NothingIsSeenOnTheCleanPanel) {
    const LightTrial trial(standard_materials().front(), 120);
    for (const TrialLight light : trial_lights) EXPECT_EQ(trial.seen(light, Defect::kink, 0), 0);
}

} // namespace
} // namespace keiko
