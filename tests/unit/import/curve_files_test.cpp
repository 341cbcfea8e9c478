#include "keiko/import/cad/curve_files.h"

#include "keiko/base/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>

namespace keiko::cad {
namespace {

namespace fs = std::filesystem;

/// A set of a rational arc, a curve of two pieces far from the origin, and a polyline.
CurveSet sample_set() {
    CurveSet set{"hood"};
    const double half = std::sqrt(0.5);
    NamedCurve arc{"line 1 of lamp 3: fail, within 0.002 mm", Rgb(1, 0, 0), 0.002};
    arc.pieces.push_back(
        {2, {0, 0, 0, 1, 1, 1}, {{100, 0, 0, 1}, {70, 70, 0, half}, {0, 100, 0, 1}}});
    arc.pieces.back().points[1] = {100 * half, 100 * half, 0, half};
    NamedCurve two{"section y=120", std::nullopt, 0};
    two.pieces.push_back({3,
                          {0, 0, 0, 0, 7.5, 20, 20, 20, 20},
                          {{4321.123456789, 1.0 / 3, 0, 1},
                           {4330, 2, 1e-7, 1},
                           {4340, -3, 4, 1},
                           {4350, 1, 2, 1},
                           {4351, 0, 0, 1}}});
    two.pieces.push_back({1, {0, 0, 5, 5}, {{4351, 0, 0, 1}, {4356, 0, 0, 1}}});
    NamedCurve line{"inflection of face 7", Rgb(0.3, 0.5, 0.7), 0.01};
    line.pieces.push_back({1, {0, 0, 1, 2, 2}, {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}}});
    set.curves = {arc, two, line};
    return set;
}

Vec3 place_of(const Vec4& p) {
    return {p.x / p.w, p.y / p.w, p.z / p.w};
}

/// Writes the set, reads it back and compares everything but deviations, which no file has.
void expect_round_trip(const CurveSet& set, ModelFormat format) {
    const fs::path path =
        fs::path(testing::TempDir()) / (format == ModelFormat::step ? "curves.step" : "curves.igs");
    std::ofstream(path, std::ios::binary) << curve_file(set, format);
    const CurveSet read = read_curves(path, format);
    ASSERT_EQ(read.curves.size(), set.curves.size());
    for (std::size_t c = 0; c < set.curves.size(); ++c) {
        const NamedCurve &before = set.curves[c], &after = read.curves[c];
        EXPECT_EQ(after.name, before.name);
        ASSERT_EQ(after.color.has_value(), before.color.has_value());
        if (before.color) {
            EXPECT_NEAR(after.color->r, before.color->r, 1e-6) << before.name;
            EXPECT_NEAR(after.color->g, before.color->g, 1e-6) << before.name;
            EXPECT_NEAR(after.color->b, before.color->b, 1e-6) << before.name;
        }
        ASSERT_EQ(after.pieces.size(), before.pieces.size()) << before.name;
        for (std::size_t p = 0; p < before.pieces.size(); ++p) {
            EXPECT_EQ(after.pieces[p].degree, before.pieces[p].degree);
            ASSERT_EQ(after.pieces[p].knots.size(), before.pieces[p].knots.size());
            ASSERT_EQ(after.pieces[p].points.size(), before.pieces[p].points.size());
            for (std::size_t i = 0; i < before.pieces[p].knots.size(); ++i)
                EXPECT_NEAR(after.pieces[p].knots[i], before.pieces[p].knots[i], 1e-9);
            for (std::size_t i = 0; i < before.pieces[p].points.size(); ++i)
                EXPECT_LT(
                    (place_of(after.pieces[p].points[i]) - place_of(before.pieces[p].points[i]))
                        .length(),
                    1e-9)
                    << before.name << ", point " << i;
        }
    }
    fs::remove(path);
}

TEST(CurveFiles, StepKeepsNamesColoursAndPoints) {
    expect_round_trip(sample_set(), ModelFormat::step);
}

TEST(CurveFiles, IgesKeepsNamesColoursAndPoints) {
    expect_round_trip(sample_set(), ModelFormat::iges);
}

TEST(CurveFiles, HoldNoTimeAndNoUser) {
    const std::string step = curve_file(sample_set(), ModelFormat::step);
    EXPECT_NE(step.find("FILE_NAME('hood','1970-01-01T00:00:00',('')"), std::string::npos)
        << step.substr(0, 400);
    const std::string iges = curve_file(sample_set(), ModelFormat::iges);
    EXPECT_NE(iges.find("15H19700101.000000,1E-07,4356.,,"), std::string::npos)
        << iges.substr(0, 900);
}

} // namespace
} // namespace keiko::cad
