// Bends about smooth seams that are not wider than what is negligible, and what is none.
#include "keiko/inspect/flaws/narrow_bends.h"

#include "keiko/base/units.h"
#include "keiko/inspect/inspection.h"

#include "sheets.h"
#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr double join = 0.5, length = test::sheet_length, panel = 50; ///< mm

Vec2 direction(double degrees) {
    const double angle = degrees_to_radians(degrees);
    return {std::cos(angle), std::sin(angle)};
}

/// Adds a face of a section, y and z in mm, drawn out along x; `flipped` runs it backwards.
void draw(test::ModelBuilder& builder, std::vector<Vec2> section, bool flipped = false) {
    if (flipped) std::reverse(section.begin(), section.end());
    std::vector<Vec3> points;
    for (const double x : {0.0, length})
        for (const Vec2& p : section) points.emplace_back(x, p.x, p.y);
    builder.patch(1, static_cast<int>(section.size()) - 1, points);
}

std::vector<NarrowBend> bends_of(const SurfaceModel& model) {
    const Inspection inspection = inspect(model, {}, join);
    const auto bends = narrow_bends(model, inspection.seams, inspection.pieces, {});
    const auto is_kink = [](const Check& check) {
        return check.message.find("the angle across a strip") != std::string::npos;
    };
    const auto count =
        std::count_if(inspection.findings.begin(), inspection.findings.end(), is_kink);
    EXPECT_EQ(static_cast<std::size_t>(count), bends.size());
    for (const NarrowBend& bend : bends)
        EXPECT_EQ(inspection.faces[bend.face.face].verdict, Verdict::fail);
    return bends;
}

double largest(const std::vector<NarrowBend>& bends) {
    double angle = 0;
    for (const NarrowBend& bend : bends) angle = std::max(angle, bend.angle);
    return angle;
}

/// A section from the origin whose first control points, `apart` mm from each other, go on along
/// y, while the others lie at an angle.
std::vector<Vec2> turned_section(int straight, double apart, double degrees) {
    std::vector<Vec2> section;
    for (int i = 0; i <= straight; ++i) section.emplace_back(i * apart, 0);
    for (const double share : {0.4, 0.7, 1.0})
        section.push_back(direction(degrees) * share * panel);
    return section;
}

/// A flat panel beside a face that turns right beyond its seam.
SurfaceModel turned_beside(int straight, double apart, double degrees, bool flipped) {
    test::ModelBuilder builder;
    const auto flat = [&] { draw(builder, {{-panel, 0}, {0, 0}}); };
    if (!flipped) flat();
    draw(builder, turned_section(straight, apart, degrees), flipped);
    if (flipped) flat();
    return builder.build();
}

/// Panels on either side of strips `width` mm wide that bend evenly by `degrees` each.
SurfaceModel bent_strips(int count, double width, double degrees, bool flipped = false) {
    test::ModelBuilder builder;
    draw(builder, {{-panel, 0}, {0, 0}});
    Vec2 at(0);
    for (int i = 0; i < count; ++i) {
        const Vec2 middle = at + direction(i * degrees) * (width / 2);
        const Vec2 end = middle + direction((i + 1) * degrees) * (width / 2);
        draw(builder, {at, middle, end}, flipped);
        at = end;
    }
    draw(builder, {at, at + direction(count * degrees) * panel}, flipped);
    return builder.build();
}

TEST(NarrowBends, LieInOneStrip) {
    for (const double width : {0.001, 0.02, 0.05, 0.09})
        for (const double degrees : {0.15, 1.0, 3.0, 4.5}) {
            const auto found = bends_of(bent_strips(1, width, degrees));
            ASSERT_EQ(found.size(), 1u) << width << " " << degrees;
            EXPECT_EQ(found[0].face.face, 1u);
            EXPECT_EQ(found[0].sides[0].face + found[0].sides[1].face, 2u);
            EXPECT_NEAR(found[0].width, width, 1e-3 * width);
            EXPECT_NEAR(found[0].angle, degrees, 1e-6);
            EXPECT_NEAR(found[0].length, length, 1e-3);
        }
}

