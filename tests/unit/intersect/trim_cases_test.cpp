#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/random_surfaces.h"
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace keiko {
namespace {

using namespace test;

/// A sheet of 4 x 4 spans over the square [0, 1]^2 (x and y are the face's parameters), so that
/// trim curves run along and across span borders.
std::vector<PatchData> sheet() {
    std::vector<PatchData> patches;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            patches.push_back(rectangle(0.25 * i, 0.25 * (i + 1), 0.25 * j, 0.25 * (j + 1), 0));
    return patches;
}

LoopData frame() {
    return polygon({Vec2(0), Vec2(1, 0), Vec2(1), Vec2(0, 1)});
}

/// Neighbouring spans overlap by up to 1e-11 of their width, lest a ray slip through between them.
/// A hit in there is put on the span's own border; a trim curve that runs along that border is
/// decided for the moved place.
constexpr double overlap = 1e-11;

/// Looks down on the trimmed sheet where `material` knows the answer: negative off the material,
/// positive on it, 0 where either will do. Places beside the `marks`, at distances from 1e-1 to
/// 1e-11, and at random.
void expect_material(const std::vector<LoopData>& loops,
                     const std::function<double(const Vec2&)>& material,
                     const std::vector<Vec2>& marks) {
    const SurfaceModel model = ShapeBuilder().face(sheet(), loops).model();
    const Tracer tracer(model), clipping(model, {.clipping_only = true});
    Random random(121);
    for (int i = 0; i < 20000; ++i) {
        Vec2 p(uniform(random, 0, 1), uniform(random, 0, 1));
        if (i % 2 == 0) {
            const double turn = std::floor(uniform(random, 0, 16)) / 8 * std::numbers::pi;
            const double away = std::pow(10, -uniform(random, 1, 11));
            p = marks[pick(random, marks.size())] + Vec2(std::cos(turn), std::sin(turn)) * away;
        }
        const double expected = material(p);
        if (!(std::abs(expected) > overlap)) continue;
        const Ray ray = ray_through(Vec3(p.x, p.y, 3), Vec3(0, 0, -1));
        ASSERT_EQ(tracer.any(ray), expected > 0) << i << std::hexfloat << ' ' << p;
        ASSERT_LE(tracer.all(ray).size(), 1u) << i << ' ' << p;
        if (i % 8 == 0) {
            ASSERT_EQ(clipping.any(ray), expected > 0) << i << ' ' << p;
        }
    }
}

/// Beyond a circle; the square's own border too.
double outside_circle(const Vec2& p, const Vec2& middle, double radius) {
    return (p - middle).length() - radius;
}
double inside_frame(const Vec2& p) {
    return std::min(std::min(p.x, 1 - p.x), std::min(p.y, 1 - p.y));
}

/// Circles are tangent to lines of constant u and v at four places each; here on span borders.
TEST(TrimCurves, TangentToIsoLinesCutWhereTheyShould) {
    const Vec2 middle(0.5, 0.5);
    expect_material(
        {frame(), circle(middle, 0.25)},
        [&](const Vec2& p) { return std::min(inside_frame(p), outside_circle(p, middle, 0.25)); },
        {Vec2(0.25, 0.5), Vec2(0.75, 0.5), Vec2(0.5, 0.25), Vec2(0.5, 0.75)});
}

/// A drop whose two parabolas y = 0.3 +- (x - 0.3)^2 leave its tip in the same direction.
TEST(TrimCurves, WithACuspCutWhereTheyShould) {
    const auto side = [](double sign) {
        return std::vector<Vec3>{Vec3(0.3, 0.3, 1), Vec3(0.5, 0.3, 1),
                                 Vec3(0.7, 0.3 + sign * 0.16, 1)};
    };
    std::vector<Vec3> back = side(1);
    std::reverse(back.begin(), back.end());
    const LoopData drop{{side(-1), no_index}, line({0.7, 0.14}, {0.7, 0.46}), {back, no_index}};
    const auto material = [](const Vec2& p) {
        const double x = p.x - 0.3, above = x * x - std::abs(p.y - 0.3);
        return std::min(inside_frame(p), -std::min(std::min(above, 0.7 - p.x), x));
    };
    expect_material({frame(), drop}, material,
                    {Vec2(0.3, 0.3), Vec2(0.7, 0.14), Vec2(0.3001, 0.3)});
}

/// Two holes that touch each other on a span border, and one that touches the outer border.
TEST(TrimLoops, ThatTouchCutWhereTheyShould) {
    const Vec2 a(0.25, 0.5), b(0.75, 0.5), c(0.5, 0.125);
    const auto material = [&](const Vec2& p) {
        return std::min({inside_frame(p), outside_circle(p, a, 0.25), outside_circle(p, b, 0.25),
                         outside_circle(p, c, 0.125)});
    };
    // The places where loops touch, and the ends of the holes at the sheet's border.
    expect_material({frame(), circle(a, 0.25), circle(b, 0.25), circle(c, 0.125)}, material,
                    {Vec2(0.5, 0.5), Vec2(0.5, 0), Vec2(0, 0.5), Vec2(1, 0.5)});
}

/// Holes and islands far smaller than any pixel, on a span corner and inside a span.
TEST(TrimLoops, BelowAPixelCutWhereTheyShould) {
    for (const double radius : {1e-3, 1e-6, 1e-9})
        for (const Vec2& middle : {Vec2(0.5, 0.5), Vec2(0.3, 0.6), Vec2(0.25, 0.1)}) {
            const SurfaceModel model =
                ShapeBuilder()
                    .face(sheet(), {frame(), circle(middle, radius), circle(middle, radius / 2)})
                    .model();
            const Tracer tracer(model);
            for (int k = 0; k < 32; ++k) {
                const double turn = (k + 0.3) / 16 * std::numbers::pi;
                const auto there = [&](double share) {
                    const Vec2 p = middle + Vec2(std::cos(turn), std::sin(turn)) * radius * share;
                    return tracer.any(ray_through(Vec3(p.x, p.y, 3), Vec3(0, 0, -1)));
                };
                EXPECT_TRUE(there(1.001)) << radius << ' ' << middle << ' ' << k;
                EXPECT_FALSE(there(0.999)) << radius << ' ' << middle << ' ' << k;
                EXPECT_FALSE(there(0.501)) << radius << ' ' << middle << ' ' << k;
                EXPECT_TRUE(there(0.499)) << radius << ' ' << middle << ' ' << k;
            }
        }
}

/// A zigzag of straight curves along a span border: its corners lie on the iso-line.
TEST(TrimCurves, WithCornersOnIsoLinesCutWhereTheyShould) {
    std::vector<Vec2> corners{Vec2(0), Vec2(1, 0)};
    for (int k = 16; k >= 0; --k) corners.emplace_back(k / 16.0, k % 2 == 0 ? 0.5 : 0.625);
    const auto material = [](const Vec2& p) {
        const double step = p.x * 16, low = std::floor(step), share = step - low;
        const double rise = std::fmod(low, 2) == 0 ? share : 1 - share;
        return std::min(inside_frame(p), 0.5 + 0.125 * rise - p.y);
    };
    expect_material({polygon(corners)}, material,
                    {Vec2(0.5, 0.5), Vec2(0.125, 0.5), Vec2(0.5625, 0.625), Vec2(0.25, 0.5)});
}

} // namespace
} // namespace keiko
