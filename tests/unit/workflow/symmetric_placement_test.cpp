#include "keiko/api/place.h"

#include "tests/support/paths.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

PlaceResult placed(const char* model, const char* view, const SymmetryChoice& symmetry) {
    const std::filesystem::path file = test::repository(std::string("surfaces/") + model);
    const Scene scene = open_scene(std::span(&file, 1));
    PlaceOptions options;
    options.views = {view};
    options.symmetry = symmetry;
    options.placement.sampling.samples = 4000;
    return place_scene(scene, options);
}

const SymmetryChoice automatic{SymmetryChoice::Kind::automatic}, off{};

/// Whether some lamps reach as far to one side of y = 0 as to the other.
bool is_own_image(const CPlane& lamps) {
    const double along = lamps.u.y, across = lamps.v.y;
    constexpr double close = 1e-9;
    const double size = lamps.u.length() + lamps.v.length();
    const bool square = std::abs(along) < close * size || std::abs(across) < close * size;
    return square && std::abs(lamps.origin.y + (along + across) / 2) < close * size;
}

bool is_image(const CPlane& a, const CPlane& b) {
    const auto image = [](const Vec3& v) { return Vec3(v.x, -v.y, v.z); };
    const double close = 1e-9 * a.u.length();
    return (image(a.origin) - b.origin).length() < close && (image(a.u) - b.u).length() < close &&
           (image(a.v) - b.v).length() < close && a.lamps == b.lamps;
}

void expect_symmetric(const Placement& placement) {
    ASSERT_TRUE(placement.mirror);
    EXPECT_EQ(*placement.mirror, MirrorPlane{});
    for (const PlacedPlane& a : placement.planes)
        EXPECT_TRUE(is_own_image(a.lamps) ||
                    std::any_of(placement.planes.begin(), placement.planes.end(),
                                [&](const auto& b) { return is_image(a.lamps, b.lamps); }));
}

TEST(SymmetricPlacement, OfTheHoodIsSymmetricToIt) {
    expect_symmetric(placed("hood.step", "high-front", automatic).placement);
}

TEST(SymmetricPlacement, OfTheConceptCarIsSymmetricToIt) {
    expect_symmetric(placed("concept-car.step", "front", automatic).placement);
}

/// A requested symmetry plane is used where it holds, and there alone.
TEST(SymmetricPlacement, OfAPlaneThatTheBodyDoesNotHaveIsNone) {
    const SymmetryChoice aside{SymmetryChoice::Kind::plane, {1, 5}};
    EXPECT_FALSE(placed("hood.step", "high-front", aside).placement.mirror);
    EXPECT_FALSE(placed("hood.step", "high-front", off).placement.mirror);
    EXPECT_FALSE(placed("hood.step", "left", automatic).placement.mirror);
}

/// A dent beside the middle: the rig is that of a placement without symmetry.
TEST(SymmetricPlacement, LeavesAsymmetricBodiesAsTheyAre) {
    const Placement found = placed("dent.step", "high-front", automatic).placement;
    const Placement free = placed("dent.step", "high-front", off).placement;
    EXPECT_FALSE(found.mirror);
    ASSERT_EQ(found.planes.size(), free.planes.size());
    for (std::size_t i = 0; i < found.planes.size(); ++i) {
        EXPECT_EQ(found.planes[i].lamps.origin, free.planes[i].lamps.origin);
        EXPECT_EQ(found.planes[i].lamps.u, free.planes[i].lamps.u);
        EXPECT_EQ(found.planes[i].lamps.v, free.planes[i].lamps.v);
    }
}

} // namespace
} // namespace keiko