TEST(NarrowBends, LieInAFaceBesideItsSeam) {
    for (const int straight : {1, 2})
        for (const double apart : {2.5e-5, 1e-4})
            for (const double degrees : {-2.0, -0.11, 0.11, 1.0, 2.0})
                for (const bool flipped : {false, true}) {
                    const auto found = bends_of(turned_beside(straight, apart, degrees, flipped));
                    ASSERT_EQ(found.size(), 1u) << straight << " " << apart << " " << degrees;
                    EXPECT_EQ(found[0].face.face, flipped ? 0u : 1u);
                    EXPECT_NEAR(found[0].angle, std::abs(degrees), 0.02 * std::abs(degrees));
                    EXPECT_NEAR(found[0].length, length, 1e-3);
                }
}

TEST(NarrowBends, PassBelowTheLimit) {
    for (const double degrees : {-0.09, 0.05, 0.09}) {
        for (const int straight : {1, 2})
            EXPECT_TRUE(bends_of(turned_beside(straight, 1e-4, degrees, false)).empty());
        EXPECT_TRUE(bends_of(bent_strips(1, 0.05, degrees)).empty());
        EXPECT_TRUE(bends_of(bent_strips(10, 0.005, degrees / 10)).empty());
    }
}

TEST(NarrowBends, LieOnBothSidesOfASeam) {
    for (const double degrees : {0.11, 3.0}) {
        test::ModelBuilder builder;
        std::vector<Vec2> left = turned_section(2, 1e-4, degrees / 2);
        for (Vec2& p : left) p.x = -p.x;
        draw(builder, left, true);
        draw(builder, turned_section(2, 1e-4, degrees / 2));
        const auto found = bends_of(builder.build());
        ASSERT_EQ(found.size(), 1u);
        EXPECT_NEAR(found[0].angle, degrees, 0.02 * degrees);
    }
}

TEST(NarrowBends, AddUpOverStrips) {
    for (const bool flipped : {false, true}) {
        EXPECT_NEAR(largest(bends_of(bent_strips(10, 0.005, 0.095, flipped))), 0.95, 1e-6);
        EXPECT_NEAR(largest(bends_of(bent_strips(10, 0.005, 0.15, flipped))), 1.5, 1e-6);
        EXPECT_NEAR(largest(bends_of(bent_strips(2, 0.02, 0.095, flipped))), 0.19, 1e-6);
        // Borders of strips this narrow may be paired with the strip after the next.
        const double of_narrowest = largest(bends_of(bent_strips(20, 5e-5, 0.011, flipped)));
        EXPECT_GT(of_narrowest, 0.19);
        EXPECT_LT(of_narrowest, 0.221);
    }
}

TEST(NarrowBends, AddUpOverAngles) {
    // Flat strips whose seams turn by less than the limit.
    test::ModelBuilder builder;
    draw(builder, {{-panel, 0}, {0, 0}});
    Vec2 at(0);
    double degrees = 0;
    for (const double width : {0.01, 0.02, 0.03, panel}) {
        degrees += 0.09;
        const Vec2 end = at + direction(degrees) * width;
        draw(builder, {at, end});
        at = end;
    }
    EXPECT_NEAR(largest(bends_of(builder.build())), 0.36, 1e-6);
}

TEST(NarrowBends, AreNoneWhereTheyAreWiderOrCreases) {
    EXPECT_TRUE(bends_of(bent_strips(1, 0.25, 3)).empty());
    EXPECT_TRUE(bends_of(bent_strips(1, 0.05, 30)).empty()) << "a feature line";
    EXPECT_TRUE(bends_of(bent_strips(10, 0.005, 3)).empty()) << "a feature line";
}

TEST(NarrowBends, AreNoFillets) {
    // Cylinders in one to four faces, between panels that touch them.
    for (const double radius : {0.3, 1.0, 3.0, 100.0})
        for (const int parts : {1, 2, 4})
            for (const double turn : {30.0, 90.0}) {
                test::ModelBuilder builder;
                const double from = degrees_to_radians(90 - turn), to = degrees_to_radians(90);
                const Vec3 begin(0, radius * std::cos(from), radius * std::sin(from) - radius);
                const Vec3 along(0, std::sin(from), -std::cos(from));
                builder.plane(begin, {length, 0, 0}, along * panel);
                for (int i = 0; i < parts; ++i)
                    builder.rational_patch(
                        1, 2,
                        test::arc_sheet(-radius, radius, from + i * (to - from) / parts,
                                        from + (i + 1) * (to - from) / parts));
                builder.plane({0, -panel, 0}, {length, 0, 0}, {0, panel, 0});
                EXPECT_TRUE(bends_of(builder.build()).empty()) << radius << " " << parts;
            }
}

} // namespace
} // namespace keiko
