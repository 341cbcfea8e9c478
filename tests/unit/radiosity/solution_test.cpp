#include "keiko/base/error.h"
#include "keiko/radiosity/reflected_light.h"
#include "keiko/radiosity/solution_file.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace keiko {
namespace {

/// Two triangles, whose light rises along x.
RadiositySolution slope() {
    RadiositySolution s;
    s.geometry = std::string(64, '0'), s.lighting = std::string(64, 'f');
    s.remaining = 0.125;
    s.balance = {Rgb(3), Rgb(1), Rgb(2)};
    s.corners = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {0, 0, 5}, {9, 0, 5}, {0, 9, 5}};
    s.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}};
    s.light = {{ElementLight{Rgb(4), Rgb(1)}, ElementLight{Rgb(8), Rgb(2)}},
               {ElementLight{Rgb(2), Rgb(1)}, ElementLight{Rgb(8), Rgb(2)}},
               {ElementLight{Rgb(1, 2, 3), Rgb(5)}, ElementLight{Rgb(0), Rgb(0.1)}}};
    return s;
}

TEST(ReflectedLight, IsInterpolatedOnEachSide) {
    const ReflectedLight light(slope());
    const Vec3 up(0, 0, 1);
    EXPECT_NEAR(light.on_surface({10, 0, 0}, up)->g, 4, 1e-12);
    EXPECT_NEAR(light.on_surface({0, 10, 0}, up)->g, 2, 1e-12);
    EXPECT_NEAR(light.on_surface({5, 5, 0.1}, up)->g, 3, 1e-12);
    EXPECT_NEAR(light.on_surface({10, 5, 0}, up)->g, 3.5, 1e-12);
    EXPECT_NEAR(light.on_surface({20, -5, 0}, up)->g, 4, 1e-12);
    EXPECT_NEAR(light.on_surface({3, 4, 0}, -up)->g, 8, 1e-12);
    EXPECT_EQ(light.on_surface({3, 4, 4}, up), Rgb(1, 2, 3));
    EXPECT_EQ(light.on_surface({3, 4, 0}, {1, 0, 0}), std::nullopt);
}

TEST(ReflectedLight, OfAPlaceWithoutElementsIsThatInSpace) {
    const ReflectedLight light(slope());
    const Vec3 up(0, 0, 1); // longest side 14.1, of the top one 12.7
    EXPECT_TRUE(light.on_surface({3, 4, 16}, up));
    EXPECT_EQ(light.on_surface({3, 4, 19}, up), std::nullopt);
    EXPECT_EQ(light.on_surface({3, 4, -15}, up), std::nullopt);
    EXPECT_EQ(light.arriving({3, 4, 16}, up), Rgb(1, 2, 3));
    EXPECT_EQ(light.arriving({3, 4, 19}, -up), light.in_space({3, 4, 19}, -up));
    EXPECT_GT(light.arriving({3, 4, 19}, -up).g, 0.2);
}

TEST(ReflectedLight, InSpaceIsThatOfRadiositiesBySolidAngle) {
    RadiositySolution s = slope();
    s.corners = {{-1e6, -1e6, 100}, {1e6, -1e6, 100}, {1e6, 1e6, 100}, {-1e6, 1e6, 100}};
    s.triangles = {{0, 1, 2}, {0, 2, 3}};
    s.light.resize(2);
    for (auto& [front, back] : s.light) front.radiosity = Rgb(7), back.radiosity = Rgb(40);
    const ReflectedLight light(s);
    EXPECT_NEAR(light.in_space(Vec3(3, 2, 0), Vec3(0, 0, 1)).g, 40, 0.2); // backs face it
    EXPECT_NEAR(light.in_space(Vec3(3, 2, 0), Vec3(0, 0, -1)).g, 0, 1e-9);
    EXPECT_NEAR(light.in_space(Vec3(3, 2, 0), Vec3(1, 0, 0)).g, 20, 0.2);
}

TEST(SolutionFile, ReadsWhatItWrites) {
    const RadiositySolution one = slope();
    const std::string text = solution_text(one);
    const RadiositySolution read = parse_solution(text, "a.solution");
    EXPECT_EQ(solution_text(read), text);
    EXPECT_EQ(read.corners, one.corners);
    EXPECT_EQ(read.light[2][0].arriving, Rgb(1, 2, 3));
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
    EXPECT_EQ(error_of(replaced(text, "\n10 0 0", "\n10 nan 0")),
              "a.solution:line 10: \"nan\" is no number from -1e+15 to 1e+15");
    EXPECT_EQ(error_of(replaced(text, "\n0 1 2 4", "\n0 1 9 4")),
              "a.solution:line 17: \"9\" is no number from 0 to 6");
    EXPECT_EQ(error_of(text.substr(0, text.size() - 6)),
              "a.solution:line 19: ends here, too early");
    EXPECT_EQ(error_of(text + "more"), "a.solution:line 20: goes on after its end");
    EXPECT_NE(error_of(replaced(text, "corners 7", "corners 99999")), "");
}

} // namespace
} // namespace keiko
