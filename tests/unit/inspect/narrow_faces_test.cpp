// Strips of faces that are narrower than the join distance, and what is none.
#include "keiko/inspect/seams/narrow_faces.h"

#include "keiko/base/units.h"
#include "keiko/inspect/inspection.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace keiko {
namespace {

constexpr double join = 0.5, length = 100, panel = 50; ///< mm
constexpr double radius = 400;                         ///< mm, of bent panels

using Profile = std::vector<Vec2>; ///< corners of a section, y and z, mm

Vec2 direction(double degrees) {
    const double angle = degrees_to_radians(degrees);
    return {std::cos(angle), std::sin(angle)};
}

/// A panel, a strip of a width at an angle to it, and a panel that turns by `kink` against the
/// first.
Profile stepped(double width, double angle, double kink) {
    const Vec2 corner = direction(angle) * width;
    return {{-panel, 0}, {0, 0}, corner, corner + direction(kink) * panel};
}

/// A face for each part of the section, drawn out along x.
SurfaceModel drawn(const Profile& profile) {
    test::ModelBuilder builder;
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        const Vec2 way = profile[i + 1] - profile[i];
        builder.plane({0, profile[i].x, profile[i].y}, {length, 0, 0}, {0, way.x, way.y});
    }
    return builder.build();
}

/// A face for each part of the section, turned about an axis `radius` mm below y = 0.
SurfaceModel turned(const Profile& profile) {
    test::ModelBuilder builder;
    const double half = length / 2 / radius, w = std::cos(half);
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        std::vector<Vec4> points;
        for (const auto& [angle, weight] :
             {std::array{-half, 1.0}, std::array{0.0, w}, std::array{half, 1.0}})
            for (const Vec2& p : {profile[i], profile[i + 1]}) {
                const double r = (radius + p.y) / weight;
                points.push_back(Vec4(r * std::sin(angle), p.x, r * std::cos(angle) - radius, 1) *
                                 weight);
            }
        builder.rational_patch(2, 1, points);
    }
    return builder.build();
}

std::vector<NarrowFace> narrow_of(const SurfaceModel& model) {
    const Inspection inspection = inspect(model, {}, join);
    return narrow_faces(model, inspection.seams, inspection.pieces, join);
}

std::optional<Check> look_at(const SurfaceModel& model) {
    std::optional<Check> found;
    for (const Check& look : inspect(model, {}, join).looks) {
        if (look.code != "G-SU-NA") continue;
        EXPECT_FALSE(found);
        found = look;
    }
    return found;
}

constexpr std::array widths{0.02, 0.1, 0.3, 0.49};
constexpr std::array angles{5.5, 30.0, 60.0, 90.0};
constexpr std::array kinks{0.0, 3.0, 20.0};

TEST(NarrowFaces, AreStepsAndRidgesBetweenPanels) {
    for (const double width : widths)
        for (const double angle : angles)
            for (const double kink : kinks)
                for (const bool bent : {false, true}) {
                    const Profile profile = stepped(width, angle, kink);
                    const SurfaceModel model = bent ? turned(profile) : drawn(profile);
                    const auto found = narrow_of(model);
                    ASSERT_EQ(found.size(), 1u) << width << " " << angle << " " << kink << bent;
                    const NarrowFace& strip = found.front();
                    EXPECT_EQ(strip.face.face, 1u);
                    EXPECT_NEAR(strip.width, width, 1e-9);
                    const double turn = degrees_to_radians(std::max(angle, std::abs(angle - kink)));
                    EXPECT_NEAR(strip.step, width * std::sin(turn), 1e-9);
                    EXPECT_NEAR(strip.angle, kink, 1e-6);
                    EXPECT_NEAR(strip.length, length, bent ? 0.2 : 1e-9);
                    EXPECT_NEAR(std::abs(strip.place.y),
                                width / 2 * std::cos(degrees_to_radians(angle)), 1e-9);
                }
}

TEST(NarrowFaces, AreListedAsLooksOfModelsThatPass) {
    const SurfaceModel model = drawn(stepped(0.2, 30, 0));
    EXPECT_EQ(inspect(model, {}, join).verdict, Verdict::pass);
    const auto look = look_at(model);
    ASSERT_TRUE(look);
    EXPECT_NEAR(look->worst.value, 0.2, 1e-9);
    EXPECT_EQ(look->worst.limit, join);
    EXPECT_EQ(look->faces, "face 2");
    EXPECT_NE(look->message.find("face 1 | face 3 step by 0.1 mm and turn by"), std::string::npos)
        << look->message;
}

