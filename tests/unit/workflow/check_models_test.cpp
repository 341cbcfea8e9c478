#include "keiko/api/inspect.h"
#include "keiko/api/model.h"
#include "keiko/api/scene.h"
#include "keiko/scene/view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

const std::filesystem::path dome = KEIKO_SOURCE_DIR "/surfaces/dome.bpt";

/// z where the rim of the hole in trimmed-hole.step is highest, mm.
double highest_on_rim() {
    double highest = -1;
    constexpr int steps = 100000;
    for (int i = 0; i < steps; ++i) {
        const double a = 2 * std::numbers::pi * i / steps;
        const double x = 10 + 40 * std::cos(a), y = -5 + 40 * std::sin(a);
        highest = std::max(highest, -x * x / (2 * 900) - y * y / (2 * 600));
    }
    return highest;
}

TEST(FileFacts, BuildTheTracerOnlyWhenAsked) {
    EXPECT_FALSE(model_info(dome).tracing);
    const ModelFacts facts = model_info(dome, {.load = {}, .join = 0.5, .tracing = true});
    ASSERT_TRUE(facts.tracing);
    EXPECT_GE(facts.tracing->sub_patches, facts.patches);
    EXPECT_GT(facts.tracing->bytes, 0u);
    EXPECT_GT(facts.tracing->build_milliseconds, 0);
}

TEST(FileFacts, AreThoseOfTheSeamsWithinTheJoinDistance) {
    EXPECT_EQ(model_info(dome).join, 0.5);
    EXPECT_EQ(model_info(dome).seams, 4u);
    EXPECT_EQ(model_info(dome).millimetres_per_unit, 1);
}

TEST(FileFacts, HaveTheBoxOfTheMaterialAsViewsDo) {
    // A crowned plate, highest at z = 0 in its middle, which a round hole takes away.
    const std::filesystem::path file = KEIKO_SOURCE_DIR "/surfaces/trimmed-hole.step";
    const Box3 box = model_info(file).bounds;
    EXPECT_NEAR(box.upper.z, highest_on_rim(), 1e-6);
    const std::vector<std::filesystem::path> inputs{file};
    const Scene scene = open_scene(inputs);
    EXPECT_EQ(scene.tracer.bounds(), box);
    const std::vector<std::string> names{"top"};
    EXPECT_EQ(choose_views(scene, names, 1)[0].camera, frame_view("top", box));
}

TEST(InspectScene, TellsWhatTheTracerMadeButNoTime) {
    const std::vector<std::filesystem::path> inputs{dome};
    Scene scene = open_scene(inputs);
    scene.width = 32, scene.height = 18;
    InspectOptions options;
    options.views = {"top"};
    const InspectResult result = inspect_scene(scene, options);
    const auto& tracing = result.report.inspection.facts.tracing;
    ASSERT_TRUE(tracing);
    EXPECT_EQ(tracing->sub_patches, scene.tracer.statistics().sub_patches);
    EXPECT_FALSE(tracing->build_milliseconds);
}

} // namespace
} // namespace keiko
