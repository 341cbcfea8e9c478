// Numbers of rigs that are no place, no size and no light that there could be.
#include "keiko/base/error.h"
#include "keiko/files/scene/rig_file.h"

#include <gtest/gtest.h>

#include <string>

namespace keiko {
namespace {

const std::string plane = "[[c_plane]]\nv = [0, 1200, 0]\nu = [1000, 0, 0]\n";
const std::string whole_plane = plane + "origin = [0, 0, 2000]\n";
const std::string spot = "[[spotlight]]\nposition = [0, 0, 4000]\naim = [0, 0, 0]\n";
const std::string sun = "[sun]\ndirection = [1, 0, -1]\nilluminance = 1e4\n";
const std::string fog = spot + "[fog]\nextinction = 0.1\n";

/// Why a rig is refused, from the key on.
std::string refused(const std::string& tables) {
    try {
        parse_rig("format = \"keiko-rig/1\"\n" + tables, "bad.toml");
    } catch (const Error& error) {
        return error.reason();
    }
    return "";
}

TEST(LightLimits, PlacesBeyondAThousandKilometresAreRefused) {
    const std::string allowed = ": must be at least -1e+09 and at most 1e+09, is ";
    EXPECT_EQ(refused(plane + "origin = [1e300, 0, 0]\n"),
              "c_plane[0].origin" + allowed + "1e+300");
    EXPECT_EQ(refused("[[c_plane]]\norigin = [0, 0, 0]\nu = [0, -2e9, 0]\nv = [1, 0, 0]\n"),
              "c_plane[0].u" + allowed + "-2e+09");
    EXPECT_EQ(refused("[[spotlight]]\nposition = [0, 0, 1e200]\naim = [0, 0, 0]\n"),
              "spotlight[0].position" + allowed + "1e+200");
    EXPECT_EQ(refused("[[spotlight]]\nposition = [0, 0, 0]\naim = [0, 1e10, 0]\n"),
              "spotlight[0].aim" + allowed + "1e+10");
    EXPECT_EQ(refused("[sun]\ndirection = [0, 0, -1e155]\nilluminance = 1\n"),
              "sun.direction" + allowed + "-1e+155");
    EXPECT_EQ(refused(sun + "[[window]]\ncorners = [[0, 0, 0], [0, 1, 0], [0, 0, 1e99]]\n"),
              "window[0].corners" + allowed + "1e+99 (number 3 of array 3)");
    EXPECT_EQ(refused(fog + "layer = { height = 1e12, extinction_above = 0 }\n"),
              "fog.layer.height" + allowed + "1e+12");
    EXPECT_EQ(refused("[[c_plane]]\norigin = [1e9, -1e9, 0]\nu = [1, 0, 0]\nv = [0, 1e9, 0]\n"),
              "");
}

TEST(LightLimits, SizesThatNoLampHasAreRefused) {
    const std::string allowed = ": must be at least 1e-06 and at most 1e+09, is ";
    EXPECT_EQ(refused(whole_plane + "diameter = 1e-200\n"),
              "c_plane[0].diameter" + allowed + "1e-200");
    EXPECT_EQ(refused(whole_plane + "pitch = 1e40\n"), "c_plane[0].pitch" + allowed + "1e+40");
    EXPECT_EQ(refused(fog + "layer = { height = 0, extinction_above = 0, bump = \"noise\", "
                            "amplitude = 1, wavelength = 1e10 }\n"),
              "fog.layer.wavelength: must be at least 300 and at most 1e+09, is 1e+10");
}

TEST(LightLimits, FogLayersWhoseWavesCannotBeFollowedAreRefused) {
    const auto noise = [](const std::string& amplitude, const std::string& wavelength) {
        return refused(fog + "layer = { height = 0, extinction_above = 0, bump = \"noise\", " +
                       "amplitude = " + amplitude + ", wavelength = " + wavelength + " }\n");
    };
    EXPECT_EQ(noise("2000", "20"),
              "fog.layer.wavelength: must be at least 300 and at most 1e+09, is 20");
    EXPECT_EQ(noise("2000", "400"),
              "fog.layer.amplitude: must be at least 0 and at most 100, is 2000");
    EXPECT_EQ(noise("100", "400"), "");
    const auto wave = [](const std::string& amplitude, const std::string& wavelength) {
        return refused(fog + "layer = { height = 0, extinction_above = 0, bump = \"waves\", " +
                       "waves = [{ amplitude = " + amplitude + ", wavelength = " + wavelength +
                       " }] }\n");
    };
    EXPECT_EQ(wave("2000", "[20, 700]"),
              "fog.layer.waves[0].amplitude: must be at least -5 and at most 5, is 2000");
    EXPECT_EQ(wave("2", "[10, 700]"),
              "fog.layer.waves[0].wavelength: must be at least 20 and at most 1e+09, is 10");
    EXPECT_EQ(wave("-5", "[20, 700]"), "");
}

TEST(LightLimits, BeamsTooNarrowForTheirProfileAreRefused) {
    EXPECT_EQ(refused(spot + "half_angle = 1e-300\n"),
              "spotlight[0].half_angle: must be at least 0.001 and at most 180, is 1e-300");
    EXPECT_EQ(refused(spot + "half_angle_across = 1e-9\n"),
              "spotlight[0].half_angle_across: must be at least 0.001 and at most 89, is 1e-09");
    EXPECT_EQ(refused(spot + "half_angle = 1e-3\n"), "");
}

TEST(LightLimits, LightBeyondAllLampsIsRefusedByTheKeyThatHoldsIt) {
    const std::string allowed = ": must be at least 0 and at most 1e+15, is 1e+16";
    EXPECT_EQ(refused(whole_plane + "luminance = 1e16\ncolor = [10, 1, 1]\n"),
              "c_plane[0].luminance" + allowed);
    EXPECT_EQ(refused(whole_plane + "luminance = 1e16\n"), "c_plane[0].luminance" + allowed);
    EXPECT_EQ(refused(whole_plane + "luminous_flux = 1e16\n"),
              "c_plane[0].luminous_flux" + allowed);
    EXPECT_EQ(refused(whole_plane + "color = 1e16\n"), "c_plane[0].color" + allowed);
    EXPECT_EQ(refused(spot + "intensity = 1e16\n"), "spotlight[0].intensity" + allowed);
    EXPECT_EQ(refused("[sun]\ndirection = [1, 0, -1]\nilluminance = 1e16\n"),
              "sun.illuminance" + allowed);
    EXPECT_EQ(refused("ambient = 1e16\n"), "ambient" + allowed);
    EXPECT_EQ(refused(spot + "edge = \"table\"\ntable = { theta = [0], values = [[1e16]] }\n"),
              "spotlight[0].table.values: must be at most 1e+15, is 1e+16 (number 1 of array 1)");
    EXPECT_EQ(refused(spot + "edge = \"polynomial\"\ncoefficients = [-1e16]\n"),
              "spotlight[0].coefficients: must be at least -1e+15 and at most 1e+15, is -1e+16");
    EXPECT_EQ(refused(spot + "[fog]\nextinction = 1e7\n"),
              "fog.extinction: must be at least 0 and at most 1e+06, is 1e+07");
}

TEST(LightLimits, WhatAColourMakesTooBrightIsNamedByTheLight) {
    const std::string reason = ": is too bright, times the color";
    EXPECT_EQ(refused(whole_plane + "luminance = 1e10\ncolor = 1e10\n"),
              "c_plane[0].luminance" + reason);
    EXPECT_EQ(refused(whole_plane + "color = 1e14\n"), "c_plane[0].color" + reason)
        << "times the luminance that a lamp has of its own accord";
    EXPECT_EQ(refused(whole_plane + "luminous_flux = 1e15\ndiameter = 1e-5\n"),
              "c_plane[0].luminous_flux: is too bright");
    EXPECT_EQ(refused(spot + "intensity = 1e10\ncolor = 1e10\n"),
              "spotlight[0].intensity" + reason);
}

} // namespace
} // namespace keiko
