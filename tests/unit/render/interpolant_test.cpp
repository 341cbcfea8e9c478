#include "keiko/render/lighting/interpolation_test.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <numeric>

using namespace keiko;

namespace {

constexpr int side = 33;

/// Places on a plane.
std::vector<ShadingPoint> spots_of(int width, int height) {
    std::vector<ShadingPoint> points(static_cast<std::size_t>(width) *
                                     static_cast<std::size_t>(height));
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i].sample = i;
        points[i].place.normal = {0, 0, 1};
    }
    return points;
}

/// A light of random coefficients up to a degree in either coordinate.
struct RandomLight {
    RandomLight(test::Random& random, std::size_t degree) {
        for (std::size_t j = 0; j <= degree; ++j)
            for (std::size_t i = 0; i <= degree; ++i)
                for (double& factor : factors[j][i]) factor = test::uniform(random, -1, 1);
    }
    DirectLight at(const Vec2& place) const {
        std::array<double, 7> value{};
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t k = 0; k < 7; ++k)
                    value[k] += factors[j][i][k] * std::pow(place.x / side, i) *
                                std::pow(place.y / side, j);
        return {Rgb(value[0], value[1], value[2]), Rgb(value[3], value[4], value[5]), value[6]};
    }
    double factors[3][3][7] = {};
};

double most_off(const DirectLight& a, const DirectLight& b) {
    const DirectLight off = a - b;
    double most = std::abs(off.incident);
    for (const Rgb& rgb : {off.illuminance, off.lobes})
        most = std::max({most, std::abs(rgb.r), std::abs(rgb.g), std::abs(rgb.b)});
    return most;
}

/// How far a fit is off a light at the places of the grid, by both ways to ask for it.
double most_off(const Interpolant& fit, const ShadingGrid& grid, const RandomLight& light) {
    const auto at_node = [&](const Pixel& p) { return light.at(grid.place(p)); };
    const LightPolynomial polynomial = fit.through(at_node);
    double most = 0;
    for (int y = 0; y < grid.height(); ++y)
        for (int x = 0; x < grid.width(); ++x) {
            const Vec2 place = grid.place({x, y});
            const DirectLight truth = light.at(place);
            most = std::max({most, most_off(polynomial.at(place), truth),
                             most_off(fit.sum(fit.weights(place), at_node), truth)});
        }
    return most;
}

} // namespace

TEST(Interpolant, LinesAndParabolasTellLightOfTheirDegree) {
    test::Random random(31);
    const std::vector<ShadingPoint> points = spots_of(side, side);
    const ShadingGrid grid(side, side, points);
    for (const Rectangle& r : {Rectangle{0, 0, 16, 16}, {16, 7, 31, 23}, {3, 20, 8, 32}}) {
        EXPECT_LT(most_off(Interpolant::lines(grid, r), grid, {random, 1}), 1e-12);
        EXPECT_LT(most_off(Interpolant::parabolas(grid, r), grid, {random, 2}), 1e-10);
        EXPECT_GT(most_off(Interpolant::lines(grid, r), grid, {random, 2}), 1e-2);
    }
}

// One pixel high, one wide, and both: as many degrees as there are places.
TEST(Interpolant, OfNarrowRectanglesIsConstantAcross) {
    test::Random random(32);
    const std::vector<ShadingPoint> points = spots_of(side, side);
    const ShadingGrid grid(side, side, points);
    const RandomLight light(random, 2);
    const auto at_node = [&](const Pixel& p) { return light.at(grid.place(p)); };
    for (const Rectangle& r : {Rectangle{2, 5, 12, 5}, {4, 1, 4, 9}, {7, 7, 7, 7}}) {
        const LightPolynomial found = Interpolant::parabolas(grid, r).through(at_node);
        for (int y = r.y0; y <= r.y1; ++y)
            for (int x = r.x0; x <= r.x1; ++x)
                EXPECT_LT(most_off(found.at(grid.place({x, y})), at_node({x, y})), 1e-12);
    }
    const LightPolynomial row = Interpolant::parabolas(grid, {2, 5, 12, 5}).through(at_node);
    EXPECT_EQ(most_off(row.at({7, 5}), row.at({7, 30})), 0);
}

// In a row whose middle place lies next to its end, rounding would determine a parabola.
TEST(Interpolant, TakesNoMiddleNextToAnEnd) {
    test::Random random(33);
    const std::vector<ShadingPoint> points = spots_of(5, 1);
    std::vector<const ShadingPoint*> row;
    for (const ShadingPoint& point : points) row.push_back(&point);
    const RandomLight line(random, 1), parabola(random, 2);
    const ShadingGrid even(row, {0, 10, 20, 30, 40}), uneven(row, {0, 1e-9, 2e-9, 30, 40});
    const Rectangle all{0, 0, 4, 0};
    EXPECT_LT(most_off(Interpolant::parabolas(even, all), even, parabola), 1e-10);
    EXPECT_LT(most_off(Interpolant::parabolas(uneven, all), uneven, line), 1e-12);
    EXPECT_LT(most_off(Interpolant::parabolas(uneven, all), uneven, parabola), 1);
}
