#include "keiko/render/deep_buffer.h"

#include "keiko/base/error.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/intersect/hit/reflect_ray.h"

#include "tests/support/analytic_models.h"
#include "tests/unit/render/stage.h"
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <stop_token>

using namespace keiko;
using test::Stage;

namespace {

/// A torus lying in a domed dish: it mirrors itself and the dish, and is mirrored by both.
SurfaceModel torus_in_dish() {
    const SurfaceModel torus = test::torus_model(500, 180, 0.3);
    test::ModelBuilder builder;
    std::vector<Vec3> points;
    for (int i = 0; i <= 3; ++i)
        for (int j = 0; j <= 3; ++j) {
            const bool middle = i % 3 != 0 && j % 3 != 0;
            points.emplace_back(-1200 + 800 * i, -1200 + 800 * j, middle ? -500 : 200);
        }
    builder.patch(3, 3, points);
    const std::array models{torus, builder.build()};
    return merge(models);
}

Stage torus_stage() {
    Stage stage(torus_in_dish());
    stage.camera.width = 67, stage.camera.height = 41;
    return stage;
}

/// The nearest hit of a ray, with the normal on the side that the ray comes from.
std::optional<Hit> facing_hit(const Tracer& tracer, const Ray& ray) {
    auto hit = tracer.nearest(ray);
    if (hit && hit->normal.dot(ray.direction) > 0) hit->normal = -hit->normal;
    return hit;
}

const DeepSample& sample_at(const DeepBuffer& buffer, int x, int y) {
    return buffer.samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(buffer.width) +
                          static_cast<std::size_t>(x)];
}

template <class Use>
void for_each_pixel(const Camera& camera, const Use& use) {
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) use(x, y, camera.ray(x + 0.5, y + 0.5));
}

float rounded(double value) {
    return static_cast<float>(value);
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
    EXPECT_LT((a - b).length(), tolerance) << a << " is not " << b;
}

bool same_bytes(const DeepBuffer& a, const DeepBuffer& b) {
    return a.samples.size() == b.samples.size() && a.bounces.size() == b.bounces.size() &&
           std::memcmp(a.samples.data(), b.samples.data(), a.samples.size() * sizeof(DeepSample)) ==
               0 &&
           std::memcmp(a.bounces.data(), b.bounces.data(), a.bounces.size() * sizeof(DeepBounce)) ==
               0;
}

/// Samples and bounces of several sets of rows, each at its place in the whole picture.
DeepBuffer assembled(std::span<const DeepBuffer> parts) {
    DeepBuffer whole = parts.front();
    whole.rows = {};
    whole.samples.assign(static_cast<std::size_t>(whole.width * whole.height), {});
    std::multimap<std::uint32_t, DeepSample> bounces;
    for (const DeepBuffer& part : parts) {
        const auto width = static_cast<std::size_t>(part.width);
        for (std::size_t i = 0; i < part.samples.size(); ++i) {
            const std::size_t row = static_cast<std::size_t>(part.rows.first) +
                                    i / width * static_cast<std::size_t>(part.rows.step);
            whole.samples[row * width + i % width] = part.samples[i];
        }
        for (const DeepBounce& bounce : part.bounces) bounces.emplace(bounce.pixel, bounce.sample);
    }
    whole.bounces.clear();
    for (const auto& [pixel, sample] : bounces) whole.bounces.push_back({pixel, sample});
    return whole;
}

/// Change of a ray from one pixel to the next.
struct RayChange {
    Vec3 origin, direction;
};

/// Change of a reflected ray by the stored normal and shape [Igehy1999], for rays of direction `d`
/// from one point, which change by `change`.
RayChange reflected(const DeepSample& sample, const Vec3& d, const Vec3& change) {
    const Vec3 n = sample.normal();
    const auto [e1, e2] = sample.axes();
    const double xx = sample.shape_xx, xy = sample.shape_xy, yy = sample.shape_yy;
    const Vec3 moved = change * static_cast<double>(sample.t);
    const Vec3 step = moved - d * (moved.dot(n) / d.dot(n));
    const double a = step.dot(e1), b = step.dot(e2);
    const Vec3 turn = -(e1 * (xx * a + xy * b) + e2 * (xy * a + yy * b));
    return {step, change - (turn * d.dot(n) + n * (change.dot(n) + d.dot(turn))) * 2};
}

} // namespace

