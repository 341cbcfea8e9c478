#include "keiko/texels/texel_shell.h"

#include "keiko/texels/fibre_blocks.h"
#include "keiko/texels/scene_texels.h"

#include "tests/support/model_builder.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

TexelShell shell_of(const SurfaceModel& model, const TexelSpec& spec) {
    return {model, 0, 0, spec, std::make_shared<const TexelBlock>(fibre_block(spec))};
}

TexelSpec short_fur(double thickness) {
    TexelSpec spec;
    spec.thickness = thickness, spec.voxels = 16;
    spec.fibres = FurSpec{.length = thickness};
    return spec;
}

double length_of(const std::vector<ShellRun>& runs) {
    double sum = 0;
    for (const ShellRun& run : runs) sum += run.end - run.begin;
    return sum;
}

TEST(TexelShell, OfAPlateIsCrossedFromTheTopToTheFoot) {
    test::ModelBuilder builder;
    builder.plane(Vec3(0), Vec3(400, 0, 0), Vec3(0, 300, 0));
    const SurfaceModel model = builder.build();
    const TexelSpec spec = short_fur(12);
    const TexelShell shell = shell_of(model, spec);
    const Segment aslant{Vec3(100, 100, 112), Vec3(203, 151, 0)};
    const std::vector<ShellRun> runs = shell.runs(aslant);
    const double length = (aslant.b - aslant.a).length();
    EXPECT_NEAR(length_of(runs), length * 12 / 112, 1e-9);
    EXPECT_NEAR(runs.front().begin, length * 100 / 112, 1e-9);
    for (std::size_t i = 1; i < runs.size(); ++i) EXPECT_NEAR(runs[i].begin, runs[i - 1].end, 1e-9);
    const Vec3 first = runs.front().at(runs.front().begin), last = runs.back().at(runs.back().end);
    EXPECT_NEAR(first.z, 1, 1e-9);
    EXPECT_NEAR(last.z, 0, 1e-9);
    // 20 and 15 blocks of 20 mm.
    const Vec3 place = shell.block_place(*runs.back().part, last);
    EXPECT_NEAR(place.x, 203.0 / 20, 1e-9);
    EXPECT_NEAR(place.y, 151.0 / 20, 1e-9);
    EXPECT_TRUE(shell.runs({Vec3(0, 0, 13), Vec3(400, 300, 13)}).empty());
    EXPECT_NEAR(length_of(shell.runs({Vec3(-9, 100, 6), Vec3(409, 100, 6)})), 400, 1e-9);
}

TEST(TexelShell, OfABallHasTheChordsBetweenTwoSpheres) {
    const SurfaceModel model =
        test::ShapeBuilder().face(test::sphere(Vec3(10, 20, 30), 100)).model();
    const TexelSpec spec = short_fur(15);
    const TexelShell shell = shell_of(model, spec);
    test::Random random(1);
    for (int i = 0; i < 200; ++i) {
        const Vec3 outwards = test::random_direction(random);
        const Vec3 aside = outwards.cross(test::random_direction(random)).normalized();
        const double past = test::uniform(random, 0, 113);
        const Vec3 middle = Vec3(10, 20, 30) + outwards * past;
        const auto chord = [&](double r) {
            return 2 * std::sqrt(std::max(0.0, r * r - past * past));
        };
        // The shell is flat within a hundredth of its thickness; lines that graze it see more.
        const double most = chord(115) - chord(115 - 0.3) + chord(100.3) - chord(100);
        EXPECT_NEAR(length_of(shell.runs({middle - aside * 200, middle + aside * 200})),
                    chord(115) - chord(100), most + 0.1)
            << past;
    }
}

TEST(TexelShell, FollowsASurfaceOfStraightLinesThatIsTwisted) {
    test::ModelBuilder builder; // z = x y / 100, with x and y from 0 to 200 mm
    builder.patch(1, 1, {Vec3(0), Vec3(0, 200, 0), Vec3(200, 0, 0), Vec3(200, 200, 400)});
    const TexelSpec spec = short_fur(5);
    const TexelShell shell = shell_of(builder.build(), spec);
    EXPECT_FALSE(shell.lattice().limited);
    for (double x = 41.7; x < 160; x += 5.3) {
        const double y = 201.3 - x, foot = x * y / 100;
        const auto runs = shell.runs({Vec3(x, y, foot + 100), Vec3(x, y, foot - 100)});
        ASSERT_FALSE(runs.empty());
        EXPECT_NEAR(runs.back().end, 100, 0.06 * 2.5) << x; // in z: its slope is below 2.3
    }
}

