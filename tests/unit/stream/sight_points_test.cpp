#include "keiko/stream/sight_points.h"

#include "keiko/base/error.h"

#include "tests/support/model_builder.h"
#include "tests/unit/stream/cut_text.h"
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

namespace keiko {
namespace {

constexpr double extinction = 0.03, horizon = 80; // 1/m, cd/m2

Material matt(double reflectance) {
    Material material;
    material.diffuse = Rgb(reflectance), material.refractive_index = 1;
    return material;
}

/// A wall at x = 20 m, 4 m high, in fog; a sign and a lamp beyond a board 10 m away, to the right.
Scene foggy(LightRig rig) {
    test::ModelBuilder builder;
    builder.plane({20000, -2000, -2000}, {0, 0, 4000}, {0, 4000, 0}); // its normal towards -x
    builder.plane({10000, 5000, -1000}, {0, 0, 2000}, {0, 2000, 0});
    SurfaceModel model = builder.build();
    Tracer tracer(model, {.second_derivatives = true});
    Occluders occluders(model, tracer);
    rig.medium = Medium{.extinction = Rgb(extinction), .ambient = Rgb(horizon)};
    return {.model = std::move(model),
            .materials = {matt(0.4), Material{}},
            .tracer = std::move(tracer),
            .occluders = std::move(occluders),
            .camera = {},
            .view = {},
            .rig = std::move(rig)};
}

/// A sign of 2 m by 1 m that shines towards -x.
LuminousSign sign_at(const Vec3& corner) {
    const Vec3 y(0, 2000, 0), z(0, 0, 1000);
    LuminousSign sign;
    sign.panel = {{corner, corner + z, corner + y + z, corner + y}, Rgb(20)};
    const Vec3 inner = corner + y / 4 + z / 4;
    sign.legend = {{{inner, inner + z / 2, inner + y / 2 + z / 2, inner + y / 2}, Rgb(500)}};
    return sign;
}

LightRig rig_of(const LuminousSign& sign, const PointSource& lamp) {
    LightRig rig;
    rig.ambient = Rgb(300);
    for (const PolygonLight& panel : sign.panels()) rig.sources.emplace_back(panel);
    rig.sources.emplace_back(lamp);
    rig.signs = {sign};
    return rig;
}

std::string sight(const Scene& scene, const std::string& eyes, std::size_t cut = 7) {
    std::string rows;
    sight_points(scene, {}, test::cut_text(eyes, cut), [&](std::string_view text) {
        rows += text;
        return true;
    });
    return rows;
}

/// The fields of the last row by column.
std::map<std::string, std::string> last_row(const std::string& rows) {
    std::istringstream text(rows);
    std::string header, line, row;
    std::getline(text, header);
    while (std::getline(text, line)) row = line;
    std::istringstream names(header), fields(row + ",");
    std::map<std::string, std::string> found;
    for (std::string name, field; std::getline(names, name, ',');) {
        std::getline(fields, field, ',');
        found[name] = field;
    }
    return found;
}

TEST(SightPoints, TellOfWallSignAndLamp) {
    const LuminousSign sign = sign_at({15000, -1000, 5000});
    const PointSource lamp{.position = {12000, 0, 3000}, .intensity = Rgb(50)};
    const Scene scene = foggy(rig_of(sign, lamp));
    auto row = last_row(sight(scene, "ox,oy,oz,dx,dy,dz\n0,0,0,2,0,0\n"));
    const auto number = [&](const char* column) { return std::stod(row.at(column)); };
    EXPECT_NEAR(number("distance_m"), 20, 1e-12);
    const double passed = std::exp(-extinction * 20);
    EXPECT_NEAR(number("contrast"), number("near_contrast") * passed, 1e-12);
    EXPECT_NEAR(number("visible_to_m"),
                std::log(std::abs(number("near_contrast")) / 0.05) / extinction, 1e-9);

    const double d = (sign.center()).length() / 1000, left = std::exp(-extinction * d);
    EXPECT_GT(number("sign.0.contrast"), 0);
    const double added = 480 * left / number("sign.0.contrast") - 20 * left;
    EXPECT_GT(added, horizon * (1 - left)) << "the lamp lights the fog before the sign";
    EXPECT_LT(added, 1.1 * horizon * (1 - left));
    EXPECT_GT(number("sign.0.legible_to_m"), d);

    const double far = lamp.position.length() / 1000;
    EXPECT_NEAR(number("point.0.lux"), 50 * std::exp(-extinction * far) / (far * far), 1e-12);
    const double range = number("point.0.visible_to_m");
    EXPECT_NEAR(50 * std::exp(-extinction * range) / (range * range), 2e-7, 1e-15);
}

/// From near a wall in ambient light alone has 0.4 of the ambient's luminance.
TEST(SightPoints, ContrastOfAWallIsThatOfItsLuminance) {
    LightRig rig;
    rig.ambient = Rgb(300);
    const auto row = last_row(sight(foggy(rig), "5000,0,0,1,0,0\n"));
    const double wall = 0.4 * 300 / std::numbers::pi;
    EXPECT_NEAR(std::stod(row.at("near_contrast")), (wall - horizon) / horizon, 1e-4);
    EXPECT_EQ(row.size(), 4U);
}

/// Uniform haze scatters half of a uniform sky to each side, times its albedo.
TEST(SightPoints, HorizonHasTheLightOfTheSkyInIt) {
    constexpr double above = 1000; // cd/m2
    LightRig rig;
    rig.sources = {SkyLight{SkyModel::uniform, Rgb(above)}};
    Scene scene = foggy(rig);
    Medium& haze = *scene.rig->medium;
    haze.extinction = Rgb(1e-6), haze.ambient = Rgb(0), haze.dims_light_leg = false;
    const double there = haze.albedo.g * above / 2;
    const double wall = 0.4 * above / 2; // by half of the sky
    const auto row = last_row(sight(scene, "5000,0,0,1,0,0\n"));
    EXPECT_NEAR(std::stod(row.at("near_contrast")), (wall - there) / there, 0.01);
}

TEST(SightPoints, WhatABodyHidesIsNotSeen) {
    const Scene scene = foggy(rig_of(sign_at({15000, 7500, 0}), {.position = {15000, 8000, 0}}));
    const auto hidden = last_row(sight(scene, "0,3500,0,1,0.1,0\n"));
    EXPECT_EQ(hidden.at("sign.0.contrast"), "0");
    EXPECT_EQ(hidden.at("sign.0.legible_to_m"), "0");
    EXPECT_EQ(hidden.at("point.0.lux"), "0");
    EXPECT_EQ(hidden.at("point.0.visible_to_m"), "0");
    const auto open = last_row(sight(scene, "0,9500,0,1,0.1,0\n"));
    EXPECT_GT(std::stod(open.at("sign.0.contrast")), 0);
    EXPECT_GT(std::stod(open.at("point.0.lux")), 0);
    const auto behind = last_row(sight(scene, "17000,8400,0,-1,0,0\n"));
    EXPECT_EQ(behind.at("sign.0.contrast"), "0") << "from behind";
    EXPECT_GT(std::stod(behind.at("point.0.lux")), 0);
}

TEST(SightPoints, NothingAheadAndNoAmbientLightLeaveFieldsEmpty) {
    Scene scene = foggy(rig_of(sign_at({15000, 0, 5000}), {.position = {12000, 0, 3000}}));
    for (const char* column : {"distance_m", "near_contrast", "contrast", "visible_to_m"})
        EXPECT_EQ(last_row(sight(scene, "0,0,0,0,0,1\n")).at(column), "");
    scene.rig->medium->ambient = Rgb(0);
    const auto dark = last_row(sight(scene, "0,0,0,1,0,0\n"));
    EXPECT_EQ(dark.at("distance_m"), "20");
    EXPECT_EQ(dark.at("contrast"), "");
}

TEST(SightPoints, AreTheSameForAnyPieces) {
    const Scene scene = foggy(rig_of(sign_at({15000, 0, 5000}), {.position = {12000, 0, 3000}}));
    std::string eyes;
    for (int i = 0; i < 30; ++i)
        eyes += std::to_string(100 * i) + "," + std::to_string(-70 * i) + ",0,1,0.01,0\n";
    EXPECT_EQ(sight(scene, eyes, 5), sight(scene, eyes, 4000));
}

TEST(SightPoints, NeedFogAndEyes) {
    Scene scene = foggy({});
    EXPECT_THROW(sight(scene, ""), Error);
    EXPECT_THROW(sight(scene, "0,0,0,1,0\n"), Error);
    scene.rig->medium.reset();
    EXPECT_THROW(sight(scene, "0,0,0,1,0,0\n"), Error);
}

} // namespace
} // namespace keiko
