#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/random_surfaces.h"
#include "tests/support/ray_class.h"
#include "tests/support/squares.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <thread>

namespace keiko {
namespace {

using namespace test;

bool same_bits(const Hit& a, const Hit& b) {
    const bool second =
        a.second.has_value() == b.second.has_value() &&
        (!a.second || (a.second->duu == b.second->duu && a.second->duv == b.second->duv &&
                       a.second->dvv == b.second->dvv));
    return a.t == b.t && a.instance == b.instance && a.face == b.face && a.patch == b.patch &&
           a.uv == b.uv && a.position == b.position && a.normal == b.normal && a.dpdu == b.dpdu &&
           a.dpdv == b.dpdv && second && a.position_bound == b.position_bound &&
           a.flags == b.flags && a.seam == b.seam && a.root.uv == b.root.uv;
}

/// The part of a hit that HitDetail::face has.
Hit face_of(const Hit& hit) {
    Hit face;
    face.t = hit.t, face.flags = hit.flags, face.seam = hit.seam;
    face.instance = hit.instance, face.face = hit.face, face.patch = hit.patch;
    return face;
}

bool same_bits(const std::vector<Hit>& a, const std::vector<Hit>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Hit& x, const Hit& y) { return same_bits(x, y); });
}

bool same_bits(const std::optional<Hit>& a, const std::optional<Hit>& b) {
    return a.has_value() == b.has_value() && (!a || same_bits(*a, *b));
}

/// Layers of sheets, trimmed and rational ones among them.
SurfaceModel stack() {
    Random random(111);
    ShapeBuilder builder;
    for (int i = 0; i < 8; ++i) {
        const SurfaceKind kind{.degree_u = 1 + i,
                               .degree_v = 3,
                               .spans_u = 1 + i % 3,
                               .spans_v = 2,
                               .rough = 15,
                               .weights = 1.0 + i % 4,
                               .offset = Vec3(0, 0, 12.0 * i)};
        builder.face(patches_of(random_nurbs(random, kind)),
                     i % 2 == 0 ? std::vector<LoopData>{} : random_loops(random));
    }
    return builder.model();
}

/// Coherent and incoherent rays, grazing ones, and some that cannot hit.
std::vector<Ray> mixed_rays() {
    Random random(112);
    std::vector<Ray> rays;
    for (int i = 0; i < 1024; ++i) {
        const Vec3 eye(0, -300, 400), target(-50 + i % 32 * 3.1, -50 + i / 32 * 3.1, 40);
        rays.push_back(ray_through(eye, target - eye));
    }
    for (int i = 0; i < 3000; ++i) {
        const Vec3 direction = random_direction(random);
        const Vec3 target(uniform(random, -60, 60), uniform(random, -60, 60),
                          uniform(random, -20, 110));
        rays.push_back(ray_through(target - direction * uniform(random, 0, 400), direction));
        if (i % 7 == 0) rays.back().direction.z = 0;
        if (i % 50 == 0) rays.back().direction.x = std::numeric_limits<double>::quiet_NaN();
        if (i % 11 == 0) rays.back().t_max = uniform(random, 0, 400);
    }
    return rays;
}

class SameHits : public testing::Test {
protected:
    const SurfaceModel model_ = stack();
    const Tracer tracer_{model_, {.second_derivatives = true}};
    const std::vector<Ray> rays_ = mixed_rays();
    const std::vector<std::optional<Hit>> nearest_ = tracer_.nearest(std::span<const Ray>(rays_));
    const std::vector<std::vector<Hit>> all_ = tracer_.all(std::span<const Ray>(rays_));
    const std::vector<bool> any_ = tracer_.any(std::span<const Ray>(rays_));
};

TEST_F(SameHits, OfASpanAndOfSingleRays) {
    std::size_t hits = 0;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        ASSERT_TRUE(same_bits(tracer_.nearest(rays_[i]), nearest_[i])) << i;
        ASSERT_TRUE(same_bits(tracer_.all(rays_[i]), all_[i])) << i;
        ASSERT_EQ(tracer_.any(rays_[i]), any_[i]) << i;
        ASSERT_EQ(any_[i], nearest_[i].has_value()) << i;
        ASSERT_EQ(any_[i], !all_[i].empty()) << i;
        hits += all_[i].size();
    }
    EXPECT_GT(hits, rays_.size());
}

TEST_F(SameHits, WithNoRoomForRaysThatHaveNone) {
    const FirstHits first = tracer_.first_hits(rays_);
    std::size_t hits = 0;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        ASSERT_EQ(first[i] != nullptr, nearest_[i].has_value()) << i;
        if (!first[i]) continue;
        ASSERT_TRUE(same_bits(*first[i], *nearest_[i])) << i;
        ++hits;
    }
    EXPECT_EQ(first.hits.size(), hits);
    EXPECT_GT(hits, rays_.size() / 4);
    EXPECT_LT(hits, rays_.size());
}

TEST_F(SameHits, WithTheirFacesAloneWhereNoMoreIsAskedFor) {
    const FirstHits faces = tracer_.first_hits(rays_, HitDetail::face);
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        ASSERT_EQ(faces[i] != nullptr, nearest_[i].has_value()) << i;
        if (!faces[i]) continue;
        ASSERT_TRUE(same_bits(*faces[i], face_of(*nearest_[i]))) << i;
    }
}

