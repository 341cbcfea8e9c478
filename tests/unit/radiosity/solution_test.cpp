#include "keiko/base/error.h"
#include "keiko/radiosity/reflected_light.h"
#include "keiko/radiosity/solution_file.h"

#include "tests/support/shapes.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

namespace keiko {
namespace {

/// A square plate of two elements at z = 0 in the middle of a large one of one element at z = 100.
SurfaceModel plates() {
    return test::ShapeBuilder()
        .face({test::rectangle(0, 10, 0, 10, 0)})
        .face({test::rectangle(-1e5, 1e5, -1e5, 1e5, 100)})
        .model();
}

/// Light of two lamps on the plates; on the fronts of the small one that of the first rises along
/// x.
RadiositySolution slope() {
    RadiositySolution s;
    s.geometry = std::string(64, '0'), s.lighting = std::string(64, 'f');
    s.remaining = 0.125, s.factor_rows = 5;
    s.balance = {Rgb(3), Rgb(1), Rgb(2)};
    s.corners = {{0, 0},       {10, 0},     {10, 10},   {0, 10},
                 {-1e5, -1e5}, {1e5, -1e5}, {1e5, 1e5}, {-1e5, 1e5}};
    s.triangles = {
        {{0, 1, 2}, 0, 0, 0}, {{0, 2, 3}, 1, 0, 0}, {{4, 5, 6}, 2, 0, 1}, {{4, 6, 7}, 2, 0, 1}};
    s.elements = 3;
    LampSolution first, second;
    for (const Vec2& corner : s.corners) {
        first.arriving.push_back({Rgb(2 + std::max(corner.x, 0.0) / 5), Rgb(8)});
        second.arriving.push_back({Rgb(1, 2, 3), Rgb(0)});
    }
    first.exitance = {{Rgb(1), Rgb(0)}, {Rgb(1), Rgb(0)}, {Rgb(7), Rgb(40)}};
    second.exitance.resize(3);
    s.lamps = {first, second};
    return s;
}

struct Lit {
    SurfaceModel model = plates();
    ReflectedLight light;

    explicit Lit(const std::vector<Rgb>& levels, double reflectance = 0)
        : light(slope(), levels, std::vector<Rgb>(2, Rgb(reflectance)), model, Tracer(model)) {}
    std::optional<Rgb> at(double x, double y, double up) const {
        const Vec2 uv(x / 10, y / 10);
        return light.on_surface({0, 0, {uv, uv}}, Vec3(0, 0, up));
    }
};

TEST(ReflectedLight, IsInterpolatedOnEachSide) {
    const Lit plate({Rgb(1), Rgb(0)});
    EXPECT_NEAR(plate.at(10, 0, 1)->g, 4, 1e-12);
    EXPECT_NEAR(plate.at(0, 10, 1)->g, 2, 1e-12);
    EXPECT_NEAR(plate.at(5, 7, 1)->g, 3, 1e-12);
    EXPECT_NEAR(plate.at(3, 4, -1)->g, 8, 1e-12);
}

TEST(ReflectedLight, IsThatOfTheLampsAtTheirLevels) {
    const Lit plate({Rgb(0.5), Rgb(0, 2, 1)});
    EXPECT_NEAR(plate.at(10, 0, 1)->r, 2, 1e-12);
    EXPECT_NEAR(plate.at(10, 0, 1)->g, 2 + 4, 1e-12);
    EXPECT_NEAR(plate.at(10, 0, 1)->b, 2 + 3, 1e-12);
}

TEST(ReflectedLight, IsGatheredFromRadiositiesBySolidAngle) {
    const Lit plate({Rgb(1), Rgb(0)});
    EXPECT_NEAR(plate.light.gathered({Vec3(3, 2, 50), Vec3(0, 0, 1), {}}).g, 40, 1e-2);
    EXPECT_NEAR(plate.light.gathered({Vec3(3, 2, 150), Vec3(0, 0, 1), {}}).g, 0, 1e-9);
    EXPECT_NEAR(plate.light.gathered({Vec3(3, 2, 50), Vec3(1, 0, 0), {}}).g, 20, 0.1);
    EXPECT_NEAR(plate.light.gathered({Vec3(3, 2, 150), Vec3(0, 0, -1), {}}).g, 7, 1e-2);
}

// Direct light that elements reflect, and light of others by their reflectance.
TEST(ReflectedLight, IsGatheredWithWhatArrivesAtElements) {
    const Lit plate({Rgb(1), Rgb(0)}, 0.5);
    EXPECT_NEAR(plate.light.gathered({Vec3(3, 2, 50), Vec3(0, 0, 1), {}}).g, 40 + 0.5 * 8, 1e-2);
}

TEST(SolutionFile, ReadsWhatItWrites) {
    const RadiositySolution one = slope();
    const std::string text = solution_text(one);
    const RadiositySolution read = parse_solution(text, "a.solution");
    EXPECT_EQ(solution_text(read), text);
    EXPECT_EQ(read.corners, one.corners);
    EXPECT_EQ(read.triangles, one.triangles);
    EXPECT_EQ(read.lamps[1].arriving[5][0], Rgb(1, 2, 3));
    EXPECT_EQ(read.lamps[0].exitance[2][1], Rgb(40));
    EXPECT_EQ(read.balance.escaped, Rgb(2));
}

std::string error_of(const std::string& text) {
    try {
        parse_solution(text, "a.solution");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
    text.replace(text.find(old), old.size(), by);
    return text;
}

TEST(SolutionFile, NamesTheLineOfAFault) {
    const std::string text = solution_text(slope());
    EXPECT_EQ(error_of("keiko-scene/1\n"),
              "a.solution:line 1: expected \"keiko-solution/1\", found \"keiko-scene/1\"");
    EXPECT_EQ(error_of(replaced(text, "geometry 0", "geometry x")),
              "a.solution:line 2: geometry is no SHA-256");
    EXPECT_EQ(error_of(replaced(text, "remaining 0.125", "remaining -1")),
              "a.solution:line 4: \"-1\" is no number from 0 to 1e+15");
    EXPECT_EQ(error_of(replaced(text, "\n10 0\n", "\n10 nan\n")),
              "a.solution:line 12: \"nan\" is no number from -1e+15 to 1e+15");
    EXPECT_EQ(error_of(replaced(text, "\n0 1 2 0", "\n0 1 8 0")),
              "a.solution:line 21: \"8\" is no number from 0 to 7");
    EXPECT_EQ(error_of(replaced(text, "\n4 6 7 2", "\n4 6 7 3")),
              "a.solution:line 24: \"3\" is no number from 0 to 2");
    EXPECT_NE(error_of(text.substr(0, text.size() - 6)).find("ends here, too early"),
              std::string::npos);
    EXPECT_NE(error_of(text + "more").find("goes on after its end"), std::string::npos);
    EXPECT_NE(error_of(replaced(text, "corners 8", "corners 99999")), "");
    EXPECT_NE(error_of(replaced(text, "lamps 2", "lamps 3")), "");
}

} // namespace
} // namespace keiko
