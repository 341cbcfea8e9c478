#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/random_surfaces.h"
#include "tests/support/ray_class.h"
#include "tests/support/squares.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace keiko {
namespace {

using namespace test;

constexpr std::size_t sheets = 6;

/// Layers of sheets, every other one trimmed.
SurfaceModel stack() {
    Random random(211);
    ShapeBuilder builder;
    for (std::size_t i = 0; i < sheets; ++i)
        builder.face(patches_of(random_nurbs(
                         random, {.spans_u = 2, .offset = Vec3(0, 0, 12.0 * static_cast<int>(i))})),
                     i % 2 == 0 ? std::vector<LoopData>{} : random_loops(random));
    return builder.model();
}

std::vector<Ray> rays_through_stack() {
    Random random(212);
    std::vector<Ray> rays;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 direction = random_direction(random);
        const Vec3 target(uniform(random, -60, 60), uniform(random, -60, 60),
                          uniform(random, -10, 80));
        rays.push_back(ray_through(target - direction * 300, direction));
    }
    return rays;
}

bool same_bits(const Hit& a, const Hit& b) {
    return a.t == b.t && a.face == b.face && a.patch == b.patch && a.uv == b.uv &&
           a.position == b.position && a.normal == b.normal && a.dpdu == b.dpdu &&
           a.second->duu == b.second->duu && a.flags == b.flags;
}

/// The hits of each ray on faces that are not hidden.
std::vector<std::vector<Hit>> left_of(std::vector<std::vector<Hit>> all,
                                      const std::vector<bool>& hidden) {
    for (std::vector<Hit>& hits : all)
        std::erase_if(hits, [&](const Hit& hit) { return hidden[hit.face]; });
    return all;
}

} // namespace

TEST(HiddenFaces, LeaveTheHitsOfTheOthersBitForBit) {
    const Tracer whole(stack(), {.second_derivatives = true});
    const std::vector<Ray> rays = rays_through_stack();
    const std::span<const Ray> span(rays);
    const auto all = whole.all(span);
    for (const std::vector<bool>& hidden :
         {std::vector<bool>{true, false, false, false, false, false},
          std::vector<bool>{false, true, false, true, true, false},
          std::vector<bool>{true, true, true, false, true, true}}) {
        const Tracer part = whole.without(hidden);
        const auto expected = left_of(all, hidden), found = part.all(span);
        const auto nearest = part.nearest(span);
        const auto any = part.any(span);
        std::size_t hits = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            ASSERT_TRUE(std::equal(found[i].begin(), found[i].end(), expected[i].begin(),
                                   expected[i].end(), same_bits))
                << i;
            ASSERT_EQ(any[i], !expected[i].empty()) << i;
            ASSERT_EQ(nearest[i].has_value(), !expected[i].empty()) << i;
            if (nearest[i]) {
                ASSERT_TRUE(same_bits(*nearest[i], expected[i].front())) << i;
            }
            hits += expected[i].size();
        }
        EXPECT_GT(hits, rays.size() / 10);
    }
}

TEST(HiddenFaces, HaveNoBoxes) {
    const Tracer whole(stack());
    std::vector<bool> hidden(sheets, false);
    EXPECT_EQ(whole.without(hidden).boxes().size(), whole.boxes().size());
    hidden[2] = true;
    const Tracer part = whole.without(hidden);
    EXPECT_LT(part.boxes().size(), whole.boxes().size());
    EXPECT_EQ(part.bounds().lower, whole.bounds().lower);
    EXPECT_TRUE(whole.without(std::vector<bool>(sheets, true)).boxes().empty());
    EXPECT_FALSE(whole.without(std::vector<bool>(sheets, true)).any(rays_through_stack().front()));
}

TEST(HiddenFaces, OutliveTheTracerOfTheWhole) {
    std::optional<Tracer> whole(std::in_place, stack());
    const Tracer part = whole->without(std::vector<bool>(sheets, false));
    const std::vector<Ray> rays = rays_through_stack();
    const auto expected = whole->any(std::span<const Ray>(rays));
    whole.reset();
    EXPECT_EQ(part.any(std::span<const Ray>(rays)), expected);
}

TEST(HiddenFaces, LeaveTheWidthOfTheirSeams) {
    constexpr double gap = 0.1;
    const Tracer whole(squares(gap, 2 * gap, 0));
    const Tracer left = whole.without({false, true});
    const auto at = [](double x) { return ray_through(Vec3(x, 1, 5), Vec3(0, 0, -1)); };
    EXPECT_TRUE(left.any(at(-1)));
    EXPECT_TRUE(whole.any(at(0)));
    EXPECT_TRUE(left.any(at(-0.4 * gap)));
    EXPECT_FALSE(left.any(at(gap)));
    EXPECT_TRUE(whole.any(at(gap)));
}

} // namespace keiko