TEST(DeepBuffer, HoldsTheFirstSurfaceOfEachPixel) {
    const Stage stage = torus_stage();
    const DeepBuffer buffer = deep_buffer(stage.tracer, stage.camera);
    int hits = 0, misses = 0;
    for_each_pixel(stage.camera, [&](int x, int y, const Ray& ray) {
        const DeepSample& sample = sample_at(buffer, x, y);
        const auto hit = facing_hit(stage.tracer, ray);
        (hit ? hits : misses) += 1;
        if (!hit) {
            EXPECT_TRUE(std::isinf(sample.t) && std::isinf(sample.way));
            EXPECT_EQ(sample.face, 0);
            return;
        }
        EXPECT_EQ(sample.t, rounded(hit->t));
        EXPECT_EQ(sample.face, rounded(hit->face + 1));
        expect_near(sample.normal(), hit->normal, 1.2e-7);
    });
    EXPECT_GT(hits, 500);
    EXPECT_GT(misses, 100);
}

TEST(DeepBuffer, HasThePrincipalCurvaturesOnTheSideOfTheEye) {
    const Stage stage = torus_stage();
    const DeepBuffer buffer = deep_buffer(stage.tracer, stage.camera);
    int compared = 0;
    for_each_pixel(stage.camera, [&](int x, int y, const Ray& ray) {
        const auto hit = facing_hit(stage.tracer, ray);
        if (!hit) return;
        const DeepSample& s = sample_at(buffer, x, y);
        const auto k = reliable_curvatures(derivatives_of(*hit), hit->normal);
        if (!k) {
            EXPECT_TRUE(std::isnan(s.shape_xx));
            return;
        }
        const double xx = s.shape_xx, xy = s.shape_xy, yy = s.shape_yy;
        const double mean = (xx + yy) / 2, spread = std::hypot((xx - yy) / 2, xy);
        EXPECT_NEAR(mean + spread, k->k1, 1e-6 * std::abs(k->k1) + 1e-10);
        EXPECT_NEAR(mean - spread, k->k2, 1e-6 * std::abs(k->k2) + 1e-10);
        ++compared;
    });
    EXPECT_GT(compared, 500);
}

// What a viewer does: the differentials of the reflected ray by the stored normal and shape.
TEST(DeepBuffer, GivesTheDifferentialsOfReflectedRays) {
    const Stage stage = torus_stage();
    const DeepBuffer buffer = deep_buffer(stage.tracer, stage.camera);
    int compared = 0;
    for_each_pixel(stage.camera, [&](int x, int y, const Ray& ray) {
        const auto hit = facing_hit(stage.tracer, ray);
        if (!hit || std::isnan(sample_at(buffer, x, y).shape_xx)) return;
        const Ray exact = reflect_ray(ray, *hit);
        if (!exact.differentials) return;
        const DeepSample& sample = sample_at(buffer, x, y);
        const RayDifferentials &in = *ray.differentials, &out = *exact.differentials;
        // Grazing rays magnify the rounding of the stored normal.
        const double graze = std::abs(ray.direction.dot(hit->normal));
        const auto expect = [&](const Vec3& change, const Vec3& origin, const Vec3& direction) {
            const RayChange told = reflected(sample, ray.direction, change);
            expect_near(told.origin, origin, 1e-6 * origin.length() / graze + 1e-7);
            expect_near(told.direction, direction, 3e-6 * direction.length() / graze + 1e-9);
        };
        expect(in.direction_dx, out.origin_dx, out.direction_dx);
        expect(in.direction_dy, out.origin_dy, out.direction_dy);
        ++compared;
    });
    EXPECT_GT(compared, 500);
}

TEST(DeepBuffer, FollowsTheReflectionsOfEachPixel) {
    const Stage stage = torus_stage();
    constexpr int reflections = 3;
    const DeepBuffer buffer =
        deep_buffer(stage.tracer, stage.camera, {.rows = {}, .reflections = reflections});
    std::vector<DeepBounce> expected;
    for_each_pixel(stage.camera, [&](int x, int y, Ray ray) {
        auto hit = facing_hit(stage.tracer, ray);
        const DeepSample* before = &sample_at(buffer, x, y);
        std::vector<const DeepSample*> chain;
        const auto pixel = static_cast<std::uint32_t>(y * stage.camera.width + x);
        for (const DeepBounce& bounce : buffer.bounces)
            if (bounce.pixel == pixel) chain.push_back(&bounce.sample);
        for (int depth = 1; hit; ++depth) {
            ray = reflect_ray(ray, *hit);
            hit = facing_hit(stage.tracer, ray);
            EXPECT_EQ(before->way, hit ? rounded(hit->t) : std::numeric_limits<float>::infinity());
            const auto number = static_cast<std::size_t>(depth) - 1;
            if (!hit || depth == reflections) {
                EXPECT_EQ(chain.size(), number);
                break;
            }
            ASSERT_GT(chain.size(), number);
            before = chain[number];
            EXPECT_EQ(before->t, rounded(hit->t));
            EXPECT_EQ(before->face, rounded(hit->face + 1));
            expect_near(before->normal(), hit->normal, 1.2e-7);
        }
    });
    EXPECT_GT(buffer.bounces.size(), 300u);
}

