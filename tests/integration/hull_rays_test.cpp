#include "keiko/import/worker/load_model.h"
#include "keiko/intersect/hit/reflect_ray.h"

#include "tests/integration/closed_model.h"
#include "tests/support/file_test_name.h"
#include "tests/support/long_run.h"
#include "tests/support/paths.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

using namespace test;

/// A solid and those of its places that nothing of it lies in front of.
class Hull {
public:
    explicit Hull(const std::filesystem::path& file)
        : model_(load_model(file)),
          tracer_(model_),
          edges_(model_),
          size_(hull_bounds(model_).size()) {}

    double size() const { return size_; }
    const Tracer& tracer() const { return tracer_; }

    /// A ray from outside to within `off` mm of a place on an edge, if it meets the hull there.
    std::optional<std::pair<Ray, Hit>> hit_near_edge(Random& random, double off) const {
        const auto edge = edges_.random_edge_point(random);
        if (!edge) return {};
        Ray ray;
        ray.direction = random_direction(random);
        ray.origin = edge->position + random_direction(random) * off - ray.direction * (2 * size_);
        const auto hit = tracer_.nearest(ray);
        if (!hit || !is_on_hull(hit->position, facing(*hit, ray))) return {};
        return std::pair(ray, *hit);
    }

    static Vec3 facing(const Hit& hit, const Ray& ray) {
        return hit.normal.dot(ray.direction) > 0 ? -hit.normal : hit.normal;
    }

private:
    bool is_on_hull(const Vec3& place, const Vec3& out) const {
        for (const Instance& instance : model_.instances)
            for (const Vec4& p : model_.control_points) {
                const Vec3 corner = instance.transform.point(Vec3(p.x, p.y, p.z) / p.w);
                if ((corner - place).dot(out) > 1e-9 * size_) return false;
            }
        return true;
    }

    SurfaceModel model_;
    Tracer tracer_;
    ClosedModel edges_;
    double size_;
};

/// Reflected rays and rays to lamps from beside an edge, however near: the room that rounding gets
/// beyond a neighbour's border must not stand in their way.
void expect_free(const std::filesystem::path& file) {
    const Hull hull(file);
    Random random(first_seed());
    std::size_t rays = 0, blocked = 0;
    const std::size_t wanted = ray_count(2'000, 200'000);
    for (std::size_t i = 0; rays < wanted && i < 20 * wanted; ++i) {
        const double off = hull.size() * std::pow(10, uniform(random, -11, -4));
        const auto met = hull.hit_near_edge(random, i % 8 == 0 ? 0 : off);
        if (!met) continue;
        const auto& [ray, hit] = *met;
        const Vec3 out = Hull::facing(hit, ray);
        Ray to_lamp;
        to_lamp.origin = hit.position;
        do to_lamp.direction = random_direction(random);
        while (!(to_lamp.direction.dot(out) > 0.01));
        to_lamp.excluded = hit.root;
        rays += 2;
        blocked += hull.tracer().any(to_lamp);
        if (out.dot(ray.direction) < -0.01) blocked += hull.tracer().any(reflect_ray(ray, hit));
    }
    EXPECT_GE(rays, wanted / 4);
    EXPECT_EQ(blocked, 0u);
}

class HullRays : public testing::TestWithParam<const char*> {};

TEST_P(HullRays, LeaveFreely) {
    expect_free(repository("surfaces") / GetParam());
}
INSTANTIATE_TEST_SUITE_P(Surfaces, HullRays, testing::Values("bored-block.step"), file_test_name);

class SharedHullRays : public testing::TestWithParam<const char*> {};

TEST_P(SharedHullRays, LeaveFreely) {
    KEIKO_NEEDS_SHARED_MODEL(GetParam());
    expect_free(shared_model(GetParam()));
}
INSTANTIATE_TEST_SUITE_P(RealModels, SharedHullRays,
                         testing::Values("cube-unit-mm.step", "cube-unit-in.step"), file_test_name);

} // namespace
} // namespace keiko
