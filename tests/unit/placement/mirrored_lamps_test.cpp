#include "keiko/placement/place_lamps.h"
#include "keiko/placement/plane_frame.h"
#include "keiko/scene/view.h"

#include "tests/support/analytic_models.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace keiko {
namespace {

/// The corners of some lamps' rectangle, in an order of their own.
std::array<Vec3, 4> corners(const CPlane& lamps) {
    std::array<Vec3, 4> all{lamps.origin, lamps.origin + lamps.u, lamps.origin + lamps.v,
                            lamps.origin + lamps.u + lamps.v};
    std::sort(all.begin(), all.end(), [](const Vec3& a, const Vec3& b) {
        return std::array{a.x, a.z, a.y} < std::array{b.x, b.z, b.y};
    });
    return all;
}

/// Whether some lamps are others' image: the same corners, and the lamps along the same lines.
bool is_image(const CPlane& a, const CPlane& b, const MirrorPlane& mirror) {
    constexpr double close = 1e-9; // of the lamps' size
    const CPlane image{.origin = mirror.image(a.origin),
                       .u = mirror.image_of_direction(a.u),
                       .v = mirror.image_of_direction(a.v)};
    const double least = close * a.u.length();
    for (const Vec3& corner : corners(image)) {
        const auto there = corners(b);
        if (std::none_of(there.begin(), there.end(),
                         [&](const Vec3& other) { return (other - corner).length() < least; }))
            return false;
    }
    return a.lamps == b.lamps && image.u.cross(b.u).length() < least * b.u.length();
}

bool is_symmetric(const Placement& placement, const MirrorPlane& mirror) {
    return std::all_of(placement.planes.begin(), placement.planes.end(), [&](const auto& a) {
        return std::any_of(placement.planes.begin(), placement.planes.end(),
                           [&](const auto& b) { return is_image(a.lamps, b.lamps, mirror); });
    });
}

/// An ellipsoid that is symmetric about y = 12, seen along x from above.
struct Body {
    SurfaceModel model =
        test::sphere_model(test::stretched({700, 500, 300}, {0, 0, 1}, {0, 12, 300}));
    Tracer tracer{model};
    Camera camera{.eye = {-4000, 12, 2500}, .target = {0, 12, 300}, .width = 128, .height = 72};

    Placement place(std::optional<MirrorPlane> mirror, int planes = 3) const {
        PlacementOptions options;
        options.sampling.samples = 2000, options.planes = planes, options.mirror = mirror;
        return place_lamps(tracer, model, camera, options);
    }
};

TEST(MirroredLamps, AreSymmetricInThemselvesOrInPairs) {
    const Body body;
    const MirrorPlane mirror{1, 12};
    for (const int planes : {1, 2, 3, 5}) {
        const Placement placement = body.place(mirror, planes);
        EXPECT_LE(placement.planes.size(), static_cast<std::size_t>(planes));
        EXPECT_TRUE(is_symmetric(placement, mirror)) << planes;
        EXPECT_EQ(placement.mirror, mirror);
        EXPECT_GT(placement.coverage, 0.3);
    }
}

/// They cover about as much as lamps that are free to hang anywhere.
TEST(MirroredLamps, GiveUpLittleCoverage) {
    const Body body;
    EXPECT_GT(body.place(MirrorPlane{1, 12}).coverage, body.place({}).coverage - 0.1);
}

TEST(MirroredLamps, RectanglesGrowToTheirImage) {
    const MirrorPlane mirror{1, 5};
    const PlaneFrame frame{{100, 2, 50}, {1, 0, 0}, {0, 1, 0}};
    ASSERT_TRUE(is_own_image(frame, mirror));
    const Box2 extent = symmetric_extent(frame, {Vec2(-3, -1), Vec2(4, 9)}, mirror);
    EXPECT_EQ(extent.lower, Vec2(-3, -3));
    EXPECT_EQ(extent.upper, Vec2(4, 9));
    EXPECT_FALSE(is_own_image(frame.turned(0.13), mirror));
}

TEST(MirroredLamps, CamerasAreTheirOwnImageOnThePlaneAlone) {
    Camera camera{.eye = {-4000, 12, 2500}, .target = {0, 12, 300}};
    EXPECT_TRUE(is_own_image(camera, {1, 12}));
    EXPECT_FALSE(is_own_image(camera, {1, 0}));
    EXPECT_FALSE(is_own_image(camera, {0, -4000}));
    camera.up = {0, 0.1, 1};
    EXPECT_FALSE(is_own_image(camera, {1, 12}));
}

} // namespace
} // namespace keiko
