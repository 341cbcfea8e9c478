#include "keiko/viewer/viewed_scene.h"

#include "keiko/api/results.h"
#include "keiko/base/error.h"

#include "tests/support/temporary_folder.h"
#include "tests/unit/viewer/hood.h"
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace keiko::viewer {

TEST(ViewedScene, ShowsTheRigThatWasSetLast) {
    const auto hood = test::viewed_hood();
    EXPECT_EQ(hood->rig().sources.size(), 1u);
    hood->set_rig({});
    EXPECT_TRUE(hood->rig().sources.empty());
}

TEST(ViewedScene, TakesCameraAndLampsOfARequestInPlaceOfItsOwn) {
    const auto hood = test::viewed_hood();
    EXPECT_EQ(hood->view_of({}).name, "small");
    ViewRequest request;
    request.camera = test::small_camera();
    request.camera->width = 7;
    request.planes.emplace();
    EXPECT_EQ(hood->view_of(request).camera.width, 7);
    EXPECT_TRUE(hood->rig_of(request).sources.empty());
    EXPECT_EQ(hood->rig().sources.size(), 1u);
}

TEST(ViewedScene, PicturesWithoutHiddenFacesAreThoseOfASceneWithoutThem) {
    const SceneOptions shadows{.load = {}, .shadows = true};
    const Scene scene = test::hood_scene(shadows);
    const auto hood = test::viewed_hood({}, shadows);
    ViewRequest request;
    request.camera = test::small_camera();
    const auto still = [&] { return hood->still(request, test::one_row(), {}).color.values; };
    const auto rendered = [&](const Scene& of) {
        return render_view(of, test::one_row(), test::small_camera()).color.values;
    };
    const auto whole = rendered(scene);
    EXPECT_EQ(still(), whole);
    for (const std::uint32_t hidden : {scene.model.faces[0].id, scene.model.faces[1].id}) {
        request.hidden = {hidden};
        const Scene part = without_faces(scene, request.hidden);
        EXPECT_EQ(still(), rendered(part));
        EXPECT_EQ(still(), rendered(part));
        EXPECT_NE(still(), whole);
        EXPECT_EQ(deep_bytes(hood->deep(request, {}, {})),
                  deep_bytes(deep_view(part, test::small_camera())));
    }
    request.hidden.clear();
    EXPECT_EQ(still(), whole);
}

TEST(ViewedScene, JudgesTheBodyThatItHasWithoutItsFile) {
    std::unique_ptr<ViewedScene> viewed;
    std::string expected;
    {
        const keiko::test::TemporaryFolder folder;
        const auto file = folder.path() / "hood.step";
        std::filesystem::copy_file(keiko::test::repository("surfaces/hood.step"), file);
        const std::filesystem::path inputs[] = {file};
        expected = inspection_json(check_models(inputs).inspection, version());
        viewed = std::make_unique<ViewedScene>(open_scene(inputs),
                                               NamedView{"small", test::small_camera(), 0},
                                               LightRig(), CheckOptions());
    }
    EXPECT_EQ(viewed->inspection({}), expected);
}

TEST(ViewedScene, LinesAreJudgedByTheLimitsOfItsSeams) {
    CheckOptions check;
    check.preset.lines.jump = 0.123;
    const auto hood = test::viewed_hood(check);
    EXPECT_EQ(hood->lines({}, {}).preset.lines.jump, 0.123);
}

TEST(ViewedScene, ProfilesOfAReportAreThoseOfItsStretches) {
    const auto hood = test::viewed_hood();
    ReportFolder report;
    report.report = hood->inspection({});
    const auto viewed = [&](const ReportFolder& folder, CheckOptions check = {}) {
        return std::make_unique<ViewedScene>(test::hood_scene(),
                                             NamedView{"small", test::small_camera(), 0},
                                             test::one_row(), std::move(check), folder);
    };
    EXPECT_EQ(viewed(report)->profile("2", {}), hood->profile("2", {}));
    EXPECT_THROW(viewed(report)->profile("99", {}), Error);
    EXPECT_THROW(viewed(report)->profile("two", {}), Error);
    // Numbers are those of the report, even where the body has other stretches before it.
    ReportFolder renumbered = report;
    const std::string first = "\"number\": 1,";
    const std::size_t at = renumbered.report.find(first);
    ASSERT_NE(at, std::string::npos);
    renumbered.report.replace(at, first.size(), "\"number\": 77,");
    EXPECT_EQ(viewed(renumbered)->profile("77", {}), hood->profile("1", {}));
    EXPECT_THROW(viewed(renumbered)->profile("1", {}), Error);
    ReportFolder changed = report;
    changed.changes.push_back({Severity::warning, "hood.step", "has changed"});
    EXPECT_THROW(viewed(changed)->profile("2", {}), Error);
}

TEST(ViewedScene, MakesATextOnceForAllWhoAskAtOnce) {
    const auto hood = test::viewed_hood();
    std::atomic<int> reports = 0;
    const Job job{.progress = [&](const Progress&) { ++reports; }};
    const std::string first = hood->inspection(job);
    const int once = reports;
    EXPECT_GT(once, 0);
    {
        std::vector<std::jthread> others;
        for (int i = 0; i < 3; ++i)
            others.emplace_back([&] { EXPECT_EQ(hood->inspection(job), first); });
    }
    EXPECT_EQ(reports, once);
}

TEST(ViewedScene, ATextThatWasStoppedIsMadeByTheNextWhoAsks) {
    const auto hood = test::viewed_hood();
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(hood->inspection({.stop = stop.get_token()}), Cancelled);
    EXPECT_NE(hood->inspection({}).find("keiko-inspection/1"), std::string::npos);
}

} // namespace keiko::viewer
