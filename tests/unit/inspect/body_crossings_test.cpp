// Closed bodies that pass through each other, and bodies that only touch.
#include "keiko/inspect/overlaps/body_crossings.h"

#include "keiko/base/units.h"
#include "keiko/inspect/inspection.h"

#include "tests/support/model_builder.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace keiko {
namespace {

constexpr double join = 0.5;
constexpr int cases = 40;

/// The six faces of a block from a corner along three edges.
void block(test::ModelBuilder& builder, const Vec3& corner, const std::array<Vec3, 3>& edges) {
    const auto& [x, y, z] = edges;
    for (const auto& [u, v, w] : {std::array{x, y, z}, std::array{y, z, x}, std::array{z, x, y}}) {
        builder.plane(corner, u, v);
        builder.plane(corner + w, u, v);
    }
}

/// Edges of a block turned about z and then about x, degrees.
std::array<Vec3, 3> edges_of(const Vec3& size, double about_z, double about_x) {
    const double a = degrees_to_radians(about_z), b = degrees_to_radians(about_x);
    const auto turned = [&](const Vec3& v) {
        const Vec3 w(v.x * std::cos(a) - v.y * std::sin(a), v.x * std::sin(a) + v.y * std::cos(a),
                     v.z);
        return Vec3(w.x, w.y * std::cos(b) - w.z * std::sin(b),
                    w.y * std::sin(b) + w.z * std::cos(b));
    };
    return {turned({size.x, 0, 0}), turned({0, size.y, 0}), turned({0, 0, size.z})};
}

std::vector<Check> crossings_of(const test::ModelBuilder& builder) {
    std::vector<Check> found;
    for (const Check& look : inspect(builder.build(), {}, join).looks)
        if (look.code == "KEIKO-CROSSING") found.push_back(look);
    return found;
}

const std::array<Vec3, 3> first = edges_of({60, 40, 20}, 0, 0);

TEST(BodyCrossings, AreBlocksThatReachIntoEachOther) {
    test::Random random(20261125);
    for (int i = 0; i < cases; ++i) {
        // A corner of the second block lies 2 to 8 mm inside the first one.
        const std::array<Vec3, 3> second =
            edges_of({30, 30, 30}, test::uniform(random, 12, 78), test::uniform(random, 12, 78));
        const Vec3 corner(test::uniform(random, 10, 50), test::uniform(random, 10, 30),
                          20 - test::uniform(random, 2, 8));
        test::ModelBuilder builder;
        block(builder, {0, 0, 0}, first);
        block(builder, corner, second);
        const Inspection inspection = inspect(builder.build(), {}, join);
        EXPECT_EQ(inspection.verdict, Verdict::pass);
        const auto found = crossings_of(builder);
        ASSERT_EQ(found.size(), 1u) << i;
        EXPECT_NE(found.front().faces.find(" | "), std::string::npos);
        EXPECT_GT(found.front().worst.value, join / 2);
    }
}

TEST(BodyCrossings, AreBarsThroughPlates) {
    test::ModelBuilder builder;
    block(builder, {0, 0, 0}, first);
    block(builder, {20, 15, -10}, edges_of({8, 8, 40}, 20, 0));
    const auto found = crossings_of(builder);
    ASSERT_EQ(found.size(), 1u);
    const double z = found.front().worst.place.z;
    EXPECT_LT(std::min(std::abs(z), std::abs(z - 20)), 1e-6);
}

TEST(BodyCrossings, AreNoneOfBodiesThatTouchOrStandApart) {
    for (const double apart : {-0.2, -0.05, 0.0, 0.05, 0.3, 5.0}) {
        test::ModelBuilder builder;
        block(builder, {0, 0, 0}, first);
        block(builder, {5, 5, 20 + apart}, edges_of({30, 20, 20}, 7, 0));
        EXPECT_TRUE(crossings_of(builder).empty()) << apart;
    }
}

TEST(BodyCrossings, AreNoneOfBodiesPressedIntoEachOtherSideBySide) {
    for (const double pressed : {0.0, 1e-3, 0.2, 0.45}) {
        test::ModelBuilder builder;
        block(builder, {0, 0, 0}, first);
        block(builder, {60 - pressed, 5, -5}, edges_of({30, 30, 40}, 0, 0));
        EXPECT_TRUE(crossings_of(builder).empty()) << pressed;
    }
}

TEST(BodyCrossings, AreThoseOfInstances) {
    // A bar through the middle of a plate, each a part of its own, the bar mirrored and scaled.
    for (const double aside : {0.0, 100.0}) {
        test::ModelBuilder builder;
        block(builder, {0, 0, 0}, first);
        block(builder, {0, 0, 0}, edges_of({4, 4, 20}, 20, 0));
        SurfaceModel model = builder.build();
        model.parts = {{"plate", 0, 6}, {"bar", 6, 6}};
        const Affine placed{{Vec3(-2, 0, 0), Vec3(0, 2, 0), Vec3(0, 0, 2)},
                            Vec3(40 + aside, 15, -10)};
        model.instances = {{0, "plate", {}}, {1, "bar", placed}};
        std::size_t found = 0;
        for (const Check& look : inspect(model, {}, join).looks)
            found += look.code == "KEIKO-CROSSING" ? 1 : 0;
        EXPECT_EQ(found, aside == 0 ? 1u : 0u);
    }
}

TEST(BodyCrossings, AreNoneOfBodiesWithinEachOther) {
    test::ModelBuilder builder;
    block(builder, {0, 0, 0}, first);
    block(builder, {5, 5, 5}, edges_of({20, 20, 10}, 0, 0));
    EXPECT_TRUE(crossings_of(builder).empty());
}

} // namespace
} // namespace keiko
