#include "keiko/inspect/combs/comb_curves.h"

#include "keiko/base/error.h"
#include "keiko/geometry/bezier/differential_geometry.h"

#include "tests/support/analytic_models.h"
#include "tests/unit/inspect/bernstein.h"
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using std::numbers::pi;

std::vector<CombCurve> sections(const SurfaceModel& model, const char* plane) {
    CombOptions options;
    options.planes = {section_plane(plane)};
    return comb_curves(model, options).curves;
}

template <class F>
void for_each_sample(const CombCurve& curve, const F& visit) {
    for (const CombPiece& piece : curve.pieces)
        for (const CombSample& sample : piece.samples) visit(sample);
}

TEST(SectionPlane, IsReadFromItsText) {
    const SectionPlane y = section_plane("y=-120.5");
    EXPECT_EQ(y.normal, Vec3(0, 1, 0));
    EXPECT_EQ(y.height, -120.5);
    const SectionPlane aslant = section_plane("3,0,4=10");
    EXPECT_NEAR((aslant.normal - Vec3(0.6, 0, 0.8)).length(), 0, 1e-15);
    EXPECT_EQ(aslant.height, 10);
    for (const char* wrong : {"", "w=1", "y", "y=", "y=1mm", "0,0,0=1", "1,2=3", "y=nan", "z=inf",
                              " y=20", "y= 20", "y=20\n", "y=0x14", "1,2,3,4=5", "=3"})
        EXPECT_THROW(section_plane(wrong), Error) << wrong;
}

TEST(CombCurves, OfASphereAreCircles) {
    const Vec3 centre(4000, -900, 1200);
    const SurfaceModel model = test::sphere_model(test::stretched(Vec3(80), {1, 2, 3}, centre));
    const auto curves = sections(model, "y=-860");
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_TRUE(curves[0].closed);
    EXPECT_EQ(curves[0].name, "y=-860");
    const double radius = std::sqrt(80.0 * 80 - 40 * 40);
    EXPECT_NEAR(curves[0].length, 2 * pi * radius, 0.1);
    EXPECT_TRUE(inflections_of(curves[0]).empty());
    for_each_sample(curves[0], [&](const CombSample& sample) {
        EXPECT_NEAR(sample.place.y, -860, 1e-9);
        EXPECT_NEAR((sample.place - centre).length(), 80, 1e-9);
        EXPECT_NEAR(sample.bend.curvature, -1 / radius, 1e-9);
        EXPECT_NEAR(sample.bend.normal_curvature, -1 / 80.0, 1e-9);
        EXPECT_NEAR(sample.bend.towards.y, 0, 1e-12);
        EXPECT_NEAR(sample.bend.towards.dot(sample.place - centre), radius, 1e-6);
    });
}

/// A plane at 45 degrees to a cylinder: an ellipse with the half axes r and r sqrt 2.
TEST(CombCurves, OfACylinderCutAslantAreEllipses) {
    const double r = 40;
    const SurfaceModel model =
        test::cylinder_model(test::stretched({r, r, 100}, {0, 0, 1}, Vec3(0)));
    const auto curves = sections(model, "0,1,1=0");
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_TRUE(curves[0].closed);
    double least = 1, most = 0;
    for_each_sample(curves[0], [&](const CombSample& sample) {
        const double x = sample.place.x, y = sample.place.y * std::sqrt(2.0),
                     a = r * std::sqrt(2.0);
        const double exact =
            a * r / std::pow(a * a * x * x / (r * r) + r * r * y * y / (a * a), 1.5);
        EXPECT_NEAR(sample.bend.curvature, -exact, 1e-9);
        least = std::min(least, exact), most = std::max(most, exact);
    });
    EXPECT_NEAR(least, r / (2 * r * r), 1e-4 / r); // at the ends of the short axis
    EXPECT_NEAR(most, std::sqrt(2.0) / r, 1e-2 / r);
    EXPECT_NEAR(std::abs(most_bent(curves[0]).bend.curvature), most, 1e-12);
}

