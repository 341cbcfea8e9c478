#include "keiko/base/units.h"
#include "keiko/inspect/inspection.h"
#include "keiko/inspect/seams/seam_measure.h"

#include "tests/support/long_run.h"
#include "tests/support/model_builder.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

/// Sheets whose control points coincide along a line, so that they bend there although no knot
/// allows it, against the angle in closed form.
namespace keiko {
namespace {

constexpr double length = 100, width = 80; ///< mm

/// A section of the sheet: x runs from -50 to 50 mm, and beyond 0 the section rises by an angle.
struct Section {
    int degree = 3;
    std::vector<double> knots, places; ///< mm of `places`, along the section

    Vec3 point(double place, double degrees) const {
        const double angle = place > 0 ? degrees_to_radians(degrees) : 0;
        return {place * std::cos(angle), 0, place * std::sin(angle)};
    }
};

/// Simple knots.
Section spline(int degree, std::vector<double> places) {
    Section section{degree, {}, std::move(places)};
    const auto spans = static_cast<int>(section.places.size()) - degree;
    section.knots.assign(static_cast<std::size_t>(degree) + 1, 0);
    for (int i = 1; i < spans; ++i) section.knots.push_back(i);
    section.knots.insert(section.knots.end(), static_cast<std::size_t>(degree) + 1, spans);
    return section;
}

/// A cubic with `count` control points within `apart` mm about x = 0.
Section coincident(int count, double apart = 0) {
    std::vector<double> places{-50, -35, -20};
    for (int i = 0; i < count; ++i)
        places.push_back(apart * (i - 0.5 * (count - 1)) / std::max(1, count - 1));
    places.insert(places.end(), {20, 35, 50});
    return spline(3, places);
}

/// One patch whose control points, except for the outer ones, all lie at x = 0.
Section one_patch(int degree) {
    std::vector<double> places(static_cast<std::size_t>(degree) + 1, 0);
    places.front() = -50, places.back() = 50;
    return spline(degree, places);
}

/// `drawn`: times its size.
SurfaceModel sheet(const Section& section, double degrees, bool along_u, double weight = 1,
                   double drawn = 1) {
    std::vector<Vec4> rows[2];
    const auto count = section.places.size();
    for (std::size_t row = 0; row < 2; ++row)
        for (std::size_t i = 0; i < count; ++i) {
            const Vec3 p =
                (section.point(section.places[i], degrees) + Vec3(0, width * double(row), 0)) *
                drawn;
            const double w = std::pow(weight, double(i));
            rows[row].emplace_back(p.x * w, p.y * w, p.z * w, w);
        }
    NurbsSurface surface{1, section.degree, {0, 0, 1, 1}, section.knots, {}};
    for (const auto& row : rows)
        surface.points.insert(surface.points.end(), row.begin(), row.end());
    if (along_u) {
        std::swap(surface.degree_u, surface.degree_v), std::swap(surface.knots_u, surface.knots_v);
        surface.points.clear();
        for (std::size_t i = 0; i < count; ++i)
            for (const auto& row : rows) surface.points.push_back(row[i]);
    }
    test::ModelBuilder builder;
    builder.nurbs(surface);
    return builder.build();
}

/// `near` mm: from the middle of the bend to the side at which its angle is stated.
void expect_bend(const SurfaceModel& model, double degrees, double accuracy, double near = 0.051) {
    const auto lines = measure_knot_lines(model, {});
    ASSERT_EQ(lines.size(), 1u) << degrees;
    EXPECT_TRUE(lines[0].internal);
    ASSERT_TRUE(lines[0].angle.has_value());
    EXPECT_NEAR(lines[0].angle->value, degrees, accuracy);
    EXPECT_NEAR(lines[0].length, width, 1e-6);
    EXPECT_EQ(lines[0].gap.value, 0);
    EXPECT_NEAR(lines[0].angle->place.x, 0, near);
    const bool fails = degrees > CriteriaPreset().angle && degrees < CriteriaPreset().feature_angle;
    EXPECT_EQ(lines[0].verdict, fails || degrees > 179 ? Verdict::fail : Verdict::pass);
}

constexpr std::array<double, 7> planted{0.05, 0.15, 1, 3, 10, 45, 90};

TEST(BendsInside, AreFoundWhereControlPointsCoincideAtSimpleKnots) {
    for (const double degrees : planted)
        for (const bool along_u : {true, false})
            for (const int count : {3, 4, 5})
                expect_bend(sheet(coincident(count), degrees, along_u), degrees, 1e-7);
}

TEST(BendsInside, AreFoundInsideOnePatch) {
    for (const double degrees : planted)
        for (const bool along_u : {true, false})
            for (const int degree : {19, 25})
                expect_bend(sheet(one_patch(degree), degrees, along_u), degrees, 0.02 * degrees);
}

TEST(BendsInside, AreFoundWhereControlPointsNearlyCoincide) {
    for (const double apart : {1e-6, 1e-4, 1e-3})
        for (const double degrees : {0.15, 3.0, 45.0})
            expect_bend(sheet(coincident(3, apart), degrees, true), degrees, 0.05 * degrees);
    // A seventh of this bend is outside of the window, or as even as beside it.
    expect_bend(sheet(coincident(3, 1e-2), 3, true), 3, 0.15 * 3);
}

/// A section with as many knots as its degree close together about x = 0. `spans` mm: the lengths
/// between them.
Section with_close_knots(int degree, const std::vector<double>& spans) {
    Section section{degree, std::vector<double>(static_cast<std::size_t>(degree) + 1, 0), {}};
    const double speed = 50; // mm a unit
    double whole = 0, knot = 1;
    for (const double span : spans) whole += span;
    section.knots.push_back(knot -= whole / 2 / speed);
    for (const double span : spans) section.knots.push_back(knot += span / speed);
    section.knots.insert(section.knots.end(), static_cast<std::size_t>(degree) + 1, 2);
    for (int i = -degree; i <= degree; ++i) section.places.push_back(50.0 * i / degree);
    return section;
}

TEST(BendsInside, AreFoundWhereKnotsLieCloseTogether) {
    const std::vector<std::vector<double>> spans{
        {0.04, 0.04},  {0.0475, 0.0475},   {0.05, 0.049},           {0.07, 0.02},
        {0.01, 0.085}, {0.03, 0.03, 0.03}, {0.02, 0.02, 0.03, 0.02}};
    for (const std::vector<double>& of : spans)
        for (const double degrees : {0.15, 1.0, 4.9, 30.0})
            for (const bool along_u : {true, false}) {
                const auto degree = static_cast<int>(of.size()) + 1;
                SCOPED_TRACE(testing::Message() << of.front() << ' ' << degree);
                expect_bend(sheet(with_close_knots(degree, of), degrees, along_u), degrees,
                            0.02 * degrees, 0.07);
                EXPECT_TRUE(measure_knot_lines(sheet(with_close_knots(degree, of), 0, along_u), {})
                                .empty());
            }
    // Bends wider than the window are judged by their curvature.
    EXPECT_TRUE(measure_knot_lines(sheet(with_close_knots(3, {0.2, 0.2}), 3, true), {}).empty());
}

TEST(BendsInside, AreFoundOfRationalPatches) {
    for (const double weight : {0.5, 1e-2, 30.0})
        expect_bend(sheet(coincident(3), 3, true, weight), 3, 1e-6);
}

TEST(BendsInside, WhereTheSheetTurnsBackAreFolds) {
    // x = (t - 1/2)^2: the sheet lies on itself on both sides of t = 1/2.
    test::ModelBuilder builder;
    std::vector<Vec3> points;
    for (const double x : {25.0, -25.0, 25.0})
        for (const double y : {0.0, width}) points.emplace_back(x, y, 0);
    builder.patch(2, 1, points);
    expect_bend(builder.build(), 180, 1e-6);
}

TEST(BendsInside, AreFoundWhereTheParametersRunAskew) {
    // Control points that coincide except for their places along the line: S_u is parallel to S_v
    // there.
    for (const double degrees : {0.15, 1.0, 26.6, 90.0})
        for (const double shift : {1.0, 30.0, 75.0}) {
            NurbsSurface surface{2, 1, {0, 0, 0, 1, 2, 2, 2}, {0, 0, 1, 1}, {}};
            const double angle = degrees_to_radians(degrees);
            const Vec3 section[] = {{-100, 0, 0},
                                    {0, 0, 0},
                                    {0, 0, 0},
                                    {100 * std::cos(angle), 0, 100 * std::sin(angle)}};
            const double along[] = {0, 1, 3, 4}; // of Greville's abscissae, times `shift`
            for (int i = 0; i < 4; ++i)
                for (const double y : {0.0, 500.0})
                    surface.points.emplace_back(section[i].x, y + shift * along[i], section[i].z,
                                                1);
            test::ModelBuilder builder;
            builder.nurbs(surface);
            const auto lines = measure_knot_lines(builder.build(), {});
            ASSERT_EQ(lines.size(), 1u) << degrees << " " << shift;
            ASSERT_TRUE(lines[0].angle.has_value());
            EXPECT_NEAR(lines[0].angle->value, degrees, 1e-6 + 1e-3 * degrees);
            EXPECT_NEAR(lines[0].length, 500, 1e-6);
        }
}

TEST(BendsInside, WhereTheParametersRunAskewAndTheSheetTurnsBackAreFolds) {
    NurbsSurface surface{2, 1, {0, 0, 0, 1, 2, 2, 2}, {0, 0, 1, 1}, {}};
    const double x[] = {0, -100, -100, 50}, along[] = {0, 75, 225, 300};
    for (int i = 0; i < 4; ++i)
        for (const double y : {0.0, 500.0}) surface.points.emplace_back(x[i], y + along[i], 0, 1);
    test::ModelBuilder builder;
    builder.nurbs(surface);
    EXPECT_EQ(inspect(builder.build()).verdict, Verdict::fail);
}

TEST(BendsInside, EndWhereTrimsDo) {
    test::ModelBuilder builder;
    NurbsSurface surface{3, 1, {}, {0, 0, 1, 1}, {}};
    const Section section = coincident(3);
    surface.knots_u = section.knots;
    for (const double place : section.places)
        for (const double y : {0.0, width}) {
            const Vec3 p = section.point(place, 3);
            surface.points.emplace_back(p.x, y, p.z, 1);
        }
    builder.nurbs(surface);
    const double end = section.knots.back();
    builder.polygon({{0, 0.25}, {end, 0.25}, {end, 0.75}, {0, 0.75}});
    EXPECT_NEAR(measure_knot_lines(builder.build(), {}).at(0).length, width / 2, 1e-6);
    // A face that ends at the bend has none inside.
    test::ModelBuilder half;
    half.nurbs(surface);
    half.polygon({{0, 0}, {end / 2, 0}, {end / 2, 1}, {0, 1}});
    EXPECT_TRUE(measure_knot_lines(half.build(), {}).empty());
}

TEST(BendsInside, AreKeptInNarrowMaterial) {
    const Section section = coincident(3);
    NurbsSurface surface{3, 1, section.knots, {0, 0, 1, 1}, {}};
    for (const double place : section.places)
        for (const double y : {0.0, width}) {
            const Vec3 p = section.point(place, 3);
            surface.points.emplace_back(p.x, y, p.z, 1);
        }
    test::ModelBuilder builder;
    builder.nurbs(surface);
    const double end = section.knots.back();
    builder.polygon({{0, 0.47}, {end, 0.47}, {end, 0.49}, {0, 0.49}});
    const auto lines = measure_knot_lines(builder.build(), {});
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NEAR(lines[0].length, 0.02 * width, 1e-6);
}

/// A sheet drawn `drawn` times as large, in two instances that bring it back to its size.
SurfaceModel redrawn(double apart, double drawn) {
    SurfaceModel model = sheet(coincident(3, apart), 3, true, 1, drawn);
    model.instances.push_back(model.instances.at(0));
    for (std::size_t i = 0; i < 2; ++i)
        model.instances[i].transform =
            Affine::translate({0, 500.0 * double(i), 0}) * Affine::scale(1 / drawn);
    return model;
}

TEST(BendsInside, AreFoundByTheSizeAtWhichAFaceIsPlaced) {
    for (const double drawn : {0.01, 1.0, 100.0})
        for (const double apart : {0.03, 0.5}) {
            const auto lines = measure_knot_lines(redrawn(apart, drawn), {});
            ASSERT_EQ(lines.size(), apart < 0.1 ? 2u : 0u) << drawn << ' ' << apart;
            for (const MeasuredSeam& line : lines) EXPECT_GT(line.angle->value, 2);
        }
    // Each instance has its own window.
    SurfaceModel mixed = redrawn(0.5, 1);
    mixed.instances[1].transform = Affine::scale(0.05);
    const auto lines = measure_knot_lines(mixed, {});
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].instance_a, 1u);
}

