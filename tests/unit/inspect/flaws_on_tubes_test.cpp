#include "keiko/files/scene/preset_file.h"
#include "keiko/inspect/inspection.h"

#include "tests/unit/inspect/dented_panel.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using test::ModelBuilder, test::RoundDent;

/// A tube about the x axis or, with an axis bent by `bend`, about a circle.
struct Tube {
    double radius = 15, length = 300; ///< mm
    double bend = 0;                  ///< 1/mm
    double turn = 0;                  ///< radians: of the dent around the tube
};

constexpr double tube_step = 4, around_step = 2; ///< mm, from knot to knot
constexpr int degree = 3;

int sectors_of(const Tube& tube) {
    return static_cast<int>(2 * std::numbers::pi * tube.radius / around_step);
}

/// A closed tube of uniform bicubic splines with a dent in the middle of its length.
SurfaceModel dented_tube(const Tube& tube, const RoundDent& dent) {
    const int sectors = sectors_of(tube), rings = static_cast<int>(tube.length / tube_step);
    const auto knots = [](int end) {
        std::vector<double> all;
        for (int k = -degree; k <= end + degree; ++k) all.push_back(k);
        return all;
    };
    const auto point = [&](int i, int j) {
        const double angle =
            std::remainder((i % sectors) * 2 * std::numbers::pi / sectors, 2 * std::numbers::pi);
        const double s = (j - 1) * tube_step - tube.length / 2;
        const double depth = dent.depth * dent.at(std::hypot(s, angle * tube.radius));
        const double r = tube.radius - depth;
        const double y = r * std::sin(angle + tube.turn), z = r * std::cos(angle + tube.turn);
        if (tube.bend == 0) return Vec4(s, y, z, 1);
        const double out = 1 / tube.bend + z;
        return Vec4(out * std::sin(s * tube.bend), y, out * std::cos(s * tube.bend), 1);
    };
    NurbsSurface surface{degree, degree, knots(sectors), knots(rings), {}};
    for (int i = 0; i < sectors + degree; ++i)
        for (int j = 0; j < rings + degree; ++j) surface.points.push_back(point(i, j));
    ModelBuilder builder;
    builder.nurbs(surface);
    return builder.build();
}

double planted(const Tube& tube, const RoundDent& dent) {
    RoundDent none = dent;
    none.depth = 0;
    const SurfaceModel with = dented_tube(tube, dent), without = dented_tube(tube, none);
    const FaceSurface a(with, 0, 0), b(without, 0, 0);
    const Vec2 place(sectors_of(tube) - 1.0, tube.length / tube_step / 2);
    return (a.evaluate_beyond(place, 0)->position() - b.evaluate_beyond(place, 0)->position())
        .length();
}

std::vector<Flaw> flaws_of(const SurfaceModel& model, std::size_t windows) {
    CriteriaPreset preset;
    preset.surface = preset_by_name("class-a-waviness").surface;
    preset.surface.waviness.resize(windows);
    std::vector<Flaw> flaws;
    for (const MeasuredFace& face : inspect(model, preset).faces)
        flaws.insert(flaws.end(), face.flaws.begin(), face.flaws.end());
    return flaws;
}

TEST(FlawsOnTubes, DentsAreMeasuredAlongTheRuling) {
    for (const double bend : {0.0, 1.0 / 500})
        for (const double radius : {20.0, 30.0})
            for (const double diameter : {20.0, 30.0})
                for (const double depth : {0.06, -0.3}) {
                    if (radius < 30 && (diameter < 30 || bend > 0)) continue;
                    SCOPED_TRACE(testing::Message()
                                 << bend << ' ' << radius << ' ' << diameter << ' ' << depth);
                    const Tube tube{radius, 300, bend, radius / 40};
                    const RoundDent dent{{0, 0}, diameter, depth, RoundDent::Profile::fourth};
                    const std::vector<Flaw> flaws = flaws_of(dented_tube(tube, dent), 1);
                    const double truth = planted(tube, dent);
                    ASSERT_FALSE(flaws.empty());
                    const MeasuredValue& found = flaws[0].depth;
                    EXPECT_LE(std::abs(found.value - truth), found.bound + 5e-3 * truth)
                        << found.value << ' ' << truth;
                    EXPECT_LT(found.bound, 0.05 * found.value) << found.value;
                    EXPECT_EQ(found.verdict, Verdict::fail);
                }
}

/// A line around a tube passes a dent again and again, and is no wave.
TEST(FlawsOnTubes, ADentIsNoWaveAroundTheTube) {
    for (const double radius : {12.0, 20.0}) {
        const RoundDent dent{{0, 0}, 30, 0.06, RoundDent::Profile::fourth};
        for (const Flaw& flaw : flaws_of(dented_tube({radius, 300, 0, 0.4}, dent), 3))
            EXPECT_LT(flaw.depth.value, 0.06) << radius << ' ' << flaw.width;
    }
}

TEST(FlawsOnTubes, NothingIsFoundOnTheCleanTwins) {
    for (const double bend : {0.0, 1.0 / 500})
        for (const double radius : {12.0, 30.0})
            for (const Flaw& flaw :
                 flaws_of(dented_tube({radius, 300, bend, 0.4}, {{0, 0}, 1, 0}), 3))
                ADD_FAILURE() << radius << ' ' << bend << ' ' << flaw.depth.value;
}

} // namespace
} // namespace keiko
