#include "keiko/light/fog/transmittance.h"
#include "keiko/light/luminance/clear_coat.h"
#include "keiko/light/luminance/gloss_kernel.h"
#include "keiko/light/rig/luminance_along.h"
#include "keiko/light/rig/surface_light.h"

#include "tests/support/shows_below.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

const Vec3 up(0, 0, 1), here(0);
const LineLight line{{-900, 500, 1200}, {800, 200, 1000}, Rgb(400, 200, 100)};

/// Sum of `of(place, intensity)` over short pieces of the line as point sources, which shine with
/// the cosine of the angle to the perpendicular.
template <class Of>
double sum_over_pieces_of(const LineLight& light, const Of& of) {
    constexpr int pieces = 20000;
    const Vec3 way = light.b - light.a;
    double sum = 0;
    for (int i = 0; i < pieces; ++i) {
        const Vec3 at = light.a + way * ((i + 0.5) / pieces);
        const double sine = way.cross(at - here).length() / (way.length() * (at - here).length());
        sum += of(at, light.intensity.g * sine * way.length() / 1000 / pieces);
    }
    return sum;
}

double lux_of_piece(const Vec3& at, double cd) {
    return cd * std::max(0.0, up.dot(at.normalized())) / (at.length2() * 1e-6);
}

TEST(LineRig, LightThroughFogAndACoatIsThatOfItsPieces) {
    const ClearCoat coat(Rgb(0.5), 1.5);
    const Medium fog{.extinction = Rgb(0.3, 0.6, 1.2)};
    const double clear = sum_over_pieces_of(line, lux_of_piece);
    EXPECT_NEAR(illuminance_from(line, {}, here, up, Unoccluded()).g, clear, 1e-7 * clear);
    const double through = sum_over_pieces_of(line, [&](const Vec3& at, double cd) {
        return lux_of_piece(at, cd) * transmittance(fog, {at, here}).g *
               coat.entering(up.dot(at.normalized()));
    });
    const Rgb lx = illuminance_from(line, fog, here, up, Unoccluded(), TubeModel::automatic, &coat);
    EXPECT_NEAR(lx.g, through, 1e-6 * through);
    EXPECT_LT(through, 0.6 * clear);
}

TEST(LineRig, LobesAreThoseOfItsPieces) {
    const Medium fog{.extinction = Rgb(0.8)};
    for (const double exponent : {3.0, 80.0, 4000.0}) {
        const Gloss gloss{.distribution = {DistributionKind::phong, exponent}};
        const GlossKernel kernel(gloss, up, Vec3(0.1, -0.37, 1.1).normalized());
        const double pieces = sum_over_pieces_of(line, [&](const Vec3& at, double cd) {
            return kernel(at.normalized()).g * cd / (at.length2() * 1e-6) *
                   transmittance(fog, {at, here}).g;
        });
        EXPECT_GT(pieces, 1);
        const auto sent = [&](GlossQuadrature quadrature) {
            return glossy_luminance_from(line, fog, here, kernel, Unoccluded(), quadrature).g;
        };
        EXPECT_NEAR(sent(GlossQuadrature::number), pieces, 1e-5 * pieces) << exponent;
        EXPECT_NEAR(sent(GlossQuadrature::picture), pieces, 2e-3 * pieces) << exponent;
    }
}

/// A wall hides what lies beyond x = 100 mm, for light and lobes.
TEST(LineRig, HiddenPartsSendNothing) {
    const test::ShowsBelow wall(100);
    LineLight left = line;
    left.b = line.a + (line.b - line.a) * (1000.0 / 1700);
    const double half = illuminance_from(left, {}, here, up, Unoccluded()).g;
    EXPECT_NEAR(illuminance_from(line, {}, here, up, wall).g, half, 1e-5 * half);
    const Gloss gloss{.distribution = {DistributionKind::phong, 20}};
    const GlossKernel kernel(gloss, up, Vec3(0.1, -0.37, 1.1).normalized());
    const double lobe = glossy_luminance_from(left, {}, here, kernel, Unoccluded()).g;
    EXPECT_NEAR(glossy_luminance_from(line, {}, here, kernel, wall).g, lobe, 1e-3 * lobe);
    EXPECT_EQ(illuminance_from(line, {}, here, up, test::ShowsBelow(-1000)).g, 0);
    EXPECT_EQ(illuminance_from(line, {}, here, -up, Unoccluded()).g, 0);
}

TEST(LineRig, PointsLieWithinAndLinesLightNoFog) {
    EXPECT_TRUE(within_lamp(line, (line.a + line.b) / 2));
    EXPECT_FALSE(within_lamp(line, here));
    const Segment ray{{-3000, 0, 800}, {3000, 0, 800}};
    EXPECT_TRUE(in_light(line, ray).empty());
    const PointSource bulb{.position = {0, 0, 1000}};
    EXPECT_TRUE(within_lamp(bulb, bulb.position));
    EXPECT_EQ(in_light(bulb, ray), IntervalSet::whole());
}

/// In uniform fog a uniform point has the closed form of a spotlight with a rim of 180 degrees.
TEST(LineRig, PointsLightFogAsSpotlightsDo) {
    LightRig points, spots;
    const PointSource bulb{.position = {200, 300, 1000}, .intensity = Rgb(700)};
    points.sources = {bulb};
    spots.sources = {Spotlight{.position = bulb.position,
                               .half_angle = 180,
                               .profile = EdgeProfile{BeamEdge::sharp},
                               .intensity = bulb.intensity}};
    points.medium = spots.medium = Medium{.extinction = Rgb(0.3)};
    const Segment ray{{-3000, 0, 800}, {3000, 0, 800}};
    const Rgb seen = luminance_along(points, ray, Rgb(0));
    EXPECT_GT(seen.g, 1);
    EXPECT_NEAR(seen.g, luminance_along(spots, ray, Rgb(0)).g, 1e-12 * seen.g);
    PointSource soft = bulb;
    soft.distribution = PointDistribution::cardioid;
    points.sources = {soft};
    spots.sources = {Spotlight{.position = bulb.position,
                               .aim = bulb.position + bulb.axis,
                               .half_angle = 180,
                               .profile = EdgeProfile{BeamEdge::soft},
                               .intensity = bulb.intensity}};
    const Rgb dimmer = luminance_along(points, ray, Rgb(0));
    EXPECT_NEAR(dimmer.g, luminance_along(spots, ray, Rgb(0)).g, 1e-7 * dimmer.g);
    EXPECT_LT(dimmer.g, seen.g);
}

} // namespace
} // namespace keiko
