#include "keiko/volumes/lit_volumes.h"

#include "keiko/volumes/opacity.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// Volumes of the same voxels, without sun and sky.
class Scene {
public:
    Scene(const std::vector<VolumeSpec>& specs, const VoxelGrid& grid)
        : volumes_(volumes_of(specs, grid)), lit_(volumes_, LightRig()) {}
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    FrontToBack along(const Segment& way) const { return lit_.along(way); }
    const SceneVolumes& volumes() const { return volumes_; }

private:
    static SceneVolumes volumes_of(const std::vector<VolumeSpec>& specs, const VoxelGrid& grid) {
        std::vector<Volume> volumes;
        for (const VolumeSpec& spec : specs) volumes.emplace_back(spec, grid, Job{});
        return SceneVolumes(std::move(volumes));
    }

    SceneVolumes volumes_;
    LitVolumes lit_;
};

/// A box from 0 to 30, 20 and 10 mm, of the value 1.
VoxelGrid uniform_box() {
    return {{4, 3, 2}, std::vector<float>(24, 1.0F)};
}

VolumeSpec box_spec(double per_m, const Rgb& emits) {
    VolumeSpec spec;
    spec.voxels.spacing = Vec3(10);
    spec.extinction.points = {{0, per_m}};
    spec.emits.points = {{0, emits}};
    return spec;
}

TEST(LitVolumes, OfUniformVoxelsPassWhatTheChordLeaves) {
    const Scene scene({box_spec(50, Rgb(7))}, uniform_box());
    const Segment through{Vec3(-5, 10, 5), Vec3(100, 10, 5)};
    const FrontToBack all = scene.along(through);
    EXPECT_NEAR(all.opacity, 1 - std::exp(-0.05 * 30), 1e-7); // extinctions are floats
    EXPECT_NEAR(all.light.g, 7 * all.opacity, 1e-12);
    // A segment that ends inside, at a surface say, and one that begins there.
    EXPECT_NEAR(scene.along({Vec3(-5, 10, 5), Vec3(12.345, 10, 5)}).opacity,
                1 - std::exp(-0.05 * 12.345), 1e-7);
    EXPECT_NEAR(scene.along({Vec3(12.345, 10, 5), Vec3(99, 10, 5)}).opacity,
                1 - std::exp(-0.05 * (30 - 12.345)), 1e-7);
    EXPECT_NEAR(scene.along({Vec3(15, 10, 40), Vec3(15, 10, -40)}).opacity,
                1 - std::exp(-0.05 * 10), 1e-7);
}

TEST(LitVolumes, AreMissedByRaysBesideThem) {
    const Scene scene({box_spec(50, Rgb(7))}, uniform_box());
    for (const Segment& way :
         {Segment{Vec3(-5, 21, 5), Vec3(100, 21, 5)}, Segment{Vec3(-5, 10, 5), Vec3(-1, 10, 5)},
          Segment{Vec3(50, 10, 5), Vec3(31, 10, 5)}, Segment{Vec3(-5, -10, 5), Vec3(10, -1, 5)}})
        EXPECT_EQ(scene.along(way).opacity, 0);
}

TEST(LitVolumes, ThatOverlapAddTheirDepthsAndShareTheLight) {
    const VolumeSpec red = box_spec(30, Rgb(9, 0, 0)), blue = box_spec(60, Rgb(0, 0, 9));
    const FrontToBack both =
        Scene({red, blue}, uniform_box()).along({Vec3(-5, 10, 5), Vec3(100, 10, 5)});
    EXPECT_NEAR(both.opacity, 1 - std::exp(-0.09 * 30), 1e-7);
    EXPECT_NEAR(both.light.r, 3 * both.opacity, 1e-6);
    EXPECT_NEAR(both.light.b, 6 * both.opacity, 1e-6);
}

TEST(LitVolumes, BehindEachOtherAreSeenFromTheFront) {
    VolumeSpec front = box_spec(30, Rgb(9, 0, 0)), back = box_spec(60, Rgb(0, 0, 9));
    front.placement = Affine::translate(Vec3(-50, 0, 0));
    const FrontToBack both =
        Scene({back, front}, uniform_box()).along({Vec3(-90, 10, 5), Vec3(100, 10, 5)});
    const double passed = std::exp(-0.03 * 30);
    EXPECT_NEAR(both.light.r, 9 * (1 - passed), 1e-6);
    EXPECT_NEAR(both.light.b, 9 * passed * (1 - std::exp(-0.06 * 30)), 1e-6);
}

/// A ball of values from 1 at its middle to 0, with a ripple, in a cube of 31 mm.
VoxelGrid rippled_ball() {
    std::vector<float> values;
    for (int z = 0; z < 32; ++z)
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) {
                const Vec3 away = Vec3(x, y, z) - Vec3(15.5);
                const double ripple = 0.05 * std::sin(x) * std::sin(y) * std::sin(z);
                values.push_back(static_cast<float>(
                    std::max(0.0, 1 - away.length() / 14 + ripple * away.length() / 14)));
            }
    return {{32, 32, 32}, std::move(values)};
}

