#include "keiko/files/scene/preset_file.h"
#include "keiko/inspect/inspection.h"

#include "tests/unit/inspect/dented_panel.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using test::ModelBuilder, test::PanelHeight, test::RoundDent;

/// How a round face is parametrized and placed.
struct PolarChart {
    double radius = 120; ///< mm
    int faces = 1;       ///< sectors
    bool pole_at_end = false, angle_along_v = false, reversed = false;
};

constexpr int sectors = 48; // spans around
constexpr double polar_step = 4;

/// A round panel of uniform bicubic splines about its pole, where `height` must be of revolution.
SurfaceModel polar_panel(const PanelHeight& height, const PolarChart& chart) {
    const int rings = static_cast<int>(chart.radius / polar_step);
    const auto knots = [](int begin, int end) {
        std::vector<double> all;
        for (int k = begin - 3; k <= end + 3; ++k) all.push_back(k);
        return all;
    };
    const auto point = [&](int angle, int ring) {
        const double a = (angle - 1) * 2 * std::numbers::pi / sectors;
        const double r = (chart.pole_at_end ? rings - (ring - 1) : ring - 1) * polar_step;
        const double x = r * std::cos(a), y = r * std::sin(a);
        return Vec4(x, y, height(x, y), 1);
    };
    ModelBuilder builder;
    const int per_face = sectors / chart.faces;
    for (int begin = 0; begin < sectors; begin += per_face) {
        const auto around = knots(begin, begin + per_face), out = knots(0, rings);
        NurbsSurface surface{3, 3, around, out, {}};
        if (chart.angle_along_v) std::swap(surface.knots_u, surface.knots_v);
        const int count_a = per_face + 3, count_r = rings + 3;
        for (int i = 0; i < (chart.angle_along_v ? count_r : count_a); ++i)
            for (int j = 0; j < (chart.angle_along_v ? count_a : count_r); ++j)
                surface.points.push_back(chart.angle_along_v ? point(begin + j, i)
                                                             : point(begin + i, j));
        builder.nurbs(surface);
    }
    SurfaceModel model = builder.build();
    for (Face& face : model.faces) face.reversed = chart.reversed;
    return model;
}

std::vector<Flaw> flaws_of(const SurfaceModel& model) {
    CriteriaPreset preset;
    preset.surface = preset_by_name("class-a-waviness").surface;
    std::vector<Flaw> flaws;
    for (const MeasuredFace& face : inspect(model, preset).faces)
        flaws.insert(flaws.end(), face.flaws.begin(), face.flaws.end());
    return flaws;
}

PanelHeight dented(const PanelHeight& form, const RoundDent& dent) {
    return [=](double x, double y) {
        return form(x, y) - dent.depth * dent.at((Vec2(x, y) - dent.centre).length());
    };
}

PanelHeight paraboloid(double bend) {
    return [=](double x, double y) { return bend * (x * x + y * y) / 2; };
}

std::vector<PolarChart> charts() {
    return {{},
            {120, 1, true, false, false},
            {120, 1, false, true, true},
            {120, 4, true, true, false},
            {100, 3, false, false, true}};
}

/// Depth of the spline at its pole below its twin without the dent.
double depth_at_pole(double depth, const RoundDent& dent) {
    return depth * (4 + 2 * dent.at(polar_step)) / 6;
}

TEST(FlawsAtPoles, DentsAtThePoleAreMeasuredAcrossIt) {
    for (const PolarChart& chart : charts())
        for (const double bend : {0.0, -1.0 / 800})
            for (const double diameter : {30.0, 50.0})
                for (const double depth : {0.3, -0.02}) {
                    SCOPED_TRACE(testing::Message()
                                 << chart.faces << chart.pole_at_end << chart.angle_along_v << ' '
                                 << bend << ' ' << diameter << ' ' << depth);
                    const RoundDent dent{{0, 0}, diameter, depth, RoundDent::Profile::fourth};
                    SurfaceModel model = polar_panel(dented(paraboloid(bend), dent), chart);
                    model.instances[0].transform = Affine::translate({700, -300, 50});
                    const std::vector<Flaw> flaws = flaws_of(model);
                    ASSERT_EQ(flaws.size(), 1u);
                    const double truth = depth_at_pole(std::abs(depth), dent);
                    EXPECT_NEAR(flaws[0].depth.value, truth, 0.01 * truth);
                    EXPECT_LT(flaws[0].depth.bound, 0.1 * truth);
                    EXPECT_EQ(flaws[0].depth.verdict, Verdict::fail);
                    EXPECT_NEAR(flaws[0].depth.place.x, 700, 0.5);
                    EXPECT_NEAR(flaws[0].depth.place.y, -300, 0.5);
                    // Outwards is up where du x dv is.
                    const bool down = chart.pole_at_end ^ chart.angle_along_v ^ chart.reversed;
                    EXPECT_EQ(flaws[0].kind,
                              (depth > 0) != down ? Flaw::Kind::bump : Flaw::Kind::dent);
                }
}

/// A ball, a paraboloid whose curvature peaks at the pole, and the tip of a cone.
TEST(FlawsAtPoles, NothingIsFoundOnTheCleanTwins) {
    const auto ball = [](double x, double y) { return std::sqrt(4e4 - x * x - y * y); };
    const auto cone = [](double x, double y) { return -0.2 * std::hypot(x, y); };
    for (const PolarChart& chart : charts())
        for (const PanelHeight& height :
             {PanelHeight(ball), paraboloid(-1.0 / 100), PanelHeight(cone)})
            for (const Flaw& flaw : flaws_of(polar_panel(height, chart)))
                ADD_FAILURE() << chart.faces << chart.pole_at_end << ' ' << flaw.depth.value;
}

} // namespace
} // namespace keiko
