#include "keiko/api/scene.h"
#include "keiko/api/view.h"
#include "keiko/base/error.h"

#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace keiko {
namespace {

/// A saddle of 200 mm above a ground.
Scene saddle_above_ground() {
    const test::TemporaryFolder folder;
    const auto file = folder.file("scene.toml",
                                  "format = \"keiko-scene/1\"\n"
                                  "ground = { z = -60 }\n[[model]]\nfile = \"" +
                                      test::repository("surfaces/saddle.bpt").string() +
                                      "\"\nmaterial = \"mirror\"\n");
    const std::filesystem::path inputs[] = {file};
    return open_scene(inputs);
}

Camera camera_from_aside() {
    Camera camera;
    camera.eye = {-900, 0, 500};
    camera.target = Vec3(0);
    camera.width = camera.height = 32;
    return camera;
}

/// Samples of faces from one number to another.
std::ptrdiff_t number_of(const std::vector<DeepSample>& samples, float from, float to) {
    return std::count_if(samples.begin(), samples.end(), [&](const DeepSample& sample) {
        return sample.face >= from && sample.face <= to;
    });
}

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
    std::uint32_t number = 0;
    std::memcpy(&number, bytes.data() + at, sizeof number);
    return number;
}

} // namespace

TEST(DeepView, NamesTheGroundAndTheFacesOfTheBody) {
    const Scene scene = saddle_above_ground();
    const DeepBuffer buffer = deep_view(scene, camera_from_aside());
    const auto last = static_cast<float>(scene.model.faces.size());
    const std::ptrdiff_t ground = number_of(buffer.samples, -1, -1),
                         none = number_of(buffer.samples, 0, 0),
                         body = number_of(buffer.samples, 1, last);
    EXPECT_GT(ground, 50);
    EXPECT_GT(body, 50);
    EXPECT_EQ(ground + none + body, 32 * 32);
    // The saddle mirrors the ground, and the ground the saddle.
    std::vector<DeepSample> mirrored;
    for (const DeepBounce& bounce : buffer.bounces) mirrored.push_back(bounce.sample);
    const std::ptrdiff_t on_ground = number_of(mirrored, -1, -1);
    EXPECT_GT(on_ground, 0);
    EXPECT_GT(number_of(mirrored, 1, last), 0);
    EXPECT_EQ(on_ground + number_of(mirrored, 1, last),
              static_cast<std::ptrdiff_t>(mirrored.size()));
}

TEST(DeepView, RefusesOptionsOutOfRange) {
    const Scene scene = saddle_above_ground();
    for (const DeepOptions& options :
         {DeepOptions{.reflections = 0}, DeepOptions{.reflections = 9},
          DeepOptions{.rows = {-1, 2}}, DeepOptions{.rows = {2, 2}}, DeepOptions{.rows = {0, 0}}})
        EXPECT_THROW(deep_view(scene, camera_from_aside(), options), FieldError);
}

TEST(DeepBytes, HaveSizesThenSamplesThenBounces) {
    const Scene scene = saddle_above_ground();
    const DeepBuffer buffer = deep_view(scene, camera_from_aside(), {.rows = {1, 2}});
    const std::string bytes = deep_bytes(buffer);
    constexpr std::size_t header = 32;
    EXPECT_EQ(bytes.substr(0, 8), "KEIKOD1\n");
    const std::uint32_t sizes[] = {32, 32,      1,
                                   2,  32 * 16, static_cast<std::uint32_t>(buffer.bounces.size())};
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(number_at(bytes, 8 + 4 * i), sizes[i]);
    ASSERT_EQ(bytes.size(), header + 32 * buffer.samples.size() + 36 * buffer.bounces.size());
    EXPECT_EQ(std::memcmp(bytes.data() + header, buffer.samples.data(), 32 * 32 * 16), 0);
    ASSERT_GT(buffer.bounces.size(), 0u);
    EXPECT_EQ(number_at(bytes, header + 32 * 32 * 16), buffer.bounces.front().pixel);
}

TEST(ViewFacts, NameEachMaterialOnce) {
    const Scene scene = saddle_above_ground();
    const ViewFacts facts = view_facts(scene, {"mine", camera_from_aside(), 0});
    EXPECT_EQ(facts.view, "mine");
    EXPECT_EQ(facts.faces.size(), scene.model.faces.size());
    ASSERT_EQ(facts.materials.size(), 2u);
    EXPECT_EQ(facts.materials[facts.faces.front().material].name, "mirror");
    EXPECT_EQ(facts.ground, -60);
    EXPECT_NE(facts.ground_material, facts.faces.front().material);
    EXPECT_EQ(facts.views.size(), view_names().size());
    for (const NamedView& view : facts.views) EXPECT_EQ(view.camera.width, 32);
}

} // namespace keiko
