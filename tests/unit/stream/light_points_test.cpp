#include "keiko/stream/light_points.h"

#include "keiko/light/rig/surface_light.h"
#include "keiko/volumes/scene_volumes.h"

#include "tests/support/model_builder.h"
#include "tests/unit/stream/cut_text.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <sstream>

namespace keiko {
namespace {

const CPlane lamps{.origin = {-600, -500, 2000}, .u = {1200, 0, 0}, .v = {0, 1000, 0}, .lamps = 4};
const Spotlight spot{.position = {0, 0, 3000}, .aim = Vec3(0), .intensity = Rgb(5000)};

/// A plate; with a board, at a height of 450 mm, over half of it and far beyond.
Scene scene_under(std::optional<LightRig> rig, bool board = false) {
    test::ModelBuilder builder;
    builder.plane({-100, -100, 0}, {200, 0, 0}, {0, 200, 0});
    if (board) builder.plane({0, -500, 450}, {500, 0, 0}, {0, 1000, 0});
    SurfaceModel model = builder.build();
    Tracer tracer(model, {.second_derivatives = true});
    Occluders occluders(model, tracer);
    return {.model = std::move(model),
            .materials = {Material{}},
            .tracer = std::move(tracer),
            .occluders = std::move(occluders),
            .camera = {},
            .view = {},
            .rig = std::move(rig)};
}

LightRig rig() {
    return {.name = "", .sources = {spot, lamps, CPlane(lamps)}, .ambient = Rgb(7), .medium = {}};
}

std::string rows_for(const std::string& points, std::size_t cut = 7) {
    std::string rows;
    light_points(scene_under(rig()), test::cut_text(points, cut), [&](std::string_view text) {
        rows += text;
        return true;
    });
    return rows;
}

TEST(LightPoints, TellsEachSourceAndTheSum) {
    std::istringstream rows(rows_for("x,y,z,nx,ny,nz\n0,0,0,0,0,5\n0,0,0,0,0,-1"));
    std::string header, lit, dark;
    std::getline(rows, header);
    std::getline(rows, lit);
    std::getline(rows, dark);
    EXPECT_EQ(header, "spotlight.0,c_plane.0,c_plane.1,sum");
    EXPECT_EQ(dark, "0,0,0,0");
    std::array<double, 4> lux{};
    char comma = 0;
    std::istringstream fields(lit);
    fields >> lux[0] >> comma >> lux[1] >> comma >> lux[2] >> comma >> lux[3];
    EXPECT_NEAR(lux[0], 5000 / 9.0, 1e-9);
    const double row = illuminance_from(lamps, {}, Vec3(0), {0, 0, 1}, Unoccluded()).g;
    EXPECT_NEAR(lux[1], row, 1e-12 * row);
    EXPECT_EQ(lux[1], lux[2]);
    EXPECT_NEAR(lux[3], lux[0] + lux[1] + lux[2], 1e-9) << "without the ambient light";
}

/// The number in a row's last column.
double sum_of(const std::string& rows) {
    return std::stod(rows.substr(rows.rfind(',') + 1));
}

/// A uniform slab of 200 mm, from the height 400 mm on, wide enough for light aslant.
std::shared_ptr<const SceneVolumes> slab(double extinction) {
    VolumeSpec spec;
    spec.voxels.origin = Vec3(-5000, -5000, 400);
    spec.voxels.spacing = Vec3(2500, 2500, 50);
    spec.extinction.points = {{0, extinction}}; // 1/m
    std::vector<Volume> volumes;
    volumes.emplace_back(spec, VoxelGrid({5, 5, 5}, std::vector<float>(125, 0.0F)), Job{});
    return std::make_shared<const SceneVolumes>(std::move(volumes));
}

TEST(LightPoints, VolumesDimLampsAndSunsByBeersLaw) {
    LightRig rig;
    const Vec3 way = Vec3(1, 2, -3).normalized();
    rig.sources = {
        spot, Sun{.direction = way, .illuminance = Rgb(1000)},
        PolygonLight{{{-9, -9, 900}, {-9, 9, 900}, {9, 9, 900}, {9, -9, 900}}, Rgb(9e5)}};
    Scene scene = scene_under(rig);
    Ray point;
    point.direction = Vec3(0, 0, 1);
    const std::vector<double> clear = illuminance_at(scene, rig, std::span(&point, 1)).lux;
    scene.volumes = slab(2.5);
    const std::vector<double> dimmed = illuminance_at(scene, rig, std::span(&point, 1)).lux;
    ASSERT_EQ(dimmed.size(), 4U);
    EXPECT_NEAR(dimmed[0] / clear[0], std::exp(-2.5 * 0.2), 1e-6);
    EXPECT_NEAR(dimmed[1] / clear[1], std::exp(-2.5 * 0.2 / -way.z), 1e-6);
    EXPECT_NEAR(dimmed[2] / clear[2], std::exp(-2.5 * 0.2), 1e-4) << "a small panel overhead";
    scene.occluders.reset();
    EXPECT_EQ(illuminance_at(scene, rig, std::span(&point, 1)).lux, clear) << "without shadows";
}

/// The board hides half of a panel right above the point, along the panel's middle.
TEST(LightPoints, PanelsAndSpheresHaveColumnsAndShadows) {
    const PolygonLight panel{
        {{-400, -400, 900}, {-400, 400, 900}, {400, 400, 900}, {400, -400, 900}}, Rgb(2000)};
    const SphereLight globe{{-900, 0, 700}, 200, Rgb(3000)};
    LightRig rig;
    rig.sources = {panel, globe};
    const Scene scene = scene_under(rig, true);
    const PointIlluminance lit = illuminance_at(
        scene, *scene.rig, std::array{Ray{.origin = Vec3(0), .direction = Vec3(0, 0, 1)}}, {});
    EXPECT_EQ(lit.columns, (std::vector<std::string>{"polygon.0", "sphere.0", "sum"}));
    const double whole = illuminance_from(panel, {}, Vec3(0), {0, 0, 1}, Unoccluded()).g;
    EXPECT_NEAR(lit.lux[0], whole / 2, 1e-4 * whole);
    const double free = illuminance_from(globe, {}, Vec3(0), {0, 0, 1}, Unoccluded()).g;
    EXPECT_NEAR(lit.lux[1], free, 1e-12 * free);
    EXPECT_NEAR(lit.lux[2], lit.lux[0] + lit.lux[1], 1e-9);
}

/// The board hides what it would send as a panel of the sky's luminance, of each quarter a part.
TEST(LightPoints, SkyHasAColumnAndShadows) {
    const PolygonLight board{
        {{0, -500, 450}, {500, -500, 450}, {500, 500, 450}, {0, 500, 450}}, Rgb(1), true};
    const double covered = illuminance_from(board, {}, Vec3(0), {0, 0, 1}, Unoccluded()).g;
    LightRig rig;
    rig.sources = {SkyLight{SkyModel::uniform, Rgb(1000)}};
    const Scene scene = scene_under(rig, true);
    const PointIlluminance lit = illuminance_at(
        scene, *scene.rig, std::array{Ray{.origin = Vec3(0), .direction = Vec3(0, 0, 1)}}, {});
    EXPECT_EQ(lit.columns, (std::vector<std::string>{"sky.0", "sum"}));
    const double whole = 1000 * std::numbers::pi;
    EXPECT_NEAR(lit.lux[0], whole - 1000 * covered, 1e-4 * whole);
    EXPECT_GT(covered, 0.5);
}

/// Coordinates of points on a surface are often written with a few digits only.
TEST(LightPoints, OfASurfaceAreNotShadowedByItself) {
    const double on = sum_of(rows_for("10,20,0,0,0,1"));
    for (const char* z : {"1e-4", "-1e-4", "1e-12", "-1e-9"})
        EXPECT_NEAR(sum_of(rows_for(std::string("10,20,") + z + ",0,0,1")), on, 1e-6 * on) << z;
    EXPECT_EQ(sum_of(rows_for("10,20,-1,0,0,1")), 0) << "under the surface";
}

std::string summary_of(const std::string& points, std::size_t cut = 7) {
    std::string rows;
    summarize_points(scene_under(rig()), test::cut_text(points, cut), [&](std::string_view text) {
        rows += text;
        return true;
    });
    return rows;
}

TEST(LightPoints, AreSummedUpBySource) {
    const std::string points = "0,0,0,0,0,1\n0,0,0,0,0,-1\n50,0,0,0,0,1\n0,0,0,0,1,1\n";
    std::istringstream rows(rows_for(points)), summary(summary_of(points));
    std::array<double, 4> least{1e9, 1e9, 1e9, 1e9}, most{}, sum{};
    std::string line;
    std::getline(rows, line);
    while (std::getline(rows, line)) {
        std::istringstream fields(line);
        for (std::size_t i = 0; i < 4; ++i) {
            double lux = 0;
            char comma = 0;
            fields >> lux >> comma;
            least[i] = std::min(least[i], lux), most[i] = std::max(most[i], lux), sum[i] += lux;
        }
    }
    std::getline(summary, line);
    EXPECT_EQ(line, "source,points,minimum,mean,maximum,uniformity");
    const std::array names{"spotlight.0", "c_plane.0", "c_plane.1", "sum"};
    for (std::size_t i = 0; i < 4; ++i) {
        ASSERT_TRUE(std::getline(summary, line));
        std::istringstream fields(line);
        std::string name;
        std::getline(fields, name, ',');
        EXPECT_EQ(name, names[i]);
        std::array<double, 5> values{};
        for (double& value : values) {
            fields >> value;
            fields.ignore();
        }
        EXPECT_EQ(values[0], 4);
        EXPECT_EQ(values[1], least[i]);
        EXPECT_EQ(values[1], 0) << "the second point looks down";
        EXPECT_NEAR(values[2], sum[i] / 4, 1e-9);
        EXPECT_EQ(values[3], most[i]);
        EXPECT_EQ(values[4], 0);
    }
    EXPECT_FALSE(std::getline(summary, line));
}

TEST(LightPoints, UniformityIsTheLeastOverTheMean) {
    const std::string one = summary_of("0,0,0,0,0,1\n");
    EXPECT_EQ(one.substr(one.size() - 2), "1\n");
    const std::string dark = summary_of("0,0,0,0,0,-1\n");
    EXPECT_NE(dark.find("sum,1,0,0,0,\n"), std::string::npos) << dark;
    EXPECT_THROW(summary_of("0,0,0,0,0,1\n0,0\n"), Error);
}

/// The message of the Error of some points.
std::string refused(const std::string& points) {
    try {
        rows_for(points);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(LightPoints, InsideLampsAreRefused) {
    const std::string good = "0,0,0,0,0,1\n";
    EXPECT_EQ(refused(good + "0,125,2001,0,0,1\n" + good),
              "standard input:2: x,y,z lies in a lamp of c_plane.0");
    EXPECT_EQ(refused("x,y,z,nx,ny,nz\n" + good + "0,0,3000,0,0,1\n"),
              "standard input:3: x,y,z lies in a lamp of spotlight.0");
    EXPECT_EQ(refused(good + "0,125,1986.9,0,0,-1\n"), "") << "beside the glass";
}

TEST(LightPoints, AreNeeded) {
    for (const char* nothing : {"", "\n\n", "x,y,z,nx,ny,nz\n"}) {
        EXPECT_EQ(refused(nothing), "standard input: holds no points");
        EXPECT_THROW(summary_of(nothing), Error);
    }
}

TEST(LightPoints, SummaryIsTheSameHoweverTheTextIsCut) {
    std::string points;
    for (int i = 0; i < 3000; ++i) points += std::to_string(i) + ",2,3,0.1,0,1\n";
    EXPECT_EQ(summary_of(points, 1 << 20), summary_of(points, 1000));
}

TEST(LightPoints, SameRowsHoweverTheTextIsCut) {
    std::string points;
    for (int i = 0; i < 3000; ++i)
        points += std::to_string(i) + ",2,3,0.1," + std::to_string(i % 7) + ",1\n";
    EXPECT_EQ(rows_for(points, 1 << 20), rows_for(points, 1000));
}

TEST(LightPoints, RefusesAMalformedLineAfterTheRowsBeforeIt) {
    std::string rows;
    const auto sink = [&](std::string_view text) {
        rows += text;
        return true;
    };
    try {
        light_points(scene_under(rig()), test::cut_text("0,0,0,0,0,1\n0,0,0,0,0,0\n", 100), sink);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "standard input:2: nx,ny,nz is no direction: all are 0");
    }
    EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 2);
}

TEST(LightPoints, NeedsARigAndEndsWhenNobodyReads) {
    const auto points = [] { return test::cut_text("0,0,0,0,0,1\n", 100); };
    const auto closed = [](std::string_view) { return false; };
    EXPECT_THROW(light_points(scene_under({}), points(), closed), Error);
    EXPECT_EQ(light_points(scene_under(rig()), points(), closed), 0u);
}

} // namespace
} // namespace keiko
