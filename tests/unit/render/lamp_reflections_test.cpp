#include "keiko/render/reflection/lamp_reflections.h"

#include "keiko/intersect/hit/reflect_ray.h"

#include "tests/unit/render/stage.h"
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

using namespace keiko;
using test::dome;
using test::Stage;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The pixels of the stage's picture, `size` times as wide and high, as a grid of reflected rays.
class PictureGrid {
public:
    PictureGrid(const Stage& stage, double size)
        : width(static_cast<int>(stage.camera.width / size)),
          height(static_cast<int>(stage.camera.height / size)),
          grid(width, height),
          rays(grid.size()) {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto w = static_cast<std::size_t>(width);
            Ray eye = stage.camera.ray((static_cast<double>(i % w) + 0.5) * size,
                                       (static_cast<double>(i / w) + 0.5) * size);
            eye.differentials = eye.differentials->scaled(size);
            const auto hit = stage.tracer.nearest(eye);
            if (!hit) continue;
            rays[i] = reflect_ray(eye, *hit);
            grid.set_begin(i, {hit->position, hit->normal, 0});
            grid.set(i, *rays[i]);
        }
        grid.join();
    }

    int width, height;
    ReflectedGrid grid;
    std::vector<std::optional<Ray>> rays;
};

/// A row on the right that is visible beyond the end of the stage's own, and in places before it.
CPlane wall() {
    CPlane plane;
    plane.origin = {900, -2000, 300};
    plane.u = {0, 6000, 0};
    plane.v = {300, 0, 2500};
    plane.lamps = 5;
    plane.diameter = 90;
    plane.luminous_caps = true;
    return plane;
}

/// Beside the wall, in the same plane except for rounding.
CPlane along_the_wall() {
    CPlane plane = wall();
    plane.origin += plane.v * (1.0 / 3) + plane.u * 0.7;
    plane.v = plane.v * 0.3;
    return plane;
}

std::vector<Stage> stages() {
    std::vector<Stage> all;
    all.emplace_back(dome());
    all.emplace_back(dome());
    std::get<CPlane>(all.back().rig.sources[0]).mirror = MirrorModel::flat;
    std::get<CPlane>(all.back().rig.sources[0]).lamps = 60; // too fine for wide pixels
    all.emplace_back(dome());
    all.back().rig.sources.push_back(wall());
    all.emplace_back(dome());
    all.back().rig.sources = {along_the_wall(), wall(), along_the_wall()};
    all.emplace_back(dome());
    std::get<CPlane>(all.back().rig.sources[0]).diameter = 300; // strips overlap
    std::get<CPlane>(all.back().rig.sources[0]).luminous_caps = true;
    all.emplace_back(test::flat_plate());
    std::get<CPlane>(all.back().rig.sources[0]).mirror = MirrorModel::exact;
    return all;
}

/// Kinds of pixels that were compared.
struct Kinds {
    int dark = 0, lit = 0, partly = 0, discontinuous = 0, alone = 0;

    void count(const PixelMirror& mirror, bool amid) {
        const double coverage = mirror.lamps.coverage;
        (coverage == 0 ? dark : lit) += 1;
        partly += coverage > 0 && coverage < 1;
        discontinuous += mirror.discontinuous;
        alone += !amid;
    }
};

void expect_same(const PixelMirror& is, const PixelMirror& plain) {
    ASSERT_EQ(is.plane.has_value(), plain.plane.has_value());
    ASSERT_EQ(is.discontinuous, plain.discontinuous);
    // Means over up to 64 parts of a pixel are summed up in another order.
    ASSERT_NEAR(is.lamps.coverage, plain.lamps.coverage, 1e-14);
    ASSERT_NEAR(is.lamps.luminance.g, plain.lamps.luminance.g, 1e-10);
    if (!is.plane) return;
    ASSERT_EQ(is.plane->number, plain.plane->number);
    ASSERT_EQ(is.plane->frame, plain.plane->frame);
    ASSERT_EQ(is.plane->at.t, plain.plane->at.t);
    ASSERT_EQ(is.plane->at.u, plain.plane->at.u);
    ASSERT_EQ(is.plane->at.v, plain.plane->at.v);
    ASSERT_EQ(is.plane->at.direction, plain.plane->at.direction);
}

