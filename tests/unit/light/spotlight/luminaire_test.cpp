#include "keiko/light/spotlight/luminaire.h"

#include "keiko/light/spotlight/point_light.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

using namespace keiko;

namespace {

/// Brighter the larger V, and H, are.
std::shared_ptr<const PhotometricWeb> slanted(PhotometricType type) {
    const std::vector<double> values{0, 90, 40, 130};
    return std::make_shared<PhotometricWeb>(PhotometricWeb{
        .type = type, .candela = {{0, 90}, {0, 80}, values, PlaneSymmetry::limited}});
}

} // namespace

TEST(Luminaire, ByDefaultHangsAsItsFileHasIt) {
    for (const auto type : {PhotometricType::b, PhotometricType::c}) {
        const Luminaire lamp{.web = slanted(type)};
        EXPECT_NEAR(intensity_towards(lamp, web_direction(type, 35, 20) * 500).g, 45, 1e-9);
        EXPECT_NEAR(intensity_towards(lamp, web_direction(type, 35, 60) * 500).g, 65, 1e-9);
    }
}

TEST(Luminaire, TurnsWithItsAimAndReference) {
    // The axis along y, H = 0 along z: seen against the axis, planes turn from z towards -x.
    const Luminaire lamp{.web = slanted(PhotometricType::c),
                         .position = {10, 20, 30},
                         .aim = {10, 25, 30},
                         .reference = {0, 3, 2}};
    const double v = 0.5, h = 0.7;
    const Vec3 way(-std::sin(v) * std::sin(h), std::cos(v), std::sin(v) * std::cos(h));
    const double degree = 45 / std::atan(1);
    EXPECT_NEAR(intensity_towards(lamp, lamp.position + way * 700).r, v * degree + h * degree / 2,
                1e-9);
}

TEST(Luminaire, HeadLampsLookAlongTheirAim) {
    const Luminaire lamp{
        .web = slanted(PhotometricType::a), .aim = {-1, 0, 0}, .reference = {0, 0, 1}};
    const double v = 0.5, h = 0.7, degree = 45 / std::atan(1);
    // Looking along -x with z up, clockwise from above is towards y.
    const Vec3 way(-std::cos(v) * std::cos(h), std::cos(v) * std::sin(h), std::sin(v));
    EXPECT_NEAR(intensity_towards(lamp, way * 800).r, v * degree + h * degree / 2, 1e-9);
}

TEST(Luminaire, FlippedPlanesRunTheOtherWayRound) {
    for (const auto type : {PhotometricType::b, PhotometricType::c}) {
        Luminaire lamp{.web = slanted(type)};
        Vec3 way = web_direction(type, 30, 20);
        EXPECT_GT(intensity_towards(lamp, way).g, 0);
        lamp.flip_h = true;
        EXPECT_EQ(intensity_towards(lamp, way).g, 0);
        way.y = -way.y;
        EXPECT_NEAR(intensity_towards(lamp, way).g, 40, 1e-9);
    }
}

TEST(Luminaire, LightsASurfaceByInverseSquareAndCosine) {
    const Luminaire lamp{
        .web = slanted(PhotometricType::c), .position = {0, 0, 2000}, .factor = {1, 0.5, 0}};
    const double cosine = 0.8; // 1.5 m aside, 2 m below
    const double cd = std::atan(0.75) * 45 / std::atan(1);
    const Rgb lx = illuminance(lamp, Vec3(1500, 0, 0), Vec3(0, 0, 1));
    EXPECT_NEAR(lx.r, cd * cosine / 6.25, 1e-9);
    EXPECT_NEAR(lx.g, cd * cosine / 12.5, 1e-9);
    EXPECT_EQ(lx.b, 0);
}
