#include "keiko/compare_bodies.h"
#include "keiko/keiko.h"

#include "tests/support/stop_gaps.h"
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

namespace keiko {
namespace {

using Paths = std::vector<std::filesystem::path>;

TEST(Probe, Probe) {
    const Paths inputs{std::getenv("M")};
    const std::string what = std::getenv("W");
    test::StopGaps gaps;
    try {
        const Job job = gaps.job();
        if (what == "info") file_facts(inputs.front(), {.load={}, .join=.5,.tracing=true}, job);
        if (what == "check") {
            CheckOptions o;
            o.preset = preset_by_name("class-a-waviness");
            check_models(inputs, o, job);
        }
        if (what == "open" ) open_scene(inputs, {.load={}, .material="silver", .shadows = true}, job);
        if (what == "inspect") {
            Scene s = open_scene(inputs, {}, job);
            s.set_picture_size(320, 180);
            inspect_scene(s, {}, job);
        }
        if (what == "compare") {
            CompareBodiesOptions o;
            compare_bodies(inputs[0], inputs[0], o, job);
        }
    } catch (const std::exception& e) { std::cout << e.what() << "\n"; }
    for (const auto& [stage, time] : gaps.longest()) if (time > 0.05) std::cout << "  " << what << " " << stage << " " << time << "\n";
}

} // namespace
} // namespace keiko
