#include "keiko/light/sky/sky_scattering.h"

#include "keiko/light/sky/sky_irradiance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi;

/// Exponential integral of order n: of exp(-x / u) u^(n - 2) over u from 0 to 1.
double exponential_integral(int n, double x) {
    double order = -std::expint(-x);
    for (int k = 1; k < n; ++k) order = (std::exp(-x) - x * order) / k;
    return order;
}

Medium fog(double per_metre) {
    Medium medium;
    medium.extinction = Rgb(per_metre);
    medium.albedo = Rgb(0.7);
    return medium;
}

/// Fog of 1/m up to a height of 500 mm, and clear air above.
Medium ground_fog() {
    Medium medium = fog(1);
    medium.density = LayeredDensity{{500, {}}, Rgb(0)};
    return medium;
}

double scattered(const Medium& medium, const Segment& ray, const SkyLight& sky) {
    return scattered_light(AttenuatedRay(medium, ray), sky, 1e-8).g;
}

/// A sky over ground as bright is the same for every phase function: what the ray loses comes back,
/// dimmed by a kilometre.
TEST(SkyScattering, FogIsAsBrightAsAnEvenSurround) {
    SkyLight sky{SkyModel::uniform, Rgb(50)};
    sky.ground = Rgb(50);
    const Segment ray{{100, 200, 300}, {4100, -2800, 1300}};
    const double length = (ray.b - ray.a).length() / 1000;
    for (const PhaseFunction& phase :
         {PhaseFunction(HazePhase{}), PhaseFunction(HazePhase{50}),
          PhaseFunction(HenyeyGreenstein{0.8}), PhaseFunction(HenyeyGreenstein{-0.5})}) {
        Medium medium = fog(1e-3);
        medium.phase = phase;
        const double closed = 50 * 0.7 * -std::expm1(-1e-3 * length) * std::exp(-1.0);
        EXPECT_NEAR(scattered(medium, ray, sky), closed, 1e-3 * closed);
    }
}

/// Level rays at a depth below the top of a layer, under skies that are linear in the height.
TEST(SkyScattering, LayerOfFogMeetsTheExponentialIntegrals) {
    const SkyLight even{SkyModel::uniform, Rgb(10)}, overcast{SkyModel::overcast, Rgb(10)};
    for (const double depth : {0.05, 0.2, 0.45}) { // m, and the optical depth
        const double z = 500 - 1000 * depth;
        const Segment ray{{0, 0, z}, {1500, 800, z}};
        const double lost = -std::expm1(-(ray.b - ray.a).length() / 1000);
        const double e2 = exponential_integral(2, depth), e3 = exponential_integral(3, depth);
        const double of_even = 0.7 * lost * 10 / 2 * e2;
        const double of_overcast = 0.7 * lost * 10 / 2 * (e2 / 3 + e3 * 2 / 3);
        EXPECT_NEAR(scattered(ground_fog(), ray, even), of_even, 1e-3 * of_even) << depth;
        EXPECT_NEAR(scattered(ground_fog(), ray, overcast), of_overcast, 1e-3 * of_overcast);
    }
}

/// A forward lobe above and below the horizon, summed up over uniform cells of the sphere.
TEST(SkyScattering, ForwardLobeMeetsBruteForce) {
    SkyLight sky{SkyModel::clear, Rgb(10)};
    sky.sun = Vec3(0.5, -0.3, 0.6).normalized(), sky.ground = Rgb(3);
    const SkyDistribution shares(sky);
    Medium medium = fog(1e-3);
    medium.phase = HenyeyGreenstein{0.6};
    for (const Vec3& end : {Vec3(3000, 0, 2000), Vec3(-3000, 1000, -900)}) {
        constexpr int bands = 600, sectors = 600;
        double sum = 0;
        for (int i = 0; i < bands; ++i)
            for (int k = 0; k < sectors; ++k) {
                const double sine = 2 * (i + 0.5) / bands - 1, cosine = std::sqrt(1 - sine * sine);
                const double azimuth = 2 * pi * (k + 0.5) / sectors;
                const Vec3 way(cosine * std::cos(azimuth), cosine * std::sin(azimuth), sine);
                sum += (sine > 0 ? 10 * shares(way) : 3) *
                       phase(medium.phase, way.dot(end.normalized()));
            }
        const double length = end.length() / 1000;
        const double brute =
            sum * 4 * pi / bands / sectors * 0.7 * -std::expm1(-1e-3 * length) * std::exp(-1.0);
        EXPECT_NEAR(scattered(medium, {Vec3(0), end}, sky), brute, 1e-3 * brute);
    }
}

} // namespace
} // namespace keiko