/// Between two samples the comb is straight to within the tolerance.
TEST(CombCurves, AreSampledUntilTheCombIsTrue) {
    const double r = 40;
    const SurfaceModel model =
        test::cylinder_model(test::stretched({r, r, 100}, {0, 0, 1}, Vec3(0)));
    CombOptions options;
    options.planes = {section_plane("0,1,1=0")};
    options.chord_error = 1; // too coarse for the comb by itself
    const auto exact = [&](const Vec3& p) {
        const double angle = std::atan2(p.y, p.x), a = r * std::sqrt(2.0);
        return a * r /
               std::pow(std::pow(a * std::cos(angle), 2) + std::pow(r * std::sin(angle), 2), 1.5);
    };
    for (const CombPiece& piece : comb_curves(model, options).curves.at(0).pieces)
        for (std::size_t i = 1; i < piece.samples.size(); ++i) {
            const CombSample &a = piece.samples[i - 1], &b = piece.samples[i];
            const double straight = -(a.bend.curvature + b.bend.curvature) / 2;
            EXPECT_NEAR(straight, exact((a.place + b.place) / 2), 0.012 * std::sqrt(2.0) / r);
        }
}

TEST(CombCurves, GoOnOverPatchesAndFaces) {
    test::ModelBuilder builder;
    // A bent strip, then a flat one beyond its end, 0.1 mm off.
    builder.patch(2, 1,
                  {{0, 0, 0}, {0, 100, 0}, {50, 0, 20}, {50, 100, 20}, {100, 0, 0}, {100, 100, 0}});
    builder.plane({100.1, 0, 0}, {50, 0, -40}, {0, 100, 0});
    const auto curves = sections(builder.build(), "y=30");
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_EQ(curves[0].pieces.size(), 2u);
    EXPECT_FALSE(curves[0].closed);
    const CombPiece& flat = curves[0].pieces[curves[0].pieces[0].face == 1 ? 0 : 1];
    for (const CombSample& sample : flat.samples) EXPECT_NEAR(sample.bend.curvature, 0, 1e-15);
    // z = 0.8 (t - t^2) * 100 / 2 over x = 100 t, so z'' = -8e-3 at its top: along -z.
    double most = 0;
    for_each_sample(curves[0], [&](const CombSample& sample) {
        const Vec3 bent = sample.bend.towards * sample.bend.curvature;
        most = std::max(most, bent.length());
        EXPECT_LE(bent.z, 1e-15);
    });
    EXPECT_NEAR(most, 8e-3, 1e-5);
}

TEST(CombCurves, EndAtTrims) {
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, 100, 0});
    builder.polygon({{0.1, 0.1}, {0.9, 0.1}, {0.5, 0.9}});
    const auto curves = sections(builder.build(), "y=50");
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_NEAR(curves[0].length, 40, 1e-6); // a triangle of base 80, half way up
}

/// Parallels and meridians of a sphere about z.
TEST(CombCurves, OfIsoCurvesAreNormalCurvatures) {
    const SurfaceModel model = test::sphere_model(test::stretched(Vec3(80), {0, 0, 1}, Vec3(0)));
    CombOptions options;
    options.iso_curves = 3;
    const auto curves = comb_curves(model, options).curves;
    int parallels = 0;
    for (const CombCurve& curve : curves) {
        parallels += curve.closed ? 1 : 0;
        for_each_sample(curve, [&](const CombSample& sample) {
            EXPECT_NEAR(sample.bend.curvature, -1 / 80.0, 1e-9);
            EXPECT_NEAR((sample.bend.towards * 80 - sample.place).length(), 0, 1e-6);
        });
    }
    EXPECT_EQ(parallels, 3);
    EXPECT_EQ(curves.size(), 6u);
}

/// Against the second difference of three points of the section itself.
TEST(CombCurves, AreTrueOnAFreeForm) {
    const SurfaceModel model = test::bonnet_model(1200, 1400, 80);
    CombOptions options;
    options.planes = {section_plane("1,2,0.5=300")};
    options.chord_error = 1e-7;
    const auto curves = comb_curves(model, options).curves;
    ASSERT_EQ(curves.size(), 1u);
    int compared = 0;
    for (const CombPiece& piece : curves[0].pieces)
        for (std::size_t i = 40; i + 40 < piece.samples.size(); i += 40) {
            const Vec3 &a = piece.samples[i - 40].place, &b = piece.samples[i].place,
                       &c = piece.samples[i + 40].place;
            // The circle through three points.
            const double area2 = (b - a).cross(c - a).length();
            const double circle =
                2 * area2 / ((b - a).length() * (c - b).length() * (a - c).length());
            EXPECT_NEAR(std::abs(piece.samples[i].bend.curvature), circle, 1e-3 * circle);
            ++compared;
        }
    EXPECT_GT(compared, 5);
}