TEST(NarrowFaces, HaveACreaseOnOneSideAtLeast) {
    // The strip bends from 30 degrees back into the direction of the second panel.
    test::ModelBuilder builder;
    builder.plane({0, -panel, 0}, {length, 0, 0}, {0, panel, 0});
    const Vec2 corner = direction(30) * 0.2, end = corner + Vec2(0.2, 0);
    builder.patch(1, 2,
                  {{0, 0, 0},
                   {0, corner.x, corner.y},
                   {0, end.x, end.y},
                   {length, 0, 0},
                   {length, corner.x, corner.y},
                   {length, end.x, end.y}});
    builder.plane({0, end.x, end.y}, {length, 0, 0}, {0, panel, 0});
    const auto found = narrow_of(builder.build());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found.front().face.face, 1u);
    EXPECT_NEAR(found.front().step, 0.1, 1e-9);
    EXPECT_NEAR(found.front().angle, 0, 1e-6);
}

TEST(NarrowFaces, AreStepsInsideAFace) {
    // A sheet of degree 1 across, whose knots leave the section as it is.
    for (const double width : widths)
        for (const double angle : {30.0, 90.0}) {
            test::ModelBuilder builder;
            std::vector<Vec4> points;
            for (const double x : {0.0, length})
                for (const Vec2& p : stepped(width, angle, 0)) points.emplace_back(x, p.x, p.y, 1);
            builder.nurbs({1, 1, {0, 0, 1, 1}, {0, 0, 1, 2, 3, 3}, points});
            const SurfaceModel model = builder.build();
            EXPECT_EQ(inspect(model, {}, join).verdict, Verdict::pass);
            const auto found = narrow_of(model);
            ASSERT_EQ(found.size(), 1u) << width << " " << angle;
            EXPECT_NEAR(found.front().width, width, 1e-9);
            EXPECT_NEAR(found.front().step, width * std::sin(degrees_to_radians(angle)), 1e-9);
            EXPECT_NEAR(found.front().angle, 0, 1e-6);
        }
}

TEST(NarrowFaces, AreBeadsHalfRound) {
    test::ModelBuilder builder;
    const double r = 0.15;
    builder.plane({0, -panel, 0}, {length, 0, 0}, {0, panel - r, 0});
    std::vector<Vec4> points;
    for (const double x : {0.0, length})
        for (const Vec3& p : {Vec3(-r, 0, 1), Vec3(-r, r, std::sqrt(0.5)), Vec3(0, r, 1),
                              Vec3(r, r, std::sqrt(0.5)), Vec3(r, 0, 1)})
            points.push_back(Vec4(x, p.x, p.y, 1) * p.z);
    builder.nurbs({1, 2, {0, 0, 1, 1}, {0, 0, 0, 1, 1, 2, 2, 2}, points});
    builder.plane({0, r, 0}, {length, 0, 0}, {0, panel - r, 0});
    const auto found = narrow_of(builder.build());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found.front().face.face, 1u);
    EXPECT_NEAR(found.front().width, 2 * r, 1e-9);
    EXPECT_NEAR(found.front().angle, 0, 1e-6);
}

TEST(NarrowFaces, AreFoundWhereAStepFadesOut) {
    // 0.4 mm high at x = 0, nothing at the end.
    test::ModelBuilder builder;
    builder.plane({0, -panel, 0}, {length, 0, 0}, {0, panel, 0});
    builder.patch(1, 1, {{0, 0, 0}, {0, 0, 0.4}, {length, 0, 0}, {length, 0, 1e-5}});
    builder.patch(1, 1, {{0, 0, 0.4}, {0, panel, 0.4}, {length, 0, 1e-5}, {length, panel, 1e-5}});
    const auto found = narrow_of(builder.build());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found.front().step, 0.4, 1e-4);
    EXPECT_NEAR(found.front().place.x, 0, 1e-3);
    EXPECT_GT(found.front().length, 0.8 * length);
}

