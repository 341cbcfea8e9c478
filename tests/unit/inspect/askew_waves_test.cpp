#include "keiko/files/scene/preset_file.h"
#include "keiko/inspect/flaws/face_ripples.h"
#include "keiko/inspect/inspection.h"

#include "tests/unit/inspect/flawed_sheets.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using test::Profile;

constexpr double degree_angle = std::numbers::pi / 180;

/// cos(k x + phase) between -half and half, by its Taylor polynomials over an eighth of a wave to
/// either side, which are exact to 3e-7.
Profile cosine(double k, double phase, double half) {
    const auto count = static_cast<std::size_t>(std::ceil(8 * half * k / (2 * std::numbers::pi)));
    const double extent = 2 * half / static_cast<double>(count);
    Profile p{{-half}, {}};
    for (std::size_t i = 0; i < count; ++i) {
        const double middle = p.knots.back() + extent / 2;
        test::Polynomial taylor{};
        double factor = 1; // k^n / n!
        for (std::size_t n = 0; n < taylor.size(); ++n) {
            const double turn = static_cast<double>(n) * std::numbers::pi / 2;
            taylor[n] = factor * std::cos(k * middle + phase + turn);
            factor *= k / static_cast<double>(n + 1);
        }
        p.pieces.push_back(taylor);
        p.knots.push_back(p.knots.back() + extent);
    }
    return p;
}

/// Waves on a flat sheet that run at an angle to its isolines.
struct AskewWaves {
    double length = 40; ///< mm, square to the crests
    double angle = 45;  ///< degrees, from the lines of constant v to the way square to the crests
    double shear = 0;   ///< the lines of constant u lean by this many mm each
    double depth = 0.02;

    /// cos(a x + b y) = cos(a x) cos(b y) - sin(a x) sin(b y) is a sum of products. A shear keeps
    /// heights: with x' = x + shear y the wave is cos(a x' + (b - a shear) y).
    SurfaceModel model() const {
        const double k = 2 * std::numbers::pi / length, half = 120;
        const double a = k * std::cos(angle * degree_angle);
        const double b = k * std::sin(angle * degree_angle) + a * shear;
        const double quarter = -std::numbers::pi / 2;
        const Profile x = cosine(a, 0, half), y = cosine(std::abs(b), 0, half);
        const auto row = [](const Profile& p) { return p.coefficients(); };
        const auto cx = row(x), sx = row(cosine(a, quarter, half)), cy = row(y);
        auto sy = row(cosine(std::abs(b), quarter, half));
        for (double& s : sy) s = std::copysign(s, s * b);
        const auto along_x = ramp(x), along_y = ramp(y);
        const int degree = test::profile_order - 1;
        NurbsSurface surface{degree, degree, x.knot_vector(), y.knot_vector(), {}};
        for (std::size_t i = 0; i < cx.size(); ++i)
            for (std::size_t j = 0; j < cy.size(); ++j)
                surface.points.emplace_back(along_x[i] + shear * along_y[j], along_y[j],
                                            depth * (cx[i] * cy[j] - sx[i] * sy[j]), 1);
        test::ModelBuilder builder;
        builder.nurbs(surface);
        return builder.build();
    }

private:
    static std::vector<double> ramp(const Profile& p) {
        Profile line{p.knots, {}};
        for (std::size_t i = 0; i < p.pieces.size(); ++i)
            line.pieces.push_back({(p.knots[i] + p.knots[i + 1]) / 2, 1});
        return line.coefficients();
    }
};

std::vector<Flaw> flaws_of(const AskewWaves& waves) {
    CriteriaPreset preset;
    preset.surface = preset_by_name("class-a-waviness").surface;
    return inspect(waves.model(), preset).faces.at(0).flaws;
}

/// A wave is as wide as it is square to its crests, and its limit is that of such a width. Along
/// the isolines it may be wider than its window.
TEST(AskewWaves, AreMeasuredSquareToTheirCrests) {
    const double rhombus = 1 / std::tan(74 * degree_angle);
    for (const AskewWaves& waves :
         {AskewWaves{40, 45}, AskewWaves{48, 45}, AskewWaves{30, 35}, AskewWaves{48, 60},
          AskewWaves{24, 10}, AskewWaves{40, -53, rhombus}, AskewWaves{48, 37, rhombus}}) {
        SCOPED_TRACE(testing::Message() << waves.length << ' ' << waves.angle);
        const std::vector<Flaw> flaws = flaws_of(waves);
        ASSERT_EQ(flaws.size(), 1u);
        EXPECT_EQ(flaws[0].kind, Flaw::Kind::waves);
        EXPECT_EQ(flaws[0].window, 100);
        EXPECT_EQ(flaws[0].depth.verdict, Verdict::fail);
        EXPECT_NEAR(flaws[0].depth.value, waves.depth, 0.01 * waves.depth);
        EXPECT_NEAR(flaws[0].width, waves.length, 0.03 * waves.length);
    }
}

/// Over a window's width waves have the limit of the next window, however they run.
TEST(AskewWaves, AreHeldAgainstTheLimitOfTheirWidth) {
    for (const double angle : {0.5, 30.0, 45.0, 60.0}) {
        const std::vector<Flaw> flaws = flaws_of({70, angle});
        ASSERT_EQ(flaws.size(), 1u) << angle;
        EXPECT_EQ(flaws[0].window, 250) << angle;
        EXPECT_EQ(flaws[0].depth.verdict, Verdict::pass) << angle;
    }
}

/// The curvature of a line, mm, across waves of the length at an angle to it, on a cylinder.
std::vector<BendPoint> across(double length, double angle, const SecondForm& form) {
    const double k = 2 * std::numbers::pi / length, c = std::cos(angle), s = std::sin(angle);
    std::vector<BendPoint> line;
    for (double at = 0; at <= 300; at += 1) {
        const double bend = -0.05 * k * k * std::sin(k * c * at);
        line.push_back(
            {at, {form.xx + bend * c * c, form.xy + bend * c * s, form.yy + bend * s * s}});
    }
    return line;
}

TEST(AskewWaves, SlantIsThatOfTheWaveNotOfTheForm) {
    for (const double angle : {-50.0, -20.0, 0.0, 20.0, 50.0})
        for (const SecondForm& form : {SecondForm{}, SecondForm{2e-3, 1e-3, -5e-4}}) {
            const double slant = angle * degree_angle;
            const std::vector<Ripple> found = find_ripples(across(40, slant, form), 0.01, 150);
            ASSERT_GE(found.size(), 7u) << angle;
            for (const Ripple& r : found) {
                EXPECT_NEAR(r.slant, slant, 1e-6);
                EXPECT_NEAR(r.square_width(), 40, 2.1);
                EXPECT_NEAR(std::abs(r.depth), 0.05, 0.005);
            }
        }
}

/// A round dent bends along all ways: it has no crest, and no slant.
TEST(AskewWaves, AreNotSeenInWhatBendsAlongAllWays) {
    std::vector<BendPoint> line;
    for (double s = 0; s <= 200; s += 2) {
        const double bend = 1e-3 * std::cos(2 * std::numbers::pi * s / 50);
        line.push_back({s, {bend, 0.2 * bend, 0.8 * bend}});
    }
    const std::vector<Ripple> found = find_ripples(line, 0.01, 100);
    ASSERT_FALSE(found.empty());
    for (const Ripple& r : found) EXPECT_EQ(r.slant, 0);
}

} // namespace
} // namespace keiko