// There all hits of a ray tell which of them is the first.
TEST(FirstHits, OfRaysThroughSeamsAreTheNearest) {
    Random random(113);
    constexpr double gap = 1e-2;
    const Tracer tracer(squares(gap, 2 * gap, 0.2), {.second_derivatives = true});
    std::vector<Ray> rays;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 target((i % 3 == 0 ? 500 : 1) * uniform(random, -2, 2) * gap,
                          uniform(random, -11, 11), 0);
        const Vec3 in(uniform(random, -5, 5), uniform(random, -1, 1), i % 2 == 0 ? -1 : 1);
        rays.push_back(ray_through(target - in * 20, in));
    }
    const FirstHits first = tracer.first_hits(rays);
    const FirstHits faces = tracer.first_hits(rays, HitDetail::face);
    const std::vector<std::optional<Hit>> nearest = tracer.nearest(std::span<const Ray>(rays));
    int in_seams = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(first[i] != nullptr, nearest[i].has_value()) << i;
        if (!first[i]) continue;
        ASSERT_TRUE(same_bits(*first[i], *nearest[i])) << i;
        ASSERT_TRUE(same_bits(face_of(*faces[i]), face_of(*nearest[i]))) << i;
        in_seams += has(first[i]->flags, HitFlags::seam) ? 1 : 0;
    }
    EXPECT_GT(in_seams, 100);
}

TEST_F(SameHits, InAnyOrderOfTheRays) {
    std::vector<std::size_t> order(rays_.size());
    std::iota(order.begin(), order.end(), 0u);
    Random random(113);
    for (int round = 0; round < 3; ++round) {
        std::shuffle(order.begin(), order.end(), random);
        std::vector<Ray> shuffled;
        for (const std::size_t i : order) shuffled.push_back(rays_[i]);
        const auto nearest = tracer_.nearest(std::span<const Ray>(shuffled));
        const auto all = tracer_.all(std::span<const Ray>(shuffled));
        for (std::size_t i = 0; i < order.size(); ++i) {
            ASSERT_TRUE(same_bits(nearest[i], nearest_[order[i]])) << i;
            ASSERT_TRUE(same_bits(all[i], all_[order[i]])) << i;
        }
    }
}

/// Spans of all lengths about the width of a packet, starting anywhere.
TEST_F(SameHits, InSpansOfAnyLength) {
    std::size_t first = 0;
    for (std::size_t length = 0; length <= 70; ++length) {
        const auto part = std::span<const Ray>(rays_).subspan(first, length);
        const auto nearest = tracer_.nearest(part);
        ASSERT_EQ(nearest.size(), length);
        for (std::size_t i = 0; i < length; ++i)
            ASSERT_TRUE(same_bits(nearest[i], nearest_[first + i])) << length << ' ' << i;
        first += length;
    }
}

TEST_F(SameHits, ForAnyNumberOfThreads) {
    for (const int threads : {1, 2, 3, 7}) {
        Job job;
        job.threads = threads;
        const Tracer built(model_, {.second_derivatives = true}, job);
        std::vector<std::optional<Hit>> found(rays_.size());
        std::vector<std::jthread> team;
        for (int t = 0; t < threads; ++t)
            team.emplace_back([&, t] {
                for (auto i = static_cast<std::size_t>(t); i < rays_.size();
                     i += static_cast<std::size_t>(threads))
                    found[i] = built.nearest(rays_[i]);
            });
        team.clear();
        for (std::size_t i = 0; i < rays_.size(); ++i)
            ASSERT_TRUE(same_bits(found[i], nearest_[i])) << threads << ' ' << i;
    }
}

bool touches(const std::vector<Hit>& hits) {
    return std::any_of(hits.begin(), hits.end(),
                       [](const Hit& hit) { return has(hit.flags, HitFlags::tangential); });
}

/// Finer and coarser sub-patches prove and clip otherwise, but find the same, each within its
/// bound.
TEST_F(SameHits, ForAnySizeOfTheSubPatches) {
    for (const double contraction : {0.1, 0.3, 2.0, 10.0}) {
        const Tracer other(model_, {.sub_patch_contraction = contraction});
        ASSERT_NE(other.statistics().sub_patches, tracer_.statistics().sub_patches) << contraction;
        const auto found = other.all(std::span<const Ray>(rays_));
        for (std::size_t i = 0; i < rays_.size(); ++i) {
            if (touches(found[i]) || touches(all_[i])) continue;
            ASSERT_EQ(found[i].size(), all_[i].size()) << contraction << ' ' << i;
            for (std::size_t k = 0; k < found[i].size(); ++k)
                EXPECT_LE((found[i][k].position - all_[i][k].position).length(),
                          found[i][k].position_bound + all_[i][k].position_bound)
                    << contraction << ' ' << i;
        }
    }
}

/// A part of a ray has the same hits as the whole ray has there, to the bit.
TEST_F(SameHits, InAnyPartOfARay) {
    for (std::size_t i = 0; i < rays_.size(); i += 3) {
        if (all_[i].size() < 2) continue;
        Ray part = rays_[i];
        part.t_min = all_[i][1].t;
        const std::vector<Hit> rest = tracer_.all(part);
        ASSERT_FALSE(rest.empty()) << i;
        EXPECT_TRUE(same_bits(rest.front(), all_[i][1])) << i;
    }
}

} // namespace
} // namespace keiko