TEST(BendsInside, AreNotSeenInSmoothSheets) {
    for (const bool along_u : {true, false}) {
        for (const int count : {2, 3, 4})
            EXPECT_TRUE(measure_knot_lines(sheet(coincident(count), 0, along_u), {}).empty());
        EXPECT_TRUE(measure_knot_lines(sheet(one_patch(25), 0, along_u), {}).empty());
        EXPECT_TRUE(measure_knot_lines(sheet(one_patch(3), 3, along_u), {}).empty());
        // Two coincident points leave a bend as wide as the spans.
        EXPECT_TRUE(measure_knot_lines(sheet(coincident(2), 3, along_u), {}).empty());
    }
    for (const double weight : {1e-3, 1e3})
        EXPECT_TRUE(measure_knot_lines(sheet(one_patch(4), 0, true, weight), {}).empty());
}

/// x = t^3 and z = x^2 / 2 R, t from -1 to 1: the speed is 0 at t = 0 on an evenly bent sheet.
TEST(BendsInside, AreNotSeenWhereAnEvenlyBentSheetStandsStill) {
    for (const double radius : {20.0, 300.0, 1e5}) {
        constexpr double half = 50;
        // Bernstein coefficients over [-1, 1] of t^3 and t^6, of degree 6.
        const std::array<double, 7> cube{-1, 0, 0.2, 0, -0.2, 0, 1};
        const std::array<double, 7> sixth{1, -1, 1, -1, 1, -1, 1};
        std::vector<Vec3> points;
        for (std::size_t i = 0; i < 7; ++i)
            for (const double y : {0.0, width})
                points.emplace_back(half * cube[i], y, half * half / (2 * radius) * sixth[i]);
        test::ModelBuilder builder;
        builder.patch(6, 1, points);
        EXPECT_TRUE(measure_knot_lines(builder.build(), {}).empty()) << radius;
    }
}

