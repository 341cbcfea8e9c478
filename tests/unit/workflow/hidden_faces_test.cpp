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

TEST(HiddenFaces, ShowWhatATracerMadeAnewShows) {
    const Scene whole = hood(false, "ground = { z = 0 }\n");
    const std::vector<std::uint32_t> ids = ids_of(whole);
    const std::vector<std::uint32_t> hidden(ids.begin(), ids.begin() + 2);
    const Scene part = without_faces(whole, hidden);
    const Tracer anew(visible_model(whole, part.model), {.second_derivatives = true});
    const DeepBuffer expected = deep_view(whole, anew, camera), found = deep_view(part, camera);
    ASSERT_EQ(found.bounces.size(), expected.bounces.size());
    std::size_t hits = 0;
    for (std::size_t i = 0; i < found.samples.size(); ++i) {
        const DeepSample &a = found.samples[i], &b = expected.samples[i];
        ASSERT_EQ(a.face, b.face) << i;
        if (b.face == 0) continue;
        ++hits;
        EXPECT_FLOAT_EQ(a.t, b.t) << i;
        if (a.way != b.way) {
            EXPECT_NEAR(a.way / b.way, 1, 1e-4) << i;
        }
    }
    EXPECT_GT(hits, found.samples.size() / 4);
}

TEST(HiddenFaces, AreNotInATracerOfPicturesAlone) {
    const Scene whole = hood();
    const std::uint32_t id = whole.model.faces.front().id;
    const Tracer seen = seen_without(whole, {&id, 1});
    EXPECT_EQ(deep_bytes(deep_view(whole, seen, camera)),
              deep_bytes(deep_view(without_faces(whole, {&id, 1}), camera)));
    EXPECT_FALSE(occluders_without(whole, {&id, 1}));
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