TEST(DeepBuffer, HasNoBouncesOfASingleReflection) {
    const Stage stage = torus_stage();
    const DeepBuffer one = deep_buffer(stage.tracer, stage.camera, {.rows = {}, .reflections = 1});
    EXPECT_TRUE(one.bounces.empty());
    const DeepBuffer three = deep_buffer(stage.tracer, stage.camera);
    EXPECT_EQ(std::memcmp(one.samples.data(), three.samples.data(),
                          one.samples.size() * sizeof(DeepSample)),
              0);
}

TEST(DeepBuffer, IsTheSameForAnyNumberOfThreads) {
    Stage stage = torus_stage();
    stage.camera.width = 200, stage.camera.height = 130; // many tiles
    const auto with = [&](int threads) {
        return deep_buffer(stage.tracer, stage.camera, {},
                           {.progress = {}, .stop = {}, .threads = threads});
    };
    const DeepBuffer one = with(1);
    EXPECT_FALSE(one.bounces.empty());
    EXPECT_TRUE(same_bytes(one, with(3)));
    EXPECT_TRUE(same_bytes(one, with(7)));
}

TEST(DeepBuffer, OfInterlacedRowsIsTheWholeInParts) {
    Stage stage = torus_stage();
    for (const int height : {1, 3, 41}) {
        stage.camera.height = height;
        const DeepBuffer whole = deep_buffer(stage.tracer, stage.camera);
        std::vector<DeepBuffer> parts;
        std::size_t samples = 0;
        for (const RowSet& rows : interlaced_rows()) {
            parts.push_back(deep_buffer(stage.tracer, stage.camera, {.rows = rows}));
            samples += parts.back().samples.size();
        }
        EXPECT_EQ(samples, whole.samples.size());
        EXPECT_TRUE(same_bytes(assembled(parts), whole)) << height;
    }
}

TEST(DeepBuffer, OfParallelRaysIsThatOfTheirHits) {
    Stage stage = torus_stage();
    stage.camera.projection = Projection::orthographic, stage.camera.orthographic_height = 1500;
    const DeepBuffer buffer = deep_buffer(stage.tracer, stage.camera);
    for_each_pixel(stage.camera, [&](int x, int y, const Ray& ray) {
        const auto hit = facing_hit(stage.tracer, ray);
        const float t = hit ? rounded(hit->t) : std::numeric_limits<float>::infinity();
        EXPECT_EQ(sample_at(buffer, x, y).t, t);
    });
}

// The middle ray meets the pole, where the parameters say nothing of the curvature.
TEST(DeepBuffer, HasNoShapeAtAPole) {
    Affine larger;
    for (Vec3& row : larger.rows) row *= 400;
    Stage stage(test::sphere_model(larger));
    stage.camera.projection = Projection::orthographic, stage.camera.orthographic_height = 900;
    stage.camera.eye = {0, 0, 1000}, stage.camera.target = Vec3(0), stage.camera.up = {0, 1, 0};
    stage.camera.width = 9, stage.camera.height = 9;
    const DeepBuffer buffer = deep_buffer(stage.tracer, stage.camera);
    EXPECT_TRUE(std::isnan(sample_at(buffer, 4, 4).shape_xx));
    EXPECT_NEAR(sample_at(buffer, 4, 4).t, 600, 1e-3);
    const DeepSample& beside = sample_at(buffer, 5, 4);
    EXPECT_NEAR(beside.shape_xx, -1.0 / 400, 1e-8); // it bends away from the eye
    EXPECT_NEAR(beside.shape_yy, -1.0 / 400, 1e-8);
    EXPECT_NEAR(beside.shape_xy, 0, 1e-8);
}

TEST(DeepBuffer, EndsOnceItIsToStop) {
    Stage stage = torus_stage();
    stage.camera.width = 400, stage.camera.height = 300;
    std::stop_source stop;
    Job job{.progress = [&](const Progress&) { stop.request_stop(); },
            .stop = stop.get_token(),
            .threads = 1};
    EXPECT_THROW(deep_buffer(stage.tracer, stage.camera, {}, job), Cancelled);
}