TEST(TexelShell, StepsOverNoKnotSpan) {
    NurbsSurface waves; // 200 quadratic spans along u, 10 mm high, 10 mm long
    waves.degree_u = 2, waves.degree_v = 1;
    constexpr int points = 202;
    waves.knots_u = {0, 0};
    for (int i = 0; i <= points - 2; ++i) waves.knots_u.push_back(i);
    waves.knots_u.insert(waves.knots_u.end(), 2, points - 2);
    waves.knots_v = {0, 0, 1, 1};
    for (int i = 0; i < points; ++i)
        for (const double y : {0.0, 100.0}) {
            const bool inside = i > 77 && i < 83;
            waves.points.emplace_back(5.0 * i, y, inside ? (i % 2 ? 10.0 : -10.0) : 0, 1);
        }
    test::ModelBuilder builder;
    builder.nurbs(waves);
    const TexelSpec spec = short_fur(5);
    const TexelShell shell = shell_of(builder.build(), spec);
    EXPECT_EQ(shell.lattice().cells_u, 256);
    EXPECT_TRUE(shell.lattice().limited);
}

TEST(TexelShell, IsAsDeepOutwardsAsAlongTheWholeWayOutHoweverSmallItsVoxels) {
    test::ModelBuilder builder;
    builder.plane(Vec3(0), Vec3(100, 0, 0), Vec3(0, 100, 0));
    Material fur;
    TexelSpec spec;
    spec.fibres = FurSpec{.hairs = 1000, .width = 0.02, .block = 2};
    fur.texels = spec; // 20 mm of voxels of 0.03 mm
    const SceneTexels texels(builder.build(), std::vector{fur});
    double outwards = 0, whole = 0;
    for (double x = 40; x < 60; x += 0.37) {
        const Segment down{Vec3(x, 48.7, 30), Vec3(x, 48.7, 0)};
        const ShellRun run = texels.shells().front().runs(down).back();
        outwards += texels.shells().front().depth_outwards(*run.part, run.at(run.end),
                                                           Vec3(0, 0, 1), 1, 1e3);
        whole += texels.optical_depth(down, 1e3);
    }
    EXPECT_GT(whole, 1);
    EXPECT_NEAR(outwards / whole, 1, 0.02);
}

TEST(TexelShell, EndsAtTrimCurves) {
    test::ModelBuilder builder;
    builder.plane(Vec3(0), Vec3(400, 0, 0), Vec3(0, 400, 0));
    builder.polygon({Vec2(0.1, 0.1), Vec2(0.9, 0.1), Vec2(0.1, 0.9)});
    const SurfaceModel model = builder.build();
    Material fur;
    fur.texels = short_fur(12);
    const SceneTexels texels(model, std::vector{fur});
    const auto depth = [&](double x, double y) {
        double sum = 0; // over more than a block, since hairs are thin
        for (double off = 0; off < 24; ++off)
            sum += texels.optical_depth({Vec3(x + off, y, 20), Vec3(x + off, y + 5, 0)}, 1e3);
        return sum;
    };
    EXPECT_GT(depth(100, 100), 1);
    EXPECT_GT(depth(150, 190), 1);
    EXPECT_EQ(depth(210, 210), 0);
    EXPECT_EQ(depth(10, 10), 0);
}

TEST(SceneTexels, GoWithTheInstancesOfAFace) {
    test::ModelBuilder builder;
    builder.plane(Vec3(0), Vec3(40, 0, 0), Vec3(0, 40, 0));
    builder.instance(Affine::translate(Vec3(0, 0, 100)));
    builder.instance(Affine::rotate(Vec3(1, 0, 0), 3.14159265358979));
    Material fur;
    fur.texels = short_fur(8);
    const SceneTexels texels(builder.build(), std::vector{fur});
    ASSERT_EQ(texels.boxes().size(), 2U);
    EXPECT_NEAR(texels.boxes()[0].lower.z, 100, 1e-9);
    EXPECT_NEAR(texels.boxes()[0].upper.z, 108, 1e-9);
    EXPECT_NEAR(texels.boxes()[1].lower.z, -8, 1e-9);
    EXPECT_NEAR(texels.boxes()[1].upper.z, 0, 1e-9);
}

} // namespace
} // namespace keiko