/// z = 1e-5 (x - middle)^3 over x = 0 .. 100.
SurfaceModel turned_over_at(double middle) {
    const auto z = [&](double x) { return 1e-5 * std::pow(x - middle, 3); };
    const auto slope = [&](double x) { return 3e-5 * std::pow(x - middle, 2); };
    const double third = 100 / 3.0;
    std::vector<Vec3> points;
    const double heights[] = {z(0), z(0) + third * slope(0), z(100) - third * slope(100), z(100)};
    for (int i = 0; i < 4; ++i)
        for (const double y : {0.0, 50.0}) points.emplace_back(third * i, y, heights[i]);
    test::ModelBuilder builder;
    builder.patch(3, 1, points);
    return builder.build();
}

// Between samples, and where one is without any curvature.
TEST(CombCurves, TellWhereTheyTurnOver) {
    for (const double middle : {30.0, 50.0}) {
        const auto curves = sections(turned_over_at(middle), "y=20");
        ASSERT_EQ(curves.size(), 1u);
        const std::vector<Vec3> places = inflections_of(curves[0]);
        ASSERT_EQ(places.size(), 1u) << middle;
        EXPECT_NEAR(places[0].x, middle, 0.05);
    }
}

/// The radius of each circle about z of a torus that a plane z = const meets, by half a turn's
/// teeth, and the heights of its samples.
void expect_circle(const CombCurve& curve, double radius, double z) {
    EXPECT_TRUE(curve.closed) << z;
    EXPECT_NEAR(curve.length, 2 * pi * radius, 1e-3 * radius);
    for_each_sample(curve, [&](const CombSample& sample) {
        EXPECT_NEAR(std::hypot(sample.place.x, sample.place.y), radius, 1e-6);
        EXPECT_NEAR(sample.place.z, z, 1e-6);
        EXPECT_NEAR(std::abs(sample.bend.curvature), 1 / radius, 1e-9);
        // Bends towards the axis.
        EXPECT_LT(sample.bend.towards.dot(sample.place) * sample.bend.curvature, 0);
    });
    EXPECT_TRUE(inflections_of(curve).empty());
}

/// Patches that meet at z = 0 and at z = +-20, where planes are tangent all around, and others.
TEST(CombCurves, RunAlongBordersAndWherePlanesTouchOnce) {
    for (const double turned : {0.0, 0.6}) {
        const SurfaceModel model = test::torus_model(60, 20, turned);
        const auto middle = sections(model, "z=0");
        ASSERT_EQ(middle.size(), 2u) << turned;
        for (const CombCurve& curve : middle)
            expect_circle(curve, curve.length > 2 * pi * 60 ? 80 : 40, 0);
        for (const double z : {20.0, -20.0}) {
            const auto touching = sections(model, z > 0 ? "z=20" : "z=-20");
            ASSERT_EQ(touching.size(), 1u) << turned << ' ' << z;
            expect_circle(touching[0], 60, z);
            EXPECT_TRUE(touching[0].pieces[0].touching);
            EXPECT_EQ(touching[0].pieces.size(), 4u);
        }
    }
}

/// Two faces trimmed at x = 50, which is no border of their patches.
TEST(CombCurves, RunAlongTrimsOnce) {
    test::ModelBuilder builder;
    for (const double begin : {0.1, 0.5}) {
        builder.patch(
            2, 1, {{0, 0, 0}, {0, 100, 0}, {50, 0, 20}, {50, 100, 20}, {100, 0, 0}, {100, 100, 0}});
        builder.polygon({{begin, 0.2}, {begin + 0.4, 0.2}, {begin + 0.4, 0.9}, {begin, 0.9}});
    }
    const auto curves = sections(builder.build(), "x=50");
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_NEAR(curves[0].length, 70, 1e-5);
    EXPECT_LE(curves[0].pieces[0].samples.size(), 5u);
}

