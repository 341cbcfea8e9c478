#include "keiko/base/error.h"
#include "keiko/placement/place_lamps.h"
#include "keiko/scene/view.h"

#include "tests/support/analytic_models.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

/// A body seen by one camera.
struct Seen {
    explicit Seen(SurfaceModel body, std::string_view view)
        : model(std::move(body)),
          tracer(model),
          camera(frame_view(view, tracer.bounds(), {.width = 320, .height = 180})) {}

    std::vector<ViewSample> samples() const {
        SamplingOptions few;
        few.samples = 4000;
        return sample_views(tracer, model, std::span(&camera, 1), few);
    }

    SurfaceModel model;
    Tracer tracer;
    Camera camera;
};

/// Level, from (0, -500, 0) to (1000, 500, 0).
SurfaceModel level_mirror() {
    return test::bonnet_model(1000, 1000, 0);
}

TEST(RatedRig, TellsOfAPlacedRigWhatPlacingTold) {
    const Seen seen(test::bonnet_model(1100, 1400, 60), "high-front");
    const Placement placed =
        place_lamps(seen.samples(), seen.model, seen.tracer.bounds(), seen.camera.height);
    const Placement rated = rated_rig(seen.samples(), seen.model, seen.camera.height, placed.rig);
    EXPECT_DOUBLE_EQ(rated.coverage, placed.coverage);
    EXPECT_DOUBLE_EQ(rated.stripes.median, placed.stripes.median);
    EXPECT_DOUBLE_EQ(rated.stripes.in_range, placed.stripes.in_range);
    ASSERT_EQ(rated.planes.size(), placed.planes.size());
    EXPECT_NEAR(rated.planes[0].score.coverage, placed.planes[0].score.coverage, 0.02);
    EXPECT_EQ(rated.unreached.size(), placed.unreached.size());
}

TEST(RatedRig, LampsBehindTheEyeOfAMirrorStandAsFarApartAsTheirImages) {
    // A level mirror viewed from straight above. Lamps at height h over it have images as deep
    // below, so that the spacing in the picture is the pitch over (eye + h), by the picture's
    // scale.
    Seen seen(level_mirror(), "top");
    seen.camera = Camera{.projection = Projection::perspective,
                         .eye = {500, 0, 1000},
                         .target = {500, 0, 0},
                         .up = {0, 1, 0},
                         .vertical_fov = 28,
                         .width = 320,
                         .height = 180};
    const CPlane lamps{.origin = {-5000, -5000, 3000},
                       .u = {10000, 0, 0},
                       .v = {0, 10000, 0},
                       .lamps = 50,
                       .diameter = 26};
    LightRig rig;
    rig.sources.emplace_back(lamps);
    const Placement rated = rated_rig(seen.samples(), seen.model, seen.camera.height, rig);
    const double pixels_per_slope = 90 / std::tan(14 * std::acos(-1.0) / 180);
    EXPECT_DOUBLE_EQ(rated.coverage, 1);
    EXPECT_NEAR(rated.stripes.median, 200.0 / 4000 * pixels_per_slope, 1e-6);
    EXPECT_NEAR(rated.stripes.uniformity, 1, 1e-6);
    EXPECT_TRUE(rated.unreached.empty());
}

TEST(RatedRig, TellsWhereTheBodyMirrorsNoLampAndWhy) {
    const Seen seen(level_mirror(), "top");
    const CPlane right_half{.origin = {500, -9000, 3000},
                            .u = {9000, 0, 0},
                            .v = {0, 18000, 0},
                            .lamps = 12,
                            .diameter = 26};
    LightRig rig;
    rig.sources.emplace_back(right_half);
    const Placement rated = rated_rig(seen.samples(), seen.model, seen.camera.height, rig);
    EXPECT_NEAR(rated.coverage, 0.5, 0.03);
    ASSERT_EQ(rated.unreached.size(), 1u);
    const UnreachedRegion& region = rated.unreached.front();
    EXPECT_NEAR(region.share, 1 - rated.coverage, 1e-9);
    EXPECT_EQ(region.because, UnreachedBecause::beyond_lamps);
    EXPECT_LT(region.box.upper.x, 520);
    EXPECT_LT(region.place.x, 500);
}

TEST(RatedRig, RefusesARigWithoutLampsOnAPlane) {
    const Seen seen(level_mirror(), "top");
    EXPECT_THROW(rated_rig(seen.samples(), seen.model, 180, LightRig{}), Error);
}

TEST(PlaceLamps, HangsLampsOnlyWhereTheyMay) {
    const Seen seen(test::bonnet_model(1100, 1400, 60), "high-front");
    PlacementOptions options;
    options.where.towards = {{0, 0, 1}};
    const Placement above =
        place_lamps(seen.samples(), seen.model, seen.tracer.bounds(), 180, options);
    for (const PlacedPlane& plane : above.planes)
        EXPECT_NEAR(std::abs(plane.lamps.u.cross(plane.lamps.v).normalized().z), 1, 1e-12);
    options.where.frames = {{{0, 0, 1700}, {1, 0, 0}, {0, 1, 0}}};
    const Placement given =
        place_lamps(seen.samples(), seen.model, seen.tracer.bounds(), 180, options);
    for (const PlacedPlane& plane : given.planes) EXPECT_DOUBLE_EQ(plane.lamps.origin.z, 1700);
}

TEST(FeatureDirection, RunsAlongTheRulingsOfACylinder) {
    const Seen seen(test::cylinder_model(test::stretched({400, 400, 1500}, {0, 1, 0}, {0, 0, 400})),
                    "top");
    int told = 0;
    for (const ViewSample& sample : seen.samples()) {
        if (sample.feature.strength == 0) continue;
        ++told;
        EXPECT_NEAR(sample.feature.strength, 1 / 400.0, 1e-12);
        const Vec2 axis = *project(seen.camera, sample.position() + Vec3(0, 1, 0)) -
                          *project(seen.camera, sample.position());
        EXPECT_NEAR(std::abs(sample.feature.along.dot(axis.normalized())), 1, 1e-4);
    }
    EXPECT_GT(told, 500);
}

} // namespace
} // namespace keiko
