#include "keiko/base/error.h"
#include "keiko/files/scene/rig_file.h"

#include "tests/support/rig_text.h"
#include <gtest/gtest.h>

#include <numbers>

namespace keiko {
namespace {

using test::only_light;
using test::rig_error;

constexpr double pi = std::numbers::pi;
const std::string head = "format = \"keiko-rig/1\"\n";
const std::string bulb = head + "[[point]]\nposition = [1, 2, 3]\n";
const std::string wire = head + "[[line]]\na = [0, 0, 9]\nb = [2000, 0, 9]\n";

TEST(PointLineTables, PointsAreRead) {
    EXPECT_EQ(only_light<PointSource>(bulb), (PointSource{.position = {1, 2, 3}}));
    const auto lamp = only_light<PointSource>(
        bulb +
        "axis = [0, 1, 0]\ndistribution = \"power\"\nexponent = 3\nintensity = 50\n"
        "color = [1, 0.5, 0]\nshaft = false\n");
    EXPECT_EQ(lamp.distribution, PointDistribution::power);
    EXPECT_EQ(lamp.exponent, 3);
    EXPECT_EQ(lamp.axis, Vec3(0, 1, 0));
    EXPECT_EQ(lamp.intensity, Rgb(50, 25, 0));
    EXPECT_FALSE(lamp.shaft);
}

TEST(PointLineTables, LinesAreRead) {
    const auto light = only_light<LineLight>(wire + "intensity = 40\n");
    EXPECT_EQ(light, (LineLight{{0, 0, 9}, {2000, 0, 9}, Rgb(40)}));
}

/// 4 pi sr of a bulb; pi^2 of the intensity across a line and its length.
TEST(PointLineTables, FluxBecomesIntensity) {
    EXPECT_NEAR(only_light<PointSource>(bulb + "luminous_flux = 800\n").intensity.r, 800 / (4 * pi),
                1e-9);
    EXPECT_NEAR(only_light<LineLight>(wire + "luminous_flux = 800\n").intensity.r,
                800 / (pi * pi * 2), 1e-9);
}

TEST(PointLineTables, WhatIsWrittenReadsBackTheSame) {
    for (const std::string& text :
         {bulb + "distribution = \"cardioid\"\nluminous_flux = 333\n",
          bulb + "distribution = \"power\"\nexponent = 2.5\naxis = [1, 0, 0]\nshaft = false\n"}) {
        const auto lamp = only_light<PointSource>(text);
        LightRig rig;
        rig.sources = {lamp};
        EXPECT_EQ(only_light<PointSource>(rig_text(rig, "")), lamp);
    }
    LightRig rig;
    rig.sources = {only_light<LineLight>(wire + "luminous_flux = 333\n")};
    EXPECT_EQ(only_light<LineLight>(rig_text(rig, "")), std::get<LineLight>(rig.sources[0]));
}

TEST(PointLineTables, BadKeysAreNamed) {
    EXPECT_EQ(rig_error(head + "[[point]]\n"), "bad.toml:2:1: point[0]: 'position' is missing");
    EXPECT_EQ(rig_error(bulb + "axis = [0, 0, 0]\n"),
              "bad.toml:4:8: point[0].axis: must not be a zero vector");
    EXPECT_EQ(rig_error(bulb + "exponent = 2\n"),
              "bad.toml:4:12: point[0].exponent: belongs to distribution = \"power\" alone");
    EXPECT_EQ(rig_error(bulb + "distribution = \"power\"\n"),
              "bad.toml:2:1: point[0]: 'exponent' is missing");
    EXPECT_EQ(rig_error(bulb + "intensity = 1\nluminous_flux = 1\n"),
              "bad.toml:5:17: point[0].luminous_flux: give either intensity or luminous_flux, not "
              "both");
    EXPECT_EQ(rig_error(head + "[[line]]\na = [0, 0, 9]\n"),
              "bad.toml:2:1: line[0]: 'b' is missing");
    EXPECT_EQ(rig_error(head + "[[line]]\na = [0, 0, 9]\nb = [0, 0, 9]\n"),
              "bad.toml:4:5: line[0].b: must differ from a");
}

} // namespace
} // namespace keiko
