#include "keiko/api/check.h"
#include "keiko/api/compare.h"
#include "keiko/api/inspect.h"
#include "keiko/api/lines.h"
#include "keiko/api/model.h"
#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/workflow/compare_bodies.h"

#include "tests/support/stop_gaps.h"
#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <functional>
#include <sstream>

namespace keiko {
namespace {

using Paths = std::vector<std::filesystem::path>;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double at_most = 10;
#else
constexpr double at_most = 0.7; ///< s that a stop waits: "within a second" with some room
#endif

/// Works for some seconds and holds every stage to the bound.
void expect_stops_soon(const std::function<void(const Job&)>& work) {
    constexpr double enough = 4;
    test::StopGaps gaps(enough);
    try {
        work(gaps.job());
    } catch (const Cancelled&) { // it has worked enough
    }
    for (const auto& [stage, seconds] : gaps.longest()) EXPECT_LT(seconds, at_most) << stage;
}

std::filesystem::path surface(const std::string& name) {
    return std::filesystem::path(KEIKO_SOURCE_DIR "/surfaces") / name;
}

const std::filesystem::path twelve_tubes = KEIKO_SOURCE_DIR "/lightrigs/car-12.toml";

/// The saddle, as large as the orbit of Jupiter.
std::filesystem::path huge_saddle(const test::TemporaryFolder& folder) {
    std::istringstream lines(read_file(surface("saddle.bpt")));
    std::string scaled, line;
    while (std::getline(lines, line)) {
        std::istringstream words(line.substr(0, line.find('#')));
        Vec3 p(0);
        if (words >> p.x >> p.y >> p.z)
            line = std::to_string(p.x * 1e12) + " " + std::to_string(p.y * 1e12) + " " +
                   std::to_string(p.z * 1e12);
        scaled += line + "\n";
    }
    return folder.file("huge.bpt", scaled);
}

TEST(Stop, EndsEveryStageOfACheckSoon) {
    CheckOptions options;
    options.preset = preset_by_name("class-a-waviness");
    options.combs.iso_curves = 20;
    expect_stops_soon(
        [&](const Job& job) { check_models(Paths{surface("concept-car.step")}, options, job); });
}

TEST(Stop, EndsEveryStageOfAnInspectionSoon) {
    expect_stops_soon([](const Job& job) {
        Scene scene = open_scene(Paths{surface("dent.step")}, {.load = {}, .shadows = true}, job);
        scene.set_picture_size(160, 90);
        inspect_scene(scene, {}, job);
    });
}

TEST(Stop, EndsEveryStageOfAComparisonSoon) {
    expect_stops_soon([](const Job& job) {
        compare_bodies(surface("concept-car.step"), surface("concept-car.step"), {}, job);
    });
}

TEST(Stop, EndsTheSearchForLinesOnAHugeBodySoon) {
    const test::TemporaryFolder folder;
    const auto body = huge_saddle(folder);
    LinesOptions options;
    options.rig = twelve_tubes;
    expect_stops_soon(
        [&](const Job& job) { find_lines(open_scene(Paths{body}, {}, job), options, job); });
}

TEST(Stop, EndsAPictureOfFogUnderShortWavesSoon) {
    const test::TemporaryFolder folder;
    const auto scene = folder.file(
        "fog.toml", "format = \"keiko-scene/1\"\n[[model]]\nfile = \"" +
                        surface("dome.bpt").string() +
                        "\"\n[camera]\neye = [-6000, -5000, 400]\ntarget = [0, 0, 300]\n"
                        "size = [32, 18]\n[[spotlight]]\nposition = [-1500, -2600, 4600]\n"
                        "aim = [700, -300, 400]\nhalf_angle = 22\nluminous_flux = 9000\n"
                        "[fog]\nextinction = 0.8\nlayer = { height = 380, extinction_above = "
                        "0.02, bump = \"noise\", amplitude = 75, wavelength = 300 }\n");
    expect_stops_soon([&](const Job& job) {
        const Scene open = open_scene(Paths{scene}, {}, job);
        render_view(open, *open.rig, *open.camera, {}, job);
    });
}

} // namespace
} // namespace keiko
