#include "keiko/texels/lit_texels.h"

#include "keiko/texels/fibre_blocks.h"
#include "keiko/texels/fibre_reflection.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

/// A plate of 400 mm with texels, at z = 0.
SceneTexels plate_with(const TexelSpec& spec) {
    test::ModelBuilder builder;
    builder.plane(Vec3(0), Vec3(400, 0, 0), Vec3(0, 400, 0));
    Material material;
    material.texels = spec;
    return {builder.build(), std::vector{material}};
}

TexelSpec fur_of(double hairs) {
    TexelSpec spec;
    spec.thickness = 12, spec.voxels = 32;
    spec.diffuse = Rgb(0.6, 0.5, 0.4), spec.specular = Rgb(0.2), spec.exponent = 10;
    spec.fibres = FurSpec{.hairs = hairs, .length = 12};
    return spec;
}

LightsAt light_from(const Vec3& towards, double lx) {
    return [=](const Vec3&) { return std::vector{ArrivingLight{towards.normalized(), Rgb(lx)}}; };
}

FrontToBack sum_of(const std::vector<TexelLayer>& layers) {
    FrontToBack sum;
    for (const TexelLayer& layer : layers) sum.add(layer.sum);
    return sum;
}

TEST(LitTexels, OfThinFurInUniformLightHaveTheirShareOfIt) {
    TexelSpec thin = fur_of(5);
    std::get<FurSpec>(thin.fibres).width = 0.01;
    const SceneTexels texels = plate_with(thin);
    const LitTexels lit(
        texels, [](const Vec3&) { return std::vector<ArrivingLight>(); }, Rgb(200));
    FrontToBack all;
    double light = 0, opacity = 0;
    for (double x = 200; x < 220; x += 0.5) {
        const FrontToBack sum = sum_of(lit.along({Vec3(x, 200, 20), Vec3(x, 230, 0)}, {}));
        light += sum.light.r, opacity += sum.opacity;
    }
    ASSERT_GT(opacity, 0);
    EXPECT_NEAR(light / opacity, 200 * 0.8, 2);
}

/// Light and opacity along a segment over the plate, by short steps through the block itself.
FrontToBack brute_force(const TexelSpec& spec, const Segment& segment, const Vec3& towards,
                        double lx) {
    const TexelBlock block = fibre_block(spec);
    const auto place = [](const Vec3& p) { return Vec3(p.x / 20, p.y / 20, p.z / 12); };
    const Vec3 way = segment.b - segment.a, eye = -way.normalized();
    constexpr int steps = 4000, shadow_steps = 400;
    const double step = way.length() / steps;
    FrontToBack sum;
    for (int i = 0; i < steps; ++i) {
        const Vec3 at = segment.at((i + 0.5) / steps);
        if (!(at.z > 0 && at.z < 12)) continue;
        const Fibres fibres = block.at(place(at), 0);
        if (!(fibres.extinction > 0)) continue;
        const double out = (12 - at.z) / towards.z / shadow_steps;
        double depth = 0;
        for (int k = 0; k < shadow_steps; ++k)
            depth += block.at(place(at + towards * ((k + 0.5) * out)), 0).extinction * out;
        const Vec3 fibre = fibres.direction.normalized();
        const Rgb own = spec.diffuse * fibre_diffuse(fibre, towards) * fibre_diffuse_scale() +
                        spec.specular *
                            fibre_specular(fibre_cone_cosine(fibre, towards, eye), spec.exponent) *
                            fibre_highlight_scale(spec.exponent);
        sum.add(own * lx * std::exp(-depth), -std::expm1(-fibres.extinction * step));
    }
    return sum;
}

