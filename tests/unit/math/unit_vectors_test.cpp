#include "keiko/math/unit_vectors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace keiko;

namespace {

/// Directions to all sides, those along axes and on the equator among them.
std::vector<Vec3> directions() {
    std::vector<Vec3> all;
    for (int x = -4; x <= 4; ++x)
        for (int y = -4; y <= 4; ++y)
            for (int z = -4; z <= 4; ++z)
                if (x != 0 || y != 0 || z != 0) all.push_back(Vec3(x, y, z).normalized());
    return all;
}

} // namespace

TEST(UnitVectors, AreRestoredFromTheOctahedron) {
    for (const Vec3& unit : directions()) {
        const Vec2 place = octahedral(unit);
        EXPECT_LE(std::max(std::abs(place.x), std::abs(place.y)), 1);
        EXPECT_LT((from_octahedral(place) - unit).length(), 1e-15) << unit;
    }
}

// The error of single precision is below a second of arc, all over the sphere.
TEST(UnitVectors, OfSinglePrecisionAreOffByLessThanATenMillionth) {
    for (const Vec3& unit : directions()) {
        const Vec2 place = octahedral(unit);
        const Vec2 stored(static_cast<double>(static_cast<float>(place.x)),
                          static_cast<double>(static_cast<float>(place.y)));
        EXPECT_LT((from_octahedral(stored) - unit).length(), 1.2e-7) << unit;
    }
}

TEST(UnitVectors, HaveNoPlaceWithoutLength) {
    EXPECT_TRUE(std::isnan(octahedral(Vec3(0)).x));
}

TEST(AxesAcross, AreSquareAndRightHanded) {
    for (const Vec3& unit : directions())
        for (const double side : {-1.0, 1.0}) {
            if (side * unit.z < -0.5) continue;
            const AxesAcross axes(unit, side);
            EXPECT_NEAR(axes.x.length(), 1, 1e-14) << unit;
            EXPECT_NEAR(axes.x.dot(unit), 0, 1e-14) << unit;
            EXPECT_LT((axes.x.cross(axes.y) - unit).length(), 1e-14) << unit;
        }
}
