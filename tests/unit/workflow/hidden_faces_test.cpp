#include "keiko/api/scene.h"
#include "keiko/api/view.h"
#include "keiko/base/error.h"

#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace keiko {
namespace {

constexpr Camera camera{
    .eye = {-2000, -1500, 1800}, .target = {560, 0, 720}, .width = 64, .height = 36};

Scene hood(bool shadows = false, const std::string& ground = "") {
    const test::TemporaryFolder folder;
    const auto file =
        folder.file("scene.toml", "format = \"keiko-scene/1\"\n" + ground + "[[model]]\nfile = \"" +
                                      test::repository("surfaces/hood.step").string() + "\"\n");
    const std::filesystem::path inputs[] = {file};
    return open_scene(inputs, {.load = {}, .shadows = shadows});
}

/// Faces in a picture of the scene; -1 is the ground, 0 nothing.
std::set<float> faces_in(const Scene& scene) {
    std::set<float> faces;
    for (const DeepSample& sample : deep_view(scene, camera).samples) faces.insert(sample.face);
    return faces;
}

std::vector<std::uint32_t> ids_of(const Scene& scene) {
    std::vector<std::uint32_t> ids;
    for (const Face& face : scene.model.faces) ids.push_back(face.id);
    return ids;
}

} // namespace

TEST(HiddenFaces, LeaveTheNumbersOfTheOthers) {
    const Scene whole = hood();
    std::set<float> expected = faces_in(whole);
    ASSERT_GT(expected.size(), 2u);
    const float gone = *expected.rbegin();
    const std::uint32_t id = whole.model.faces[static_cast<std::size_t>(gone) - 1].id;
    const std::set<float> left = faces_in(without_faces(whole, {&id, 1}));
    EXPECT_FALSE(left.count(gone));
    expected.erase(gone);
    EXPECT_TRUE(std::includes(left.begin(), left.end(), expected.upper_bound(0), expected.end()));
}

TEST(HiddenFaces, AllOfThemLeaveTheGroundAlone) {
    const Scene whole = hood(false, "ground = { z = 0 }\n");
    const std::set<float> left = faces_in(without_faces(whole, ids_of(whole)));
    for (const float face : left) EXPECT_LE(face, 0);
    EXPECT_TRUE(left.count(-1));
    EXPECT_EQ(whole.ground(), 0.0);
}

TEST(HiddenFaces, CastNoShadows) {
    const Scene whole = hood(true, "ground = { z = 0 }\n");
    const Scene bare = without_faces(whole, ids_of(whole));
    ASSERT_TRUE(bare.occluders);
    EXPECT_LT(bare.occluders->statistics().boundary_pieces,
              whole.occluders->statistics().boundary_pieces);
}

TEST(HiddenFaces, MustBeThere) {
    const Scene whole = hood();
    const std::uint32_t unknown = 4'000'000'000;
    EXPECT_THROW(without_faces(whole, {&unknown, 1}), FieldError);
    EXPECT_EQ(faces_in(without_faces(whole, {})), faces_in(whole));
}

} // namespace keiko
