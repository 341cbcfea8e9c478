#include "keiko/visibility/query/scan_plane.h"

#include "tests/support/random_patches.h"
#include <gtest/gtest.h>

#include <algorithm>

using namespace keiko;

namespace {

Vec3 random_place(test::Random& random, double size) {
    return {test::uniform(random, -size, size), test::uniform(random, -size, size),
            test::uniform(random, -size, size)};
}

BoundaryPiece random_border(test::Random& random) {
    BoundaryPiece piece;
    piece.center = random_place(random, 50);
    for (Vec3& point : piece.curve) point = random_place(random, 40);
    for (int i = 0; i <= 100; ++i)
        piece.radius = std::max(piece.radius, piece.at(i / 100.0).length() * 1.01);
    piece.error = test::pick(random, 2) == 0 ? 0 : test::uniform(random, 0, 5);
    return piece;
}

bool holds(const ScanBounds& box, const ScreenPlace& place) {
    return place.along >= box.along_low && place.along <= box.along_high &&
           place.across >= box.across_low && place.across <= box.across_high;
}

/// Over many places of a curve and of what it may be off by; how much of the plane the box is.
void expect_held(const ScanPlane& screen, const BoundaryPiece& piece, test::Random& random,
                 int& bounded) {
    const ScanBounds box = screen.box(piece);
    double low = 1e300, high = -1e300;
    bool whole = true;
    for (int i = 0; i <= 60; ++i) {
        const Vec3 off = test::random_direction(random) * piece.error;
        const ScreenPlace place = screen.place(piece.center + piece.at(i / 60.0) + off);
        if (!(place.depth > 1e-6)) {
            whole = false;
            continue; // behind the viewpoint
        }
        EXPECT_TRUE(holds(box, place)) << place.along << ' ' << place.across;
        low = std::min(low, place.along), high = std::max(high, place.along);
    }
    if (whole && box.along_high - box.along_low < 20 * (high - low) + 1) ++bounded;
}

} // namespace

TEST(ScanPlane, BoxesHoldEveryPlaceOfABorder) {
    test::Random random(31);
    int bounded = 0;
    for (int i = 0; i < 600; ++i) {
        const Vec3 along = test::random_direction(random), middle = random_place(random, 300);
        // In the midst of the border as well as far from it.
        const Vec3 eye = random_place(random, i % 3 == 0 ? 60 : 400);
        const ScanPlane screen(Viewpoint::at(eye, {}), along, middle);
        ASSERT_TRUE(screen.regular());
        expect_held(screen, random_border(random), random, bounded);
    }
    EXPECT_GT(bounded, 100) << "boxes that say something";
}

TEST(ScanPlane, SegmentsSeenEndOnHaveNoScanLines) {
    const Vec3 along(1, 0, 0);
    EXPECT_FALSE(ScanPlane(Viewpoint::at(Vec3(0), {}), along, {500, 0, 0}).regular());
    EXPECT_TRUE(ScanPlane(Viewpoint::at(Vec3(0), {}), along, {500, 1, 0}).regular());
}

TEST(ScanBounds, EmptyOnesOverlapNothing) {
    const ScanBounds all{-1, 1, -1, 1};
    EXPECT_TRUE(ScanBounds().empty());
    EXPECT_FALSE(ScanBounds().overlaps(all));
    EXPECT_TRUE(all.overlaps({1, 2, -3, -1}));
    EXPECT_FALSE(all.overlaps({1.001, 2, -1, 1}));
}
