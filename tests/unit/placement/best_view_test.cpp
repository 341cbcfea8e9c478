#include "keiko/placement/best_view.h"

#include "keiko/base/error.h"

#include "tests/support/analytic_models.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

NamedView best(const SurfaceModel& model) {
    return best_view(Tracer(model), model);
}

/// A sheet that bulges by `crown` along `outwards`, about 1 m each way.
SurfaceModel panel(const Vec3& outwards, double crown) {
    SurfaceModel model = test::bonnet_model(1000, 1000, crown);
    model.instances[0].transform = test::stretched(Vec3(1), outwards, {0, 0, 0});
    return model;
}

TEST(BestView, LooksAtTheOuterSideOfAPanel) {
    for (const Vec3& outwards : {Vec3(0, -1, 0.1), Vec3(0, 1, 0.1), Vec3(-1, 0, 0.1),
                                 Vec3(1, 0, 0.1), Vec3(-1, -1, 0.3), Vec3(0, 0, 1)}) {
        const NamedView view = best(panel(outwards, 150));
        const Vec3 towards_eye = (view.camera.eye - view.camera.target).normalized();
        EXPECT_GT(towards_eye.dot(outwards.normalized()), 0.3) << view.name;
    }
}

TEST(BestView, NeverLooksFromBelow) {
    const NamedView view = best(panel({0, 0, -1}, 150)); // its outer side is on the floor
    EXPECT_GE(view.camera.eye.z, view.camera.target.z - 1);
}

TEST(BestView, APanelIsNotSeenEdgeOn) {
    // From any level view a flat roof is a line.
    const NamedView roof = best(test::bonnet_model(1500, 1100, 5));
    EXPECT_TRUE(roof.name.starts_with("high-") || roof.name == "top") << roof.name;
}

TEST(BestView, OfEquallyGoodViewsTheFirstWins) {
    const SurfaceModel sphere = test::sphere_model(Affine::scale(300));
    EXPECT_EQ(best(sphere).name, "left"); // level views frame the box most tightly
}

TEST(BestView, FramesThePartInThePictureAskedFor) {
    const SurfaceModel model = panel({0, -1, 0.1}, 100);
    const Tracer tracer(model);
    const NamedView view = best_view(tracer, model, {.width = 400, .height = 300});
    EXPECT_EQ(view.camera, frame_view(view.name, tracer.bounds(), {.width = 400, .height = 300}));
    EXPECT_GT(view.score, 0.1);
    EXPECT_LT(view.score, 1.5);
}

TEST(BestView, ThreadsDoNotMatter) {
    const SurfaceModel model = panel({1, 0.5, 0.2}, 100);
    const Tracer tracer(model);
    Job one, two;
    one.threads = 1;
    two.threads = 2;
    const NamedView a = best_view(tracer, model, {}, one), b = best_view(tracer, model, {}, two);
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.score, b.score);
}

} // namespace
} // namespace keiko