void compare(const RigPlanes& planes, const LampKernels& kernels, const PictureGrid& picture,
             bool tells_torn, double t_max, Kinds& kinds) {
    LampReflections stripes(planes, picture.grid, kernels, tells_torn);
    for (std::size_t i = 0; i < picture.rays.size(); ++i) {
        if (!picture.rays[i]) continue;
        const Ray& ray = *picture.rays[i];
        const PixelMirror plain = mirror_of(planes, ray, picture.grid.around(i), t_max, tells_torn);
        PixelMirror is;
        stripes.find(i, t_max, is);
        ASSERT_NO_FATAL_FAILURE(expect_same(is, plain)) << "place " << i;
        kinds.count(plain, picture.grid.is_amid(i));
    }
}

} // namespace

// Rows of one and two kinds, on every instruction set. Pixels are from tiny to so large that their
// images are bent and reach horizons. What pixels side by side see is what each sees alone.
TEST(LampReflections, AreThoseOfEachPixelByItself) {
    Kinds kinds;
    for (const SimdLevel level : simd_levels()) {
        const LampKernels kernels = lamp_kernels(level);
        SCOPED_TRACE(name_of(level));
        for (const Stage& stage : stages())
            for (const double size : {0.9, 2.7, 6.0}) {
                const PictureGrid picture(stage, size);
                const RigPlanes planes(stage.rig);
                for (const bool tells_torn : {false, true})
                    for (const double t_max : {infinity, 2300.0})
                        ASSERT_NO_FATAL_FAILURE(
                            compare(planes, kernels, picture, tells_torn, t_max, kinds));
            }
    }
    EXPECT_GT(kinds.dark, 1000);
    EXPECT_GT(kinds.lit, 1000);
    EXPECT_GT(kinds.partly, 1000);
    EXPECT_GT(kinds.discontinuous, 20);
    EXPECT_GT(kinds.alone, 1000);
}

// What is left out for being dark would have been dark to the last bit: no lamp is in any part of
// it, into however many it would have been cut.
TEST(LampReflections, LeaveOutNoPixelWithALampInIt) {
    int left_out = 0;
    for (const SimdLevel level : simd_levels()) {
        const LampKernels kernels = lamp_kernels(level);
        for (const Stage& stage : stages())
            for (const double size : {0.9, 2.7, 6.0}) {
                const PictureGrid picture(stage, size);
                const RigPlanes planes(stage.rig);
                const RigPlanes::Plane& plane = planes.planes().back();
                const StripeRow row{plane.frame, plane.mirror == MirrorModel::flat
                                                     ? MirrorModel::flat
                                                     : MirrorModel::tube};
                const auto width = static_cast<std::size_t>(picture.width);
                for (std::size_t i = 0; i < picture.rays.size(); ++i) {
                    if (!picture.grid.is_amid(i)) continue;
                    LampCoverageBatch looks;
                    kernels.look(row, picture.grid.rays(), i, width, false, looks);
                    if ((looks.missed & 1) == 0) continue;
                    ++left_out;
                    for (int side = 1; side <= 8; ++side)
                        ASSERT_EQ(kernels.coverage_of_parts(row, picture.grid.rays(), i, width,
                                                            {side, infinity}),
                                  0)
                            << i << " in " << side;
                }
            }
    }
    EXPECT_GT(left_out, 5000);
}

/// A pixel has the same bits whichever pixel the vector begins at.
TEST(LampReflections, HaveTheSameBitsInAnyCompany) {
    const Stage stage(dome());
    const PictureGrid picture(stage, 2.7);
    const RigPlanes planes(stage.rig);
    const LampKernels kernels = lamp_kernels();
    LampReflections in_order(planes, picture.grid, kernels, true);
    for (std::size_t i = 0; i < picture.rays.size(); ++i) {
        if (!picture.rays[i]) continue;
        LampReflections alone(planes, picture.grid, kernels, true);
        PixelMirror a, b;
        in_order.find(i, infinity, a);
        alone.find(i, infinity, b);
        EXPECT_EQ(a.lamps.coverage, b.lamps.coverage) << i;
        EXPECT_EQ(a.discontinuous, b.discontinuous) << i;
        ASSERT_EQ(a.plane.has_value(), b.plane.has_value()) << i;
        if (a.plane && b.plane && a.plane->at.v != b.plane->at.v) ADD_FAILURE() << i;
    }
}
