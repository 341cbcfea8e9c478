#include "keiko/files/scene/rig_file.h"
#include "keiko/files/scene/scene_file.h"
#include "keiko/light/sky/sky_irradiance.h"
#include "keiko/light/sky/solar_position.h"
#include "keiko/scene/animation.h"

#include "tests/support/rig_text.h"
#include <gtest/gtest.h>

#include <numbers>

namespace keiko {
namespace {

const std::string head = "format = \"keiko-rig/1\"\n";
const std::string place =
    "[place]\nlatitude = 48.1\nlongitude = 11.6\ntime = 2026-06-21T14:30:00+02:00\n";
const std::string window = "[[window]]\ncorners = [[0, 0, 0], [0, 1, 0], [0, 0, 1]]\n";

/// The message of the Error that the tables of a rig cause; "" when there is none.
std::string rig_error(const std::string& tables) {
    return test::rig_error(head + tables);
}

SkyLight sky_of(const std::string& text) {
    return std::get<SkyLight>(parse_rig(head + text, "rig.toml").sources.at(0));
}

TEST(DaylightTables, SkyReadsAndWritesEveryModel) {
    for (const std::string keys :
         {"", "model = \"uniform\"\nluminance = [3000, 4000, 5000]\n",
          "model = \"gradient\"\nhorizon = 2.5\ncolor = 0.5\nground = [10, 20, 30]\n",
          "model = \"clear\"\nsun = [1, -2, 0.5]\nluminance = 1234.5\n"}) {
        const LightRig rig = parse_rig(head + "[sky]\n" + keys + window, "rig.toml");
        const LightRig back = parse_rig(rig_text(rig), "rig.toml");
        EXPECT_EQ(std::get<SkyLight>(back.sources.at(0)), std::get<SkyLight>(rig.sources.at(0)))
            << rig_text(rig);
    }
    const SkyLight plain = sky_of("[sky]\n");
    EXPECT_EQ(plain.model, SkyModel::overcast);
    EXPECT_EQ(plain.luminance, Rgb(10000));
    EXPECT_EQ(sky_of("[sky]\n" + window).windows.size(), 1U);
}

TEST(DaylightTables, IlluminanceIsThatOfOpenLevelGround) {
    const SkyLight sky = sky_of("[sky]\nilluminance = 20000\ncolor = [1, 1, 0.5]\n");
    const Rgb lx = sky.luminance * unobstructed_illuminance(sky, {0, 0, 1});
    EXPECT_NEAR(lx.r, 20000, 1e-9);
    EXPECT_NEAR(lx.b, 10000, 1e-9);
}

TEST(DaylightTables, PlaceGivesTheSunOfBoth) {
    const LightRig rig = parse_rig(
        head + place + "[sun]\nilluminance = 9e4\n[sky]\nmodel = \"clear\"\n" + window, "rig.toml");
    const Vec3 towards = direction_to_sun({48.1, 11.6}, {2026, 6, 21, 12.5});
    EXPECT_LT((std::get<Sun>(rig.sources.at(0)).towards() - towards).length(), 1e-14);
    EXPECT_LT((std::get<SkyLight>(rig.sources.at(1)).sun - towards).length(), 1e-14);
    EXPECT_GT(towards.z, std::sin(60 * std::numbers::pi / 180)); // high at Munich in June
    const LightRig back = parse_rig(rig_text(rig), "rig.toml");
    EXPECT_EQ(std::get<SkyLight>(back.sources.at(1)), std::get<SkyLight>(rig.sources.at(1)));
    EXPECT_EQ(std::get<Sun>(back.sources.at(0)).windows.size(), 1U);
    const LightRig turned =
        parse_rig(head + place + "north = [1, 0, 0]\n[sky]\nmodel = \"clear\"\n", "rig.toml");
    EXPECT_NEAR(std::get<SkyLight>(turned.sources.at(0)).sun.x, towards.y, 1e-14);
}

TEST(DaylightTables, RefuseWhatMakesNoSense) {
    EXPECT_EQ(rig_error("[sky]\nmodel = \"cloudy\"\n"),
              "bad.toml:3:9: sky.model: 'cloudy' is none of uniform, overcast, gradient, clear");
    EXPECT_EQ(rig_error("[sky]\nmodel = \"gradient\"\n"),
              "bad.toml:2:1: sky: 'horizon' is missing");
    EXPECT_EQ(rig_error("[sky]\nhorizon = 2\n"),
              "bad.toml:3:11: sky.horizon: belongs to a gradient");
    EXPECT_EQ(rig_error("[sky]\nsun = [1, 0, 1]\n"),
              "bad.toml:3:7: sky.sun: belongs to a clear sky");
    EXPECT_EQ(rig_error("[sky]\nmodel = \"clear\"\n"),
              "bad.toml:3:9: sky.model: a clear sky needs sun, [sun] or [place]");
    EXPECT_EQ(rig_error("[sky]\nmodel = \"clear\"\nsun = [1, 0, -1]\n"),
              "bad.toml:4:7: sky.sun: the sun is not above the horizon");
    EXPECT_EQ(
        rig_error("[sky]\nmodel = \"clear\"\n[sun]\ndirection = [0, 1, 0]\nilluminance = 1\n"),
        "bad.toml:2:1: sky: the sun is not above the horizon");
    EXPECT_EQ(rig_error("[sky]\nluminance = 1\nilluminance = 1\n"),
              "bad.toml:4:15: sky.illuminance: give either luminance or illuminance, not both");
    EXPECT_EQ(rig_error(place), "bad.toml:2:1: place: lights nothing without [sun] or [sky]");
    EXPECT_EQ(rig_error(place + "[sun]\ndirection = [0, 0, -1]\nilluminance = 1\n"),
              "bad.toml:7:13: sun.direction: give either direction or [place], not both");
    EXPECT_EQ(rig_error(place + "north = [0, 0, 1]\n[sky]\n"),
              "bad.toml:6:9: place.north: must not be vertical");
    const std::string at = "[sky]\n[place]\nlatitude = 48.1\nlongitude = 11.6\n";
    EXPECT_EQ(rig_error(at + "time = 2026-06-21T01:30:00+02:00\n").substr(0, 43),
              "bad.toml:6:8: place.time: the sun is 18.4 d");
    const std::string no_time =
        "bad.toml:6:8: place.time: must be a date and a time with an offset, "
        "without quotes, as 2026-06-21T14:30:00+02:00";
    EXPECT_EQ(rig_error(at + "time = 2026-06-21T14:30:00\n"), no_time);
    EXPECT_EQ(rig_error(at + "time = 2026-06-21\n"), no_time);
    EXPECT_EQ(rig_error(at + "time = \"noon\"\n"), no_time);
    EXPECT_EQ(rig_error(at + "time = 1706-05-12T10:30:00Z\n"),
              "bad.toml:6:8: place.time: must be from the years 1900 to 2100");
    EXPECT_EQ(rig_error(at), "bad.toml:3:1: place: 'time' is missing");
    EXPECT_EQ(rig_error("[place]\nlatitude = 91\n[sky]\n").substr(0, 30),
              "bad.toml:3:12: place.latitude:");
}

TEST(DaylightTables, RigsWithTwoSkiesOrOtherWindowsAreNotWritten) {
    LightRig rig;
    rig.sources = {SkyLight(), SkyLight()};
    EXPECT_THROW(rig_text(rig), Error);
    rig.sources = {Sun(), SkyLight()};
    EXPECT_NO_THROW(rig_text(rig));
    std::get<SkyLight>(rig.sources[1]).windows = {{{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
    EXPECT_THROW(rig_text(rig), Error);
}

TEST(DaylightTables, AnimatedSunCarriesTheClearSky) {
    SceneSpec scene;
    scene.rig = parse_rig(
        head + "[sun]\ndirection = [1, 0, -1]\nilluminance = 1\n[sky]\nmodel = \"clear\"\n",
        "rig.toml");
    scene.animations = {{"sun.direction", {{0, {1, 0, -1}}, {10, {0, 1, -1}}}},
                        {"sky.luminance", {{0, {0}}, {10, {50}}}}};
    for (const Animation& animation : scene.animations)
        EXPECT_FALSE(animation_fault(scene, animation));
    const SceneSpec later = at_frame(scene, 10);
    const auto& sky = std::get<SkyLight>(later.rig->sources.at(1));
    EXPECT_LT((sky.sun - Vec3(0, -1, 1).normalized()).length(), 1e-14);
    EXPECT_EQ(sky.luminance, Rgb(50));
    scene.animations[0].keys[1].value = {1, 0, 0.5};
    EXPECT_THROW(at_frame(scene, 10), Error);
}

} // namespace
} // namespace keiko
