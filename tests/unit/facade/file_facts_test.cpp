#include "keiko/keiko.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

const std::filesystem::path dome = KEIKO_SOURCE_DIR "/surfaces/dome.bpt";

TEST(FileFacts, BuildTheTracerOnlyWhenAsked) {
    EXPECT_FALSE(file_facts(dome).tracing);
    const ModelFacts facts = file_facts(dome, {.load = {}, .join = 0.5, .tracing = true});
    ASSERT_TRUE(facts.tracing);
    EXPECT_GE(facts.tracing->leaves, facts.patches);
    EXPECT_GT(facts.tracing->bytes, 0u);
    EXPECT_GT(facts.tracing->build_milliseconds, 0);
}

TEST(FileFacts, AreThoseOfTheSeamsWithinTheJoinDistance) {
    EXPECT_EQ(file_facts(dome).join, 0.5);
    EXPECT_EQ(file_facts(dome).seams, 4u);
    EXPECT_EQ(file_facts(dome).millimetres_per_unit, 1);
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
    EXPECT_EQ(tracing->leaves, scene.tracer.statistics().leaves);
    EXPECT_FALSE(tracing->build_milliseconds);
}

} // namespace
} // namespace keiko