TEST(CombCurves, TellOfPlanesWithoutCurves) {
    using Kind = SectionRemark::Kind;
    const auto remarks = [](const SurfaceModel& model, const char* plane) {
        CombOptions options;
        options.planes = {section_plane(plane)};
        const FoundCombs found = comb_curves(model, options);
        EXPECT_TRUE(found.curves.empty()) << plane;
        EXPECT_EQ(found.remarks.size(), 1u) << plane;
        return found.remarks.empty() ? SectionRemark{} : found.remarks[0];
    };
    const SurfaceModel ball =
        test::sphere_model(test::stretched(Vec3(80), {1, 2, 3}, Vec3(10, 0, 0)));
    const SectionRemark missed = remarks(ball, "x=500");
    EXPECT_EQ(missed.kind, Kind::missed);
    const SectionRemark touched = remarks(ball, "x=90");
    EXPECT_EQ(touched.kind, Kind::touches);
    EXPECT_LT((touched.place - Vec3(90, 0, 0)).length(), 0.2);
    test::ModelBuilder builder;
    builder.plane({0, 0, 7}, {100, 0, 0}, {0, 100, 0});
    EXPECT_EQ(remarks(builder.build(), "z=7").kind, Kind::within);
}

/// Planes that touch along a curve that no parameter follows.
TEST(CombCurves, FollowWherePlanesTouchAslant) {
    // z = (x - y)^2 / 100 over 100 x 100, which touches z = 0 along its diagonal.
    test::ModelBuilder builder;
    std::vector<Vec3> points;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double xx = i == 2 ? 100 : 0, yy = j == 2 ? 100 : 0, xy = 100.0 * i * j / 4;
            points.emplace_back(50 * i, 50 * j, xx + yy - 2 * xy);
        }
    builder.patch(2, 2, points);
    const auto curves = sections(builder.build(), "z=0");
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_NEAR(curves[0].length, 100 * std::sqrt(2.0), 1e-6);
    for_each_sample(curves[0],
                    [&](const CombSample& s) { EXPECT_NEAR(s.bend.curvature, 0, 1e-12); });
}

/// z = ((x - a)^2 + (y - b)^2 - r^2)^2 / 1e5 over 100 x 100 in one patch, which touches z = 0 along
/// a circle.
SurfaceModel ring_valley(double a, double b, double r) {
    using Row = std::array<double, 5>;
    const auto row = [](const Row& by_power) { return test::bernstein<5>(by_power, 0, 100); };
    const auto powers = [&](double c) {
        return std::array<Row, 3>{row({1}), row({c * c, -2 * c, 1}),
                                  row({c * c * c * c, -4 * c * c * c, 6 * c * c, -4 * c, 1})};
    };
    const auto x = powers(a), y = powers(b);
    const Row along = row({0, 1});
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < 5; ++i)
        for (std::size_t j = 0; j < 5; ++j) {
            const double quartic = x[2][i] + 2 * x[1][i] * y[1][j] + y[2][j];
            const double z = quartic - 2 * r * r * (x[1][i] + y[1][j]) + r * r * r * r;
            points.emplace_back(along[i], along[j], z / 1e5);
        }
    test::ModelBuilder builder;
    builder.patch(4, 4, points);
    return builder.build();
}

/// The derivative by either parameter has zeros that cross the circle where it runs along that.
TEST(CombCurves, FollowWherePlanesTouchRoundAboutInsideAPatch) {
    struct Circle {
        double a, b, r;
    };
    for (const Circle& c : {Circle{50, 50, 30}, {47.3, 52.1, 33.7}, {60, 45, 20}, {50, 50, 49}}) {
        SCOPED_TRACE(c.r);
        const auto curves = sections(ring_valley(c.a, c.b, c.r), "z=0");
        ASSERT_EQ(curves.size(), 1u);
        EXPECT_TRUE(curves[0].closed);
        EXPECT_NEAR(curves[0].length, 2 * pi * c.r, 1e-3 * c.r);
        double side = 0;
        for_each_sample(curves[0], [&](const CombSample& s) {
            EXPECT_NEAR(std::hypot(s.place.x - c.a, s.place.y - c.b), c.r, 1e-3);
            EXPECT_NEAR(std::abs(s.bend.curvature) * c.r, 1, 1e-3);
            if (side == 0) side = s.bend.curvature;
            EXPECT_GT(side * s.bend.curvature, 0);
        });
    }
}

} // namespace
} // namespace keiko