TEST(BendsInside, AreNotSeenAtPoles) {
    // A sheet with one side that is a point.
    std::vector<Vec3> bowl;
    for (const double x : {-30.0, -10.0, 10.0, 30.0})
        for (const double v : {0.0, 1.0, 2.0, 3.0}) bowl.emplace_back(x * v / 3, 10 * v, v * v);
    test::ModelBuilder builder;
    builder.patch(3, 3, bowl);
    EXPECT_TRUE(measure_knot_lines(builder.build(), {}).empty());
}

TEST(BendsInside, OfRandomSheetsAreFound) {
    test::Random random(test::first_seed());
    const int sheets = test::long_run() ? 5000 : 300;
    for (int i = 0; i < sheets; ++i) {
        const double degrees =
            std::pow(10, test::uniform(random, std::log10(0.02), std::log10(90)));
        std::vector<double> places{-50};
        const auto before = 1 + test::pick(random, 4), after = 1 + test::pick(random, 4);
        const int degree = 3 + static_cast<int>(test::pick(random, 3));
        for (std::size_t k = 0; k < before; ++k) places.push_back(test::uniform(random, -45, -2));
        for (int k = 0; k < degree + static_cast<int>(test::pick(random, 3)); ++k)
            places.push_back(0);
        for (std::size_t k = 0; k < after; ++k) places.push_back(test::uniform(random, 2, 45));
        places.push_back(50);
        std::sort(places.begin(), places.end());
        const Section section = spline(degree, places);
        const bool along_u = test::pick(random, 2) == 0;
        SCOPED_TRACE(i);
        expect_bend(sheet(section, degrees, along_u), degrees, 1e-5 * degrees + 1e-6);
        EXPECT_TRUE(measure_knot_lines(sheet(section, 0, along_u), {}).empty());
    }
}

} // namespace
} // namespace keiko
