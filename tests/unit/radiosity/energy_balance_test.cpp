#include "keiko/radiosity/energy_balance.h"

#include "keiko/radiosity/gauss_seidel.h"
#include "keiko/radiosity/progressive_refinement.h"

#include "tests/unit/radiosity/box_room.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

struct Room {
    ExchangeAreas exchange;
    std::vector<Reflector> reflectors;
};

Room room(const std::vector<std::vector<Vec3>>& elements) {
    std::vector<Reflector> reflectors(elements.size(), {Rgb(0.8, 0.5, 0.2), Rgb()});
    reflectors[0].exitance = Rgb(1000, 500, 100);
    return {test::open_exchange(elements), reflectors};
}

TEST(EnergyBalance, HasAllLightAbsorbedInAClosedRoom) {
    const Room closed = room(test::box_room({2000, 3000, 1000}));
    const EnergyBalance balance = solve_by_gauss_seidel(closed.exchange, closed.reflectors).balance;
    EXPECT_NEAR(balance.emitted.r, 1000 * 3, 1e-9); // 3 m2
    EXPECT_NEAR(balance.absorbed.r, balance.emitted.r, 1e-6);
    EXPECT_NEAR(balance.escaped.b, 0, 1e-6);
    EXPECT_NEAR(balance.missing().g, 0, 1e-6);
}

TEST(EnergyBalance, CountsWhatLeavesThroughAnOpenSide) {
    auto elements = test::box_room({2000, 3000, 1000});
    elements.pop_back();
    const Room open = room(elements);
    const EnergyBalance swept = solve_by_gauss_seidel(open.exchange, open.reflectors).balance;
    EXPECT_GT(swept.escaped.r, 0.1 * swept.emitted.r);
    EXPECT_NEAR(swept.missing().r, 0, 1e-6);
    std::vector<double> areas;
    for (const auto& corners : elements) areas.push_back(test::area_of(corners));
    ProgressiveRefinement light(areas, open.reflectors,
                                [&](std::size_t i) { return open.exchange.row(i); });
    light.refine(1e-10, 10000);
    EXPECT_NEAR(light.balance().escaped.r, swept.escaped.r, 1e-5);
    EXPECT_NEAR(light.balance().absorbed.g, swept.absorbed.g, 1e-5);
}

TEST(EnergyBalance, MissesWhatIsNotSolvedYet) {
    const Room closed = room(test::box_room({2000, 3000, 1000}));
    const auto found = solve_by_gauss_seidel(closed.exchange, closed.reflectors, {0, 1});
    EXPECT_GT(std::abs(found.balance.missing().r), 10);
}

} // namespace
} // namespace keiko