/// Looks in which rays pass a cloud, regions and shaded surfaces.
std::vector<VolumeSpec> looks() {
    VolumeSpec cloud, regions, surface;
    cloud.extinction.points = {{0, 0}, {1, 300}};
    cloud.emits.points = {{0, Rgb(0)}, {1, Rgb(1)}};
    regions.regions = {{.low = 0.2, .high = 0.9, .opacity_low = 1, .opacity_high = 3}};
    surface.contours = {{.value = 0.5, .thickness = 2, .opacity = 0.9}};
    for (VolumeSpec* spec : {&regions, &surface}) {
        spec->shading = VolumeShading();
        spec->shading->luminance = 1; // of an ambient, a diffuse and a specular share of 1 in all
        spec->shading->light = Vec3(1, -2, 3);
        spec->color.points = {{0, Rgb(0.2)}, {1, Rgb(1)}};
    }
    return {cloud, regions, surface};
}

std::vector<Segment> random_ways(int count) {
    test::Random random(42);
    const auto coordinate = [&] { return test::uniform(random, 0, 31); };
    std::vector<Segment> ways;
    for (int i = 0; i < count; ++i) {
        const Vec3 to(coordinate(), coordinate(), coordinate());
        const Vec3 from(coordinate() - 60, coordinate(), coordinate());
        ways.push_back({from, from + (to - from) * 3});
    }
    return ways;
}

TEST(LitVolumes, DoNotDependOnTheStepByMoreThanALevelOfDisplays) {
    for (VolumeSpec spec : looks()) {
        const Scene usual({spec}, rippled_ball());
        double worst = 0;
        for (const double step : {0.25, 0.1, 0.03}) {
            spec.step = step;
            const Scene other({spec}, rippled_ball());
            for (const Segment& way : random_ways(300)) {
                const FrontToBack a = usual.along(way), b = other.along(way);
                worst = std::max(
                    {worst, std::abs(a.light.g - b.light.g), std::abs(a.opacity - b.opacity)});
            }
        }
        RecordProperty("worst", std::to_string(worst));
        EXPECT_LT(worst, 1.0 / 255);
    }
}

/// Sum along a ray by samples of `step`, with neither clear blocks nor an early end.
FrontToBack brute_force(const VolumeSpec& spec, const VoxelGrid& grid, const Segment& way,
                        double step) {
    const Volume volume(spec, grid, {});
    const Vec3 direction = (way.b - way.a).normalized();
    FrontToBack sum;
    for (double t = step / 2; t < (way.b - way.a).length(); t += step) {
        const Vec3 place = way.a + direction * t;
        const Vec3 low(0), high(31);
        if (!Box3{low, high}.contains(place)) continue;
        const GridCell cell = grid_cell(place, grid.nodes());
        const double depth = trilinear(cell.t, [&](std::size_t x, std::size_t y, std::size_t z) {
            const std::size_t i = cell.node[0] + x, j = cell.node[1] + y, k = cell.node[2] + z;
            return node_depth(spec, 1, static_cast<double>(grid.values()[grid.index(i, j, k)]),
                              grid.node_gradient(i, j, k).length());
        });
        sum.add(volume.luminance(place, -direction, t), opacity_of_depth(depth * step));
    }
    return sum;
}

TEST(LitVolumes, AgreeWithBruteForce) {
    const VoxelGrid grid = rippled_ball();
    for (const VolumeSpec& spec : looks()) {
        const Scene scene({spec}, grid);
        for (const Segment& way : random_ways(40)) {
            const FrontToBack cast = scene.along(way), all = brute_force(spec, grid, way, 0.02);
            EXPECT_NEAR(cast.light.g, all.light.g, 1.0 / 255);
            EXPECT_NEAR(cast.opacity, all.opacity, 1.0 / 255);
        }
    }
}

TEST(LitVolumes, MoveAndGrowWithTheirPlacement) {
    VolumeSpec spec = looks().back();
    const Scene still({spec}, rippled_ball());
    const Affine motion = Affine::translate(Vec3(100, -20, 7)) *
                          Affine::rotate(Vec3(1, 2, 3), 0.7) * Affine::scale(2.5);
    spec.placement = motion;
    spec.shading->light = motion.vector(*spec.shading->light);
    const Scene moved({spec}, rippled_ball());
    for (const Segment& way : random_ways(30)) {
        const FrontToBack a = still.along(way);
        const FrontToBack b = moved.along({motion.point(way.a), motion.point(way.b)});
        EXPECT_NEAR(a.opacity, b.opacity, 1e-5); // extinctions are floats
        EXPECT_NEAR(a.light.g, b.light.g, 1e-5);
    }
    EXPECT_TRUE(
        moved.volumes().boxes().front().padded(1e-9).contains(motion.point(Vec3(31, 0, 31))));
}

} // namespace
} // namespace keiko
