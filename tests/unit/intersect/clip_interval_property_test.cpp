#include "keiko/intersect/roots/planar_net.h"

#include "tests/support/exact_patch.h"
#include "tests/support/long_run.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <iostream>

namespace keiko {
namespace {

using namespace test;

/// A random function with a zero planted at a known place, and what its coefficients may be off.
struct Planted {
    PlanarNet net;
    Vec2 root{0};
    double slack = 0;
};

/// Value of a net in long double.
Long value_at(const PlanarNet& net, const Vec2& uv) {
    std::vector<Vec4> points;
    for (std::size_t i = 0; i < net.size(); ++i) points.emplace_back(net.f[i], 0, 0, 1);
    return ExactPatch({net.degree_u, net.degree_v, points}).at(uv.x, uv.y).position.x;
}

double place(Random& random, std::size_t i) {
    const double ends[] = {0, 1, 1e-15, 1 - 1e-15};
    return i % 16 < 4 ? ends[i % 4] : uniform(random, 0, 1);
}

/// The zero is planted in one of three ways: by a shift of all coefficients; between signs, so
/// that the hull is narrow; as a double root, where the function only touches zero.
Planted plant(Random& random, std::size_t i) {
    Planted p;
    p.net.degree_u = 1 + static_cast<int>(pick(random, i % 64 == 0 ? 25 : 9));
    p.net.degree_v = 1 + static_cast<int>(pick(random, i % 64 == 0 ? 25 : 9));
    p.root = {place(random, pick(random, 64)), place(random, pick(random, 64))};
    const double size = std::pow(10, uniform(random, -6, 6));
    const double slope = uniform(random, -3, 3), noise = i % 3 == 0 ? 1 : uniform(random, 0, 0.1);
    for (std::size_t k = 0; k < p.net.size(); ++k) {
        const double u = static_cast<double>(k / p.net.columns()) / p.net.degree_u - p.root.x;
        const double v = static_cast<double>(k % p.net.columns()) / p.net.degree_v - p.root.y;
        const double smooth = i % 3 == 2 ? u * u + v * v : u + slope * v;
        p.net.f[k] = size * (smooth + noise * uniform(random, -1, 1));
        p.net.g[k] = 0;
    }
    const auto shift = static_cast<double>(value_at(p.net, p.root));
    for (std::size_t k = 0; k < p.net.size(); ++k) p.net.f[k] -= shift;
    // What the subtraction rounds, and `shift` with it.
    double largest = std::abs(shift);
    for (std::size_t k = 0; k < p.net.size(); ++k)
        largest = std::max(largest, std::abs(p.net.f[k]));
    p.slack = largest * std::numeric_limits<double>::epsilon();
    return p;
}

bool keeps(const Planted& p, Axis axis) {
    const std::span<const double> f(p.net.f.data(), p.net.size());
    const ParameterInterval kept = clip_interval(f, p.net.rows(), p.net.columns(), axis, p.slack);
    const double at = axis == Axis::u ? p.root.x : p.root.y;
    return kept.begin <= at && at <= kept.end;
}

TEST(HullClipProperty, NeverCutsAwayAPlantedRoot) {
    const std::size_t count = ray_count(1'000'000, 100'000'000);
    Random random(first_seed());
    std::size_t lost = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Planted p = plant(random, i);
        for (const Axis axis : {Axis::u, Axis::v}) {
            if (keeps(p, axis)) continue;
            if (++lost <= 5)
                std::cout << "lost: net " << i << ", degrees " << p.net.degree_u << " x "
                          << p.net.degree_v << ", root " << p.root << "\n";
        }
    }
    std::cout << "hull clip: " << count << " planted roots, lost " << lost << "\n";
    EXPECT_EQ(lost, 0u);
}

} // namespace
} // namespace keiko
