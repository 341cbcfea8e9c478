#include "keiko/inspect/inspection.h"
#include "keiko/io/load_model.h"
#include "keiko/io/preset_file.h"

#include "tests/support/model_builder.h"
#include "tests/support/paths.h"
#include "tests/unit/inspect/bernstein.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr std::size_t order = 9; ///< of every polynomial: degree 8
using Polynomial = std::array<double, order>;

/// A function of one coordinate by polynomials between knots, each about the middle of its piece.
struct Profile {
    std::vector<double> knots; ///< mm
    std::vector<Polynomial> pieces;

    /// Bernstein coefficients of all pieces in a row, shared where they meet.
    std::vector<double> coefficients() const {
        std::vector<double> row;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const double extent = knots[i + 1] - knots[i];
            const Polynomial b = test::bernstein<order>(pieces[i], -extent / 2, extent);
            if (!row.empty()) row.pop_back();
            row.insert(row.end(), b.begin(), b.end());
        }
        return row;
    }
    std::vector<double> knot_vector() const {
        std::vector<double> all(1, knots.front());
        for (const double knot : knots) all.insert(all.end(), order - 1, knot);
        all.push_back(knots.back());
        return all;
    }
};

constexpr double half = 150; ///< mm: each sheet runs from -half to half either way

/// a + b x + c x^2 / 2 about the middle of each piece between the knots.
Profile parabola(const std::vector<double>& knots, double bend) {
    Profile p{knots, {}};
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const double m = (knots[i] + knots[i + 1]) / 2;
        p.pieces.push_back({bend * m * m / 2, bend * m, bend / 2});
    }
    return p;
}

/// A face z = base_x(x) + base_y(y) + depth f(x) g(y); all by the knots of f and g.
SurfaceModel sheet(const Profile& f, const Profile& g, double depth, double bend_x, double bend_y) {
    const auto of = [](const Profile& p) { return p.coefficients(); };
    const auto x = of(parabola(f.knots, bend_x)), y = of(parabola(g.knots, bend_y));
    const auto fx = of(f), gy = of(g);
    const auto ramp = [](const Profile& p) {
        Profile line{p.knots, {}};
        for (std::size_t i = 0; i < p.pieces.size(); ++i)
            line.pieces.push_back({(p.knots[i] + p.knots[i + 1]) / 2, 1});
        return line.coefficients();
    };
    const auto along_x = ramp(f), along_y = ramp(g);
    NurbsSurface surface{order - 1, order - 1, f.knot_vector(), g.knot_vector(), {}};
    for (std::size_t i = 0; i < fx.size(); ++i)
        for (std::size_t j = 0; j < gy.size(); ++j)
            surface.points.emplace_back(along_x[i], along_y[j], x[i] + y[j] + depth * fx[i] * gy[j],
                                        1);
    test::ModelBuilder builder;
    builder.nurbs(surface);
    return builder.build();
}

/// 1 at `centre`, 0 from `radius` on: (1 - r^2)^4, which bends without a break.
Profile bump(double centre, double radius) {
    const double q = 1 / (radius * radius);
    const Polynomial nothing{};
    return {{-half, centre - radius, centre + radius, half},
            {nothing, {1, 0, -4 * q, 0, 6 * q * q, 0, -4 * q * q * q, 0, q * q * q * q}, nothing}};
}

/// Between 1 and -1 with the period `length`: Euler's spline of degree 4.
Profile wave(double length) {
    const double extent = length / 2;
    Profile p{{-half}, {}};
    double sign = 1;
    for (double at = -half; at < half - extent / 2; at += extent, sign = -sign) {
        p.knots.push_back(at + extent);
        const double q = sign / (extent * extent); // 1 - 24/5 t^2 + 16/5 t^4, t = x / extent
        p.pieces.push_back({sign, 0, -4.8 * q, 0, 3.2 * q / (extent * extent)});
    }
    return p;
}

Profile everywhere() {
    return {{-half, half}, {{1}}};
}

/// The checks of dents and waves; mm.
std::vector<Check> checks_of_flaws(const SurfaceModel& model, double depth, double window = 100) {
    CriteriaPreset preset;
    preset.surface.waviness = WavinessLimit{depth, window};
    const Inspection found = inspect(model, preset);
    std::vector<Check> checks;
    std::copy_if(found.checks.begin(), found.checks.end(), std::back_inserter(checks),
                 [](const Check& c) { return c.quantity == "dent" || c.quantity == "waviness"; });
    return checks;
}

