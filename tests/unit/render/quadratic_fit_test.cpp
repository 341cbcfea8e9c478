#include "keiko/render/lighting/quadratic_fit.h"

#include "keiko/render/reflection/shading_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace keiko;

namespace {

DirectLight quadratic(const ChartPlace& place) {
    const Vec2 &p = place.at, &n = place.tilt;
    const double value = 3 - 2 * p.x + p.y + 0.5 * p.x * p.x - 0.7 * p.x * p.y + 0.2 * p.y * p.y +
                         0.3 * place.height - n.x + 0.4 * n.y * n.y;
    return {Rgb(value, 2 * value, -value), Rgb(p.x * p.y, 1, n.x * n.y), p.x * p.x + n.x * n.x};
}

/// Light of any degree.
DirectLight lamp_like(const ChartPlace& place) {
    const Vec2 &p = place.at, &n = place.tilt;
    return {Rgb(std::exp(p.x) / (2 + p.y + 0.5 * n.x)), Rgb(std::cos(3 * p.x + p.y - place.height)),
            std::sin(p.y + n.y)};
}

std::vector<ChartPlace> scattered(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> side(-1, 1);
    std::vector<ChartPlace> nodes(count);
    for (ChartPlace& node : nodes)
        for (double* part : {&node.at.x, &node.at.y, &node.height, &node.tilt.x, &node.tilt.y})
            *part = side(random);
    return nodes;
}

std::vector<DirectLight> lights_at(const std::vector<ChartPlace>& nodes,
                                   DirectLight (*light)(const ChartPlace&)) {
    std::vector<DirectLight> lights;
    for (const ChartPlace& node : nodes) lights.push_back(light(node));
    return lights;
}

void expect_near(const DirectLight& is, const DirectLight& wanted, double most) {
    const DirectLight wrong = is - wanted;
    for (const Rgb& off : {wrong.illuminance, wrong.lobes})
        EXPECT_LT(std::abs(off.r) + std::abs(off.g) + std::abs(off.b), most);
    EXPECT_LT(std::abs(wrong.incident), most);
}

double leverages(const QuadraticFit& fit, const std::vector<ChartPlace>& nodes) {
    double sum = 0;
    for (const ChartPlace& node : nodes) sum += fit.leverage(monomials(node));
    return sum;
}

} // namespace

TEST(QuadraticFit, ReproducesQuadratics) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const std::vector<ChartPlace> nodes = scattered(18, seed);
        const Quadratic<DirectLight> fit =
            QuadraticFit(nodes).to(std::span<const DirectLight>(lights_at(nodes, quadratic)));
        for (const ChartPlace& place : scattered(20, 100 + seed))
            expect_near(fit.at(monomials(place)), quadratic(place), 1e-11);
    }
}

// What the other nodes predict, by leaving each node out in turn.
TEST(QuadraticFit, TellsWhatTheOtherNodesPredict) {
    const std::vector<ChartPlace> nodes = scattered(18, 7);
    const std::vector<DirectLight> lights = lights_at(nodes, lamp_like);
    const QuadraticFit fit(nodes);
    const Quadratic<DirectLight> fitted = fit.to(std::span<const DirectLight>(lights));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        std::vector<ChartPlace> others = nodes;
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
    EXPECT_NEAR(leverages(fit, nodes), 12, 1e-12);
}

TEST(QuadraticFit, LeavesOutWhatNodesOnALineCannotTell) {
    std::vector<ChartPlace> nodes(8);
    for (int i = 0; i < 8; ++i)
        nodes[static_cast<std::size_t>(i)].at = {-1 + i / 4.0, 0.5 - i / 8.0};
    const QuadraticFit fit(nodes);
    EXPECT_NEAR(leverages(fit, nodes), 3, 1e-12);
    const Quadratic<DirectLight> fitted =
        fit.to(std::span<const DirectLight>(lights_at(nodes, quadratic)));
    for (const double x : {-0.9, -0.1, 0.6}) {
        const ChartPlace place{.at = {x, -0.5 * x}};
        expect_near(fitted.at(monomials(place)), quadratic(place), 1e-11);
    }
}

TEST(QuadraticFit, OfOneNodeIsItsLight) {
    const std::vector<ChartPlace> node{{.at = {0.3, -0.2}, .tilt = {0.1, 0}}};
    const QuadraticFit fit(node);
    EXPECT_NEAR(fit.leverage(monomials(node[0])), 1, 1e-14);
    expect_near(fit.to(std::span<const DirectLight>(lights_at(node, lamp_like)))
                    .at(monomials({.at = {5, 7}})),
                lamp_like(node[0]), 1e-14);
}

TEST(QuadraticFit, TellsWhereItExtrapolates) {
    const std::vector<ChartPlace> nodes = scattered(18, 3);
    const QuadraticFit fit(nodes);
    EXPECT_LT(fit.leverage(monomials({})), 2);
    EXPECT_GT(fit.leverage(monomials({.at = {1.5, 1.5}})), 4);
    EXPECT_GT(fit.leverage(monomials({.tilt = {1.5, 1.5}})), 4);
}
