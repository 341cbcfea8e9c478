#include "keiko/report/content/inspection_texts.h"

#include "tests/unit/report/sample_report.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using namespace test;

TEST(FactsText, FoldsEqualRemarksAndTellsALostFaceOnce) {
    SurfaceModel remarked = model();
    for (int i = 0; i < 3; ++i) {
        remarked.diagnostics.push_back({Severity::warning, "", "a void surface"});
        remarked.diagnostics.push_back({Severity::note, "", "a void surface"});
    }
    const ModelFacts facts = inspect(remarked).facts;
    const std::string text = facts_text(facts);
    EXPECT_NE(text.find("\nnote        face 2: invalid in the file\n"
                        "warning     a void surface (3 times)\n"
                        "note        a void surface (3 times)\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("\nlost        face 7 rear: no surface\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("no surface"), text.rfind("no surface"));
    EXPECT_EQ(facts.remarks.errors, 1u);
}

TEST(FactsText, TellsTheBuildTimeOfATracer) {
    ModelFacts facts = report().inspection.facts;
    EXPECT_EQ(facts_text(facts).find("tracing"), std::string::npos);
    facts.tracing = timed_trace_facts({.sub_patches = 9, .bytes = 512, .build_seconds = 0.25});
    EXPECT_NE(
        facts_text(facts).find("9 sub-patches, 0 cut by trims, 0 trimmed away, 512 bytes, built "
                               "in 250 ms"),
        std::string::npos);
}

} // namespace
} // namespace keiko