constexpr double limit = 0.01;
/// Bends of the sheets, 1/mm along x and y: convex, saddle, flat.
constexpr std::array<std::array<double, 2>, 3> bends{{{-1e-3, -2e-4}, {5e-4, -1e-3}, {0, 0}}};

/// Every dent and bump over the limit is found, none under it, where it is and as deep as it is.
TEST(PlantedFlaws, DentsAreFoundWhereTheyAreAndAsDeepAsTheyAre) {
    for (const auto& [bend_x, bend_y] : bends)
        for (const double radius : {10.0, 25.0})
            for (const double depth : {0.001, 0.0098, 0.0102, 0.1, 1.0})
                for (const double side : {-1.0, 1.0}) {
                    SCOPED_TRACE(testing::Message()
                                 << bend_x << ' ' << radius << ' ' << side * depth);
                    const SurfaceModel model =
                        sheet(bump(21, radius), bump(-33, radius), side * depth, bend_x, bend_y);
                    const std::vector<Check> checks = checks_of_flaws(model, limit);
                    ASSERT_EQ(checks.size(), 1u);
                    const Check& check = checks[0];
                    EXPECT_EQ(check.is_finding(), depth > limit) << check.message;
                    if (depth < limit / 2) continue;
                    EXPECT_EQ(check.code, "KEIKO-DENT");
                    EXPECT_NEAR(check.worst.value, depth, 0.01 * depth);
                    EXPECT_EQ(check.worst.verdict, depth > limit ? Verdict::fail : Verdict::pass);
                    EXPECT_NEAR(check.worst.place.x, 21, 0.5);
                    EXPECT_NEAR(check.worst.place.y, -33, 0.5);
                    EXPECT_TRUE(check.message.starts_with(side < 0 ? "the dent" : "the bump"));
                }
}

TEST(PlantedFlaws, WavesAreFoundAndAsDeepAsTheyAre) {
    for (const auto& [bend_x, bend_y] : bends)
        for (const double length : {20.0, 37.5, 50.0})
            for (const double depth : {0.001, 0.0098, 0.0102, 0.1, 0.5}) {
                SCOPED_TRACE(testing::Message() << bend_x << ' ' << length << ' ' << depth);
                const SurfaceModel model = sheet(wave(length), everywhere(), depth, bend_x, bend_y);
                const std::vector<Check> checks = checks_of_flaws(model, limit);
                ASSERT_EQ(checks.size(), 1u);
                const Check& check = checks[0];
                EXPECT_EQ(check.is_finding(), depth > limit) << check.message;
                if (depth < limit / 2) continue;
                EXPECT_EQ(check.code, "G-SU-WV");
                EXPECT_NEAR(check.worst.value, depth, 0.01 * depth);
                const double crest = std::abs(std::remainder(check.worst.place.x, length / 2));
                EXPECT_NEAR(crest, length / 4, 0.5); // crests lie in the middles of the pieces
            }
}

TEST(PlantedFlaws, NothingIsFoundOnTheCleanTwin) {
    for (const auto& [bend_x, bend_y] : bends)
        for (const double least : {1e-5, limit}) {
            const std::vector<Check> checks =
                checks_of_flaws(sheet(bump(21, 25), bump(-33, 25), 0, bend_x, bend_y), least);
            ASSERT_EQ(checks.size(), 1u);
            EXPECT_EQ(checks[0].code, "G-SU-WV");
            EXPECT_EQ(checks[0].worst.value, 0);
            EXPECT_EQ(checks[0].worst.verdict, Verdict::pass);
        }
}

TEST(PlantedFlaws, TwoDentsFarApartAreTwoFindings) {
    Profile two = bump(-80, 20);
    two.knots = {-half, -100, -60, 60, 100, half};
    const Polynomial dent = two.pieces[1], nothing{};
    two.pieces = {nothing, dent, nothing, dent, nothing};
    const std::vector<Check> checks =
        checks_of_flaws(sheet(two, bump(0, 20), -0.05, -1e-3, 0), limit);
    ASSERT_EQ(checks.size(), 2u);
    for (const Check& check : checks) EXPECT_NEAR(check.worst.value, 0.05, 5e-4);
    EXPECT_NEAR(checks[0].worst.place.x + checks[1].worst.place.x, 0, 0.5);
}

