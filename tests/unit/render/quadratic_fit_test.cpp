#include "keiko/render/lighting/quadratic_fit.h"

#include "keiko/render/reflection/shading_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace keiko;

namespace {

DirectLight quadratic(const Vec2& p) {
    const double value = 3 - 2 * p.x + p.y + 0.5 * p.x * p.x - 0.7 * p.x * p.y + 0.2 * p.y * p.y;
    return {Rgb(value, 2 * value, -value), Rgb(p.x * p.y, 1, p.y), p.x * p.x};
}

/// Light of any degree.
DirectLight lamp_like(const Vec2& p) {
    return {Rgb(std::exp(p.x) / (2 + p.y)), Rgb(std::cos(3 * p.x + p.y)), std::sin(p.y)};
}

std::vector<Vec2> scattered(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> side(-1, 1);
    std::vector<Vec2> nodes;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = side(random);
        nodes.emplace_back(x, side(random));
    }
    return nodes;
}

std::vector<DirectLight> lights_at(const std::vector<Vec2>& nodes,
                                   DirectLight (*light)(const Vec2&)) {
    std::vector<DirectLight> lights;
    for (const Vec2& node : nodes) lights.push_back(light(node));
    return lights;
}

void expect_near(const DirectLight& is, const DirectLight& wanted, double most) {
    const DirectLight wrong = is - wanted;
    for (const Rgb& off : {wrong.illuminance, wrong.lobes})
        EXPECT_LT(std::abs(off.r) + std::abs(off.g) + std::abs(off.b), most);
    EXPECT_LT(std::abs(wrong.incident), most);
}

double leverages(const QuadraticFit& fit, const std::vector<Vec2>& nodes) {
    double sum = 0;
    for (const Vec2& node : nodes) sum += fit.leverage(monomials(node));
    return sum;
}

} // namespace

TEST(QuadraticFit, ReproducesQuadratics) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const std::vector<Vec2> nodes = scattered(12, seed);
        const Quadratic<DirectLight> fit =
            QuadraticFit(nodes).to(std::span<const DirectLight>(lights_at(nodes, quadratic)));
        for (const Vec2& place : scattered(20, 100 + seed))
            expect_near(fit.at(monomials(place)), quadratic(place), 1e-11);
    }
}

// What the other nodes predict, by leaving each node out in turn.
TEST(QuadraticFit, TellsWhatTheOtherNodesPredict) {
    const std::vector<Vec2> nodes = scattered(12, 7);
    const std::vector<DirectLight> lights = lights_at(nodes, lamp_like);
    const QuadraticFit fit(nodes);
    const Quadratic<DirectLight> fitted = fit.to(std::span<const DirectLight>(lights));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        std::vector<Vec2> others = nodes;
        std::vector<DirectLight> other_lights = lights;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        other_lights.erase(other_lights.begin() + static_cast<std::ptrdiff_t>(i));
        const DirectLight predicted = QuadraticFit(others)
                                          .to(std::span<const DirectLight>(other_lights))
                                          .at(monomials(nodes[i]));
        const DirectLight wrong = (lights[i] - fitted.at(monomials(nodes[i]))) *
                                  (1 / (1 - fit.leverage(monomials(nodes[i]))));
        expect_near(wrong, lights[i] - predicted, 1e-9);
    }
    EXPECT_NEAR(leverages(fit, nodes), 6, 1e-12);
}

TEST(QuadraticFit, LeavesOutWhatNodesOnALineCannotTell) {
    std::vector<Vec2> nodes;
    for (int i = 0; i < 8; ++i) nodes.emplace_back(-1 + i / 4.0, 0.5 - i / 8.0);
    const QuadraticFit fit(nodes);
    EXPECT_NEAR(leverages(fit, nodes), 3, 1e-12);
    const Quadratic<DirectLight> fitted =
        fit.to(std::span<const DirectLight>(lights_at(nodes, quadratic)));
    for (const double x : {-0.9, -0.1, 0.6}) {
        const Vec2 place(x, -0.5 * x);
        expect_near(fitted.at(monomials(place)), quadratic(place), 1e-11);
    }
}

TEST(QuadraticFit, OfOneNodeIsItsLight) {
    const std::vector<Vec2> node{{0.3, -0.2}};
    const QuadraticFit fit(node);
    EXPECT_NEAR(fit.leverage(monomials(node[0])), 1, 1e-14);
    expect_near(
        fit.to(std::span<const DirectLight>(lights_at(node, lamp_like))).at(monomials({5, 7})),
        lamp_like(node[0]), 1e-14);
}

TEST(QuadraticFit, TellsWhereItExtrapolates) {
    const std::vector<Vec2> nodes = scattered(12, 3);
    const QuadraticFit fit(nodes);
    EXPECT_LT(fit.leverage(monomials({0, 0})), 2);
    EXPECT_GT(fit.leverage(monomials({1.5, 1.5})), 4);
}
