#include "keiko/intersect/hit/refract_ray.h"

#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/shapes.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

/// A ray as the camera ray of pixels that are `step` wide in two directions at distance 1.
Ray ray_at(double x, double y) {
    const Vec3 through = Vec3(1, 0.1, -0.2) + Vec3(0, 1, 0.3) * x + Vec3(0.2, -0.1, 1) * y;
    const double length = through.length();
    Ray ray;
    ray.origin = {-400, 21, 60};
    ray.direction = through / length;
    const auto rate = [&](const Vec3& d) {
        return (d - ray.direction * ray.direction.dot(d)) / length;
    };
    ray.differentials = {Vec3(0), Vec3(0), rate({0, 1, 0.3}), rate({0.2, -0.1, 1})};
    return ray;
}

class RefractRay : public testing::Test {
protected:
    Tracer torus_{test::ShapeBuilder().face(test::torus(120, 70)).model(),
                  {.second_derivatives = true}};

    /// The ray after two refractions, in and out.
    std::optional<Ray> through(double x, double y, double n) const {
        Ray ray = ray_at(x, y);
        for (const double eta : {1 / n, n}) {
            const auto hit = torus_.nearest(ray);
            if (!hit) return {};
            const auto refracted = refract_ray(ray, *hit, eta);
            if (!refracted) return {};
            ray = *refracted;
        }
        return ray;
    }
};

TEST_F(RefractRay, DifferentialsAreThoseOfNeighbouringRays) {
    constexpr double h = 1e-5, n = 1.1;
    const auto middle = through(0, 0, n);
    ASSERT_TRUE(middle && middle->differentials);
    const auto difference = [&](double x, double y, const auto& part) {
        return (part(*through(x, y, n)) - part(*through(-x, -y, n))) / (2 * h);
    };
    const auto origin = [](const Ray& ray) { return ray.origin; };
    const auto direction = [](const Ray& ray) { return ray.direction; };
    const RayDifferentials& d = *middle->differentials;
    EXPECT_LT((d.origin_dx - difference(h, 0, origin)).length(), 1e-5 * d.origin_dx.length());
    EXPECT_LT((d.origin_dy - difference(0, h, origin)).length(), 1e-5 * d.origin_dy.length());
    EXPECT_LT((d.direction_dx - difference(h, 0, direction)).length(),
              1e-5 * d.direction_dx.length());
    EXPECT_LT((d.direction_dy - difference(0, h, direction)).length(),
              1e-5 * d.direction_dy.length());
    EXPECT_GT(d.direction_dx.length(), 0.1); // it is bent
}

TEST_F(RefractRay, SnellsLawHoldsForDirectionsOfAnyLength) {
    for (const double length : {1.0, 250.0})
        for (const double eta : {1 / 1.7, 0.9}) {
            Ray ray = ray_at(0.01, 0.02);
            ray.direction *= length;
            ray.differentials.reset();
            const auto hit = torus_.nearest(ray);
            ASSERT_TRUE(hit);
            const auto refracted = refract_ray(ray, *hit, eta);
            ASSERT_TRUE(refracted);
            EXPECT_NEAR(refracted->direction.length(), length, 1e-12 * length);
            const Vec3 before = ray.direction.cross(hit->normal) * eta;
            EXPECT_LT((refracted->direction.cross(hit->normal) - before).length(), 1e-12 * length);
            EXPECT_GT(refracted->direction.dot(hit->normal) * ray.direction.dot(hit->normal), 0);
        }
}

TEST_F(RefractRay, IndexOneGoesStraightOnWithTheFootprintOfTheRay) {
    const Ray ray = ray_at(0, 0);
    const auto hit = torus_.nearest(ray);
    ASSERT_TRUE(hit);
    const auto on = refract_ray(ray, *hit, 1);
    ASSERT_TRUE(on && on->differentials);
    EXPECT_EQ(on->direction, ray.direction);
    EXPECT_LT((on->differentials->direction_dx - ray.differentials->direction_dx).length(), 1e-14);
    // Both footprints are the same further on.
    const auto at = [](const Ray& of, double t) {
        return of.differentials->origin_dx + of.differentials->direction_dx * t;
    };
    const Vec3 shift = at(*on, 100) - at(ray, hit->t + 100);
    EXPECT_LT(shift.cross(ray.direction).length(), 1e-9);
}

TEST_F(RefractRay, ThereIsNoneWhereTheReflectionIsTotal) {
    const Ray ray = ray_at(0, 0);
    const auto hit = torus_.nearest(ray);
    ASSERT_TRUE(hit);
    const double cosine = std::abs(hit->normal.dot(ray.direction));
    const double critical = 1 / std::sqrt(1 - cosine * cosine);
    EXPECT_FALSE(refract_ray(ray, *hit, critical * 1.001));
    EXPECT_TRUE(refract_ray(ray, *hit, critical * 0.999));
}

} // namespace
} // namespace keiko
