#include "keiko/visibility/silhouettes/view_volume.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

using namespace keiko;
using namespace keiko::test;

namespace {

Vec3 random_place(Random& random, double size) {
    return {uniform(random, -size, size), uniform(random, -size, size),
            uniform(random, -size, size)};
}

/// Four corners of a parallelogram some way off, now and then with the side that is faced.
struct View {
    Viewpoint viewpoint;
    std::vector<Vec3> corners;
    std::optional<Vec3> facing;

    explicit View(Random& random) : viewpoint(Viewpoint::at(random_place(random, 20), {})) {
        const Vec3 middle =
            viewpoint.place() + random_direction(random) * uniform(random, 200, 400);
        const Vec3 a = random_direction(random) * 60, b = random_direction(random) * 60;
        corners = {middle - a - b, middle + a - b, middle - a + b, middle + a + b};
        if (pick(random, 2) == 0) facing = (middle - viewpoint.place()).normalized();
    }
    ViewVolume volume() const { return {viewpoint, corners, facing}; }
    /// Between the viewpoint and somewhere in the region.
    Vec3 place_inside(Random& random) const {
        const double s = uniform(random, 0, 1), t = uniform(random, 0, 1);
        const Vec3 in_region =
            corners[0] + (corners[1] - corners[0]) * s + (corners[2] - corners[0]) * t;
        return viewpoint.place() + (in_region - viewpoint.place()) * uniform(random, 0.001, 1);
    }
};

/// A net of points about a place, with what else is bounded by them.
struct Thing {
    NetFrame frame;
    HomogeneousNet net{3, 3, {}};
    BoundaryPiece::Curve curve{Vec3(0), Vec3(0), Vec3(0), Vec3(0), Vec3(0), Vec3(0)};
    Box3 box;

    Thing(Random& random, const Vec3& center) {
        frame.center = center;
        const Vec3 normal = random_direction(random);
        const Vec3 along = normal.cross(random_direction(random)).normalized();
        frame.rows = {along, normal.cross(along), normal};
        const double size = std::exp(uniform(random, std::log(0.1), std::log(100)));
        for (int i = 0; i < 16; ++i) {
            const Vec3 p = random_place(random, size);
            net.points.push_back(frame.local(Vec4(p.x, p.y, p.z, 1)));
            box.extend(center + p);
        }
        for (Vec3& p : curve) p = random_place(random, size), box.extend(center + p);
    }
};

} // namespace

TEST(ViewVolume, HoldsWhatLiesBetweenTheApexAndItsRegion) {
    Random random(81);
    for (int trial = 0; trial < 2000; ++trial) {
        const View view(random);
        const ViewVolume volume = view.volume();
        const Vec3 place = view.place_inside(random);
        Thing thing(random, place + random_place(random, 50));
        const Vec3 p = place - thing.frame.center;
        thing.net.points.assign(16, thing.frame.local(Vec4(p.x, p.y, p.z, 1)));
        thing.curve.fill(p);
        thing.box = {place, place};
        ViewVolume::Sides a = volume.all_sides(), b = a, c = a;
        EXPECT_TRUE(volume.may_hold(thing.box, a));
        EXPECT_TRUE(volume.may_hold(thing.curve, thing.frame.center, 0, b));
        EXPECT_TRUE(volume.may_hold(affine_bounds(thing.net), thing.frame, c));
    }
}

TEST(ViewVolume, SidesThatABoxLiesInsideOfTellNothingOfItsParts) {
    Random random(82);
    int held = 0, left_out = 0, fewer = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const View view(random);
        const ViewVolume volume = view.volume();
        const Thing thing(random, view.place_inside(random) + random_place(random, 60));
        ViewVolume::Sides sides = volume.all_sides();
        if (!volume.may_hold(thing.box, sides)) continue;
        fewer += sides != volume.all_sides();
        const auto expect_same = [&](const auto& may_hold) {
            ViewVolume::Sides all = volume.all_sides(), some = sides;
            const bool by_all = may_hold(all), by_some = may_hold(some);
            EXPECT_EQ(by_some, by_all);
            EXPECT_EQ(some & ~all, 0u);
            ++(by_all ? held : left_out);
        };
        expect_same([&](ViewVolume::Sides& s) {
            return volume.may_hold(thing.curve, thing.frame.center, 0, s);
        });
        Box3 part = thing.box;
        part.upper = part.center();
        expect_same([&](ViewVolume::Sides& s) { return volume.may_hold(part, s); });
        const AffineBounds points = affine_bounds(thing.net);
        expect_same([&](ViewVolume::Sides& s) { return volume.may_hold(points, thing.frame, s); });
    }
    EXPECT_GT(held, 300);
    EXPECT_GT(left_out, 100);
    EXPECT_GT(fewer, 300);
}