TEST(NarrowFaces, AreNoWiderStripsNorSharpEdges) {
    for (const double angle : {30.0, 90.0})
        for (const double width : {0.51, 3.0, 10.0}) {
            EXPECT_TRUE(narrow_of(drawn(stepped(width, angle, 0))).empty()) << width;
            EXPECT_TRUE(narrow_of(drawn(stepped(width, angle, angle + 60))).empty()) << width;
        }
    for (const double angle : {12.0, 45.0, 90.0, 150.0})
        EXPECT_TRUE(narrow_of(drawn({{-panel, 0}, {0, 0}, direction(angle) * panel})).empty());
}

TEST(NarrowFaces, AreNoFillets) {
    // A quarter of a cylinder, 3 mm in radius, between two panels at a right angle; one in 0.3 mm
    // has no crease.
    for (const double r : {3.0, 0.3}) {
        test::ModelBuilder builder;
        builder.plane({0, -panel, 0}, {length, 0, 0}, {0, panel, 0});
        std::vector<Vec4> points;
        for (const double x : {0.0, length}) {
            points.emplace_back(x, 0, 0, 1);
            points.push_back(Vec4(x, r, 0, 1) * std::sqrt(0.5));
            points.emplace_back(x, r, r, 1);
        }
        builder.rational_patch(1, 2, points);
        builder.plane({0, r, r}, {length, 0, 0}, {0, 0, panel});
        EXPECT_TRUE(narrow_of(builder.build()).empty()) << r;
    }
}

/// The six faces of a block, with a corner at the origin.
SurfaceModel block(const Vec3& size) {
    test::ModelBuilder builder;
    const Vec3 x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
    for (const auto& [u, v, w] : {std::array{x, y, z}, std::array{y, z, x}, std::array{z, x, y}}) {
        builder.plane({0, 0, 0}, u, v);
        builder.plane(w, u, v);
    }
    return builder.build();
}

TEST(NarrowFaces, AreNoneOfABlockUnlessItIsThin) {
    EXPECT_TRUE(narrow_of(block({60, 40, 20})).empty());
    EXPECT_TRUE(narrow_of(block({5, 4, 0.6})).empty());
    const auto thin = narrow_of(block({60, 40, 0.3}));
    ASSERT_EQ(thin.size(), 4u);
    for (const NarrowFace& face : thin) {
        EXPECT_NEAR(face.width, 0.3, 1e-9);
        EXPECT_NEAR(face.angle, 180, 1e-6);
    }
}

TEST(NarrowFaces, AreNoPointedFaces) {
    // Tips of 15 degrees and more between creases.
    for (const double tip : {15.0, 40.0}) {
        test::ModelBuilder builder;
        const double wide = length * std::tan(degrees_to_radians(tip));
        builder.patch(1, 1, {{0, 0, 0}, {0, 0, 0}, {length, 0, 0}, {length, wide, 0}});
        builder.plane({0, 0, 0}, {length, 0, 0}, {0, 0, panel});
        builder.plane({0, 0, 0}, {length, wide, 0}, {0, 0, panel});
        EXPECT_TRUE(narrow_of(builder.build()).empty()) << tip;
    }
}

TEST(NarrowFaces, AreNoSlitsNorHemsOfOneFace) {
    // A sheet folded around an edge, 0.2 mm in radius: its borders lie 0.4 mm apart, each beside a
    // flange.
    test::ModelBuilder builder;
    const double r = 0.2, w = std::sqrt(0.5);
    std::vector<Vec4> points;
    for (const double x : {0.0, length}) {
        points.emplace_back(x, 0, 0, 1), points.emplace_back(x, panel / 2, 0, 1);
        points.emplace_back(x, panel, 0, 1);
        points.push_back(Vec4(x, panel + r, 0, 1) * w);
        points.emplace_back(x, panel + r, r, 1);
        points.push_back(Vec4(x, panel + r, 2 * r, 1) * w);
        points.emplace_back(x, panel, 2 * r, 1), points.emplace_back(x, panel / 2, 2 * r, 1);
        points.emplace_back(x, 0, 2 * r, 1);
    }
    builder.nurbs({1, 2, {0, 0, 1, 1}, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, points});
    builder.plane({0, 0, 0}, {length, 0, 0}, {0, 0, -panel});
    builder.plane({0, 0, 2 * r}, {length, 0, 0}, {0, 0, panel});
    EXPECT_TRUE(narrow_of(builder.build()).empty());
}

} // namespace
} // namespace keiko