TEST(LitTexels, AgreeWithShortStepsThroughTheBlock) {
    const TexelSpec spec = fur_of(60);
    const SceneTexels texels = plate_with(spec);
    const Vec3 towards = Vec3(0.5, -0.3, 0.8).normalized();
    const LitTexels lit(texels, light_from(towards, 1000), Rgb(0));
    double error = 0, light = 0, most = 0;
    for (int i = 0; i < 40; ++i) {
        const double x = 190 + 1.7 * i;
        const Segment ray{Vec3(x, 180, 40), Vec3(x - 5, 215, 0)};
        const FrontToBack found = sum_of(lit.along(ray, {}));
        const FrontToBack expected = brute_force(spec, ray, towards, 1000);
        EXPECT_NEAR(found.opacity, expected.opacity, 0.01) << i;
        error += std::abs(found.light.g - expected.light.g), light += expected.light.g;
        most = std::max(most, expected.light.g);
        EXPECT_NEAR(found.light.g, expected.light.g, 0.1 * most) << i;
    }
    // Shadows are those of voxels twice as long.
    EXPECT_LT(error / light, 0.04);
}

TEST(LitTexels, OfWideRaysAreTheMeanOfNarrowOnes) {
    const SceneTexels texels = plate_with(fur_of(20));
    const LitTexels lit(texels, light_from(Vec3(0.3, 0, 1), 1000), Rgb(10));
    const auto along = [&](const Vec3& at, const std::optional<RayDifferentials>& spread) {
        return sum_of(lit.along({at + Vec3(0, 0, 20), at + Vec3(0, 7, 0)}, spread));
    };
    double narrow = 0;
    constexpr int side = 40;
    for (int i = 0; i < side * side; ++i)
        narrow += along(Vec3(200 + 0.5 * (i % side), 200 + 0.5 * (i / side), 0), {}).light.g;
    narrow /= side * side;
    const RayDifferentials wide{Vec3(10, 0, 0), Vec3(0, 10, 0), Vec3(0), Vec3(0)};
    const double mean = along(Vec3(210, 210, 0), wide).light.g;
    EXPECT_NEAR(mean / narrow, 1, 0.25); // means hide more than what they are means of
}

TEST(LitTexels, AreNotSteppedOverByWideRays) {
    TexelSpec cloth;
    cloth.thickness = 2, cloth.voxels = 64;
    cloth.fibres = ClothSpec{.spacing = 16};
    const SceneTexels texels = plate_with(cloth);
    const LitTexels lit(texels, light_from(Vec3(0, 0, 1), 1000), Rgb(0));
    const RayDifferentials wide{Vec3(40, 0, 0), Vec3(0, 40, 0), Vec3(0), Vec3(0)};
    for (int i = 0; i < 20; ++i) {
        const Segment down{Vec3(200 + i, 200, 10 + 0.1 * i), Vec3(200 + i, 203, -0.1)};
        EXPECT_GT(sum_of(lit.along(down, wide)).opacity, 0.9) << i;
    }
}

TEST(LitTexels, HaveNoLightThroughTheirBody) {
    const SceneTexels texels = plate_with(fur_of(60));
    const LitTexels lit(texels, light_from(Vec3(0.3, 0, -1), 1e6), Rgb(0));
    const FrontToBack sum = sum_of(lit.along({Vec3(200, 180, 40), Vec3(195, 215, 0)}, {}));
    EXPECT_GT(sum.opacity, 0);
    EXPECT_EQ(sum.light, Rgb(0));
}

TEST(LitTexels, KeepTheOrderOfLayersAlongARay) {
    test::ModelBuilder builder;
    builder.plane(Vec3(0), Vec3(100, 0, 0), Vec3(0, 100, 0));
    builder.plane(Vec3(0, 0, 50), Vec3(100, 0, 0), Vec3(0, 100, 0));
    Material material;
    material.texels = fur_of(5);
    const SceneTexels texels(builder.build(), std::vector{material, material});
    const LitTexels lit(texels, light_from(Vec3(0, 0, 1), 1000), Rgb(0));
    const auto layers = lit.along({Vec3(50, 50, 100), Vec3(50, 60, -1)}, {});
    ASSERT_EQ(layers.size(), 2U);
    EXPECT_LT(layers[0].end, layers[1].begin);
    EXPECT_NEAR(layers[0].begin, 38 * std::sqrt(1 + 100.0 / 101 / 101), 1e-2);
}

} // namespace
} // namespace keiko