TEST(PlantedFlaws, TheDentOfTheFixtureIsMeasured) {
    const SurfaceModel model = load_model(test::repository("surfaces/dent.step"));
    const std::vector<Check> checks = checks_of_flaws(model, limit, 200); // 120 mm wide
    ASSERT_EQ(checks.size(), 1u);
    EXPECT_EQ(checks[0].worst.verdict, Verdict::fail);
    EXPECT_NEAR(checks[0].worst.value, 0.1, 1e-3);
    EXPECT_NEAR(checks[0].worst.place.x, 40, 0.5);
    EXPECT_NEAR(checks[0].worst.place.y, -20, 0.5);
}

/// A window that is no wider than the dent cannot tell it from form.
TEST(PlantedFlaws, AreUndecidedWhereTheWindowIsTooNarrow) {
    const SurfaceModel model = load_model(test::repository("surfaces/dent.step"));
    const std::vector<Check> checks = checks_of_flaws(model, limit, 100);
    ASSERT_EQ(checks.size(), 1u);
    EXPECT_EQ(checks[0].worst.verdict, Verdict::undecided);
    EXPECT_GE(checks[0].worst.value + 2 * checks[0].worst.bound, 0.1);
}

/// The bodies of the repository in which nobody planted anything.
TEST(PlantedFlaws, PresetPassesCleanFixtures) {
    const SurfaceLimits& limits = preset_by_name("class-a-waviness").surface;
    ASSERT_TRUE(limits.waviness.has_value());
    for (const char* clean : {"hood.step", "pole.step", "rational-sphere.step", "seam-g2-only.step",
                              "concept-car.step"})
        for (const MeasuredFace& face :
             measure_faces(load_model(test::repository(std::string("surfaces/") + clean)), limits))
            EXPECT_EQ(face.verdict, Verdict::pass) << clean << ", " << face.name;
    const std::vector<MeasuredFace> dented =
        measure_faces(load_model(test::repository("surfaces/dent.step")), limits);
    EXPECT_NE(dented.at(0).verdict, Verdict::pass);
}

/// Its own width from the border a dent still has form all around it.
TEST(PlantedFlaws, DentsBesideBordersAreMeasuredWhereFormIsAround) {
    for (const double radius : {10.0, 15.0})
        for (const double margin : {2.0, 8.0}) {
            SCOPED_TRACE(testing::Message() << radius << ' ' << margin);
            const double centre = half - radius - margin;
            const std::vector<Check> checks = checks_of_flaws(
                sheet(bump(centre, radius), bump(7, radius), -0.05, -1e-3, -2e-4), limit);
            ASSERT_EQ(checks.size(), 1u);
            EXPECT_EQ(checks[0].code, "KEIKO-DENT");
            EXPECT_EQ(checks[0].worst.verdict, Verdict::fail);
            EXPECT_NEAR(checks[0].worst.value, 0.05, 0.01 * 0.05);
            EXPECT_NEAR(checks[0].worst.place.x, centre, 0.5);
        }
}

/// A bend of the form, 20 mm in radius between two planes, and one that changes its sense.
TEST(PlantedFlaws, BendsOfTheFormAreNone) {
    const double reach = 15, bend = 1.0 / 20; // z'' rises and falls again
    const double rise = bend * reach / 2;     // z' after each half
    Profile fold{{-half, -reach, 0, reach, half}, {}};
    const auto cubic = [&](double side) { // about the middle, at -+ reach / 2
        const double m = reach / 2, z2 = bend / 2, z3 = side * bend / reach;
        const double slope = side > 0 ? m * bend / 4 : rise + bend * m * 3 / 4;
        const double start = side > 0 ? bend * m * m * m / (6 * reach)
                                      : bend * reach * reach / 6 + rise * m + bend * m * m / 2 -
                                            bend * m * m * m / (6 * reach);
        return Polynomial{start, slope, z2 / 2, z3 / 6};
    };
    const double end = bend * reach * reach / 6 + rise * reach + bend * reach * reach / 3;
    fold.pieces = {{}, cubic(1), cubic(-1), {end + 2 * rise * (half - reach) / 2, 2 * rise}};
    const std::vector<Check> checks =
        checks_of_flaws(sheet(fold, everywhere(), 1, 0, -5e-4), limit);
    ASSERT_EQ(checks.size(), 1u);
    EXPECT_EQ(checks[0].worst.verdict, Verdict::pass) << checks[0].message;
    EXPECT_EQ(checks[0].worst.value, 0);
}

} // namespace
} // namespace keiko
