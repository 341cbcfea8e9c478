#include "keiko/base/error.h"
#include "keiko/radiosity/gauss_seidel.h"
#include "keiko/radiosity/progressive_refinement.h"

#include "tests/support/oracle.h"
#include "tests/unit/radiosity/box_room.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace keiko {
namespace {

using test::box_room;
using test::open_exchange;

std::vector<Reflector> reflectors(const std::vector<double>& rho, const std::vector<double>& M,
                                  std::size_t each) {
    std::vector<Reflector> all;
    for (std::size_t face = 0; face < rho.size(); ++face)
        all.insert(all.end(), each, {Rgb(rho[face]), Rgb(M[face])});
    return all;
}

std::vector<double> areas_of(const ExchangeAreas& exchange) {
    std::vector<double> areas;
    for (std::size_t i = 0; i < exchange.size(); ++i) areas.push_back(exchange.area(i));
    return areas;
}

ProgressiveRefinement shooting(const ExchangeAreas& exchange, std::vector<Reflector> all) {
    return {areas_of(exchange), std::move(all), [&](std::size_t i) { return exchange.row(i); }};
}

TEST(GaussSeidel, SolvesTheCubeOfTheOracle) {
    test::WorstError of_B("B"), of_Fo("Fo"), of_Fa("Fa");
    const ExchangeAreas exchange = open_exchange(box_room(Vec3(1)));
    for (const test::OracleRow& row : test::OracleTable("radiosity_cube")) {
        of_Fo.compare(row, exchange.form_factor(0, 1), row.number("out.Fo"), 1e-10);
        of_Fa.compare(row, exchange.form_factor(0, 2), row.number("out.Fa"), 1e-10);
        const auto all = reflectors(row.list("in.rho"), row.list("in.M0"), 1);
        const SweptRadiosity found = solve_by_gauss_seidel(exchange, all);
        const std::vector<double> expected = row.list("out.B");
        for (std::size_t i = 0; i < 6; ++i)
            of_B.compare(row, found.radiosity[i].g, expected[i], 1e-9);
    }
}

class Box {
public:
    explicit Box(const test::OracleRow& row)
        : n_(row.integer("in.n")),
          exchange_(open_exchange(
              box_room({row.number("in.a"), row.number("in.b"), row.number("in.c")}, n_))),
          reflectors_(reflectors(row.list("in.rho"), row.list("in.M"),
                                 static_cast<std::size_t>(n_ * n_))) {}

    const ExchangeAreas& exchange() const { return exchange_; }
    const std::vector<Reflector>& all() const { return reflectors_; }

private:
    int n_;
    ExchangeAreas exchange_;
    std::vector<Reflector> reflectors_;
};

TEST(GaussSeidel, SolvesTheBoxesOfTheOracle) {
    test::WorstError of_B("B");
    for (const test::OracleRow& row : test::OracleTable("radiosity_box")) {
        const Box box(row);
        const SweptRadiosity found = solve_by_gauss_seidel(box.exchange(), box.all());
        const std::vector<double> expected = row.list("out.B");
        for (std::size_t i = 0; i < expected.size(); ++i)
            of_B.compare(row, found.radiosity[i].r, expected[i], 1e-9);
        EXPECT_NEAR(found.sweeps, row.integer("out.gs_sweeps"), 1) << row.id();
        EXPECT_LT(found.error, 1e-10 * *std::max_element(expected.begin(), expected.end()));
        for (std::size_t i = 0; i < expected.size(); ++i)
            EXPECT_NEAR(box.exchange().row_sum(i), 1, 1e-9 + row.number("out.row_sum_err"));
    }
}

TEST(ProgressiveRefinement, ShootsAsTheOracleDoes) {
    test::WorstError of_B("B_shot");
    for (const test::OracleRow& row : test::OracleTable("radiosity_box")) {
        const Box box(row);
        ProgressiveRefinement light = shooting(box.exchange(), box.all());
        for (const double element : row.list("out.shoot"))
            EXPECT_EQ(static_cast<double>(light.shoot()), element) << row.id();
        const std::vector<double> expected = row.list("out.B_shot");
        for (std::size_t i = 0; i < expected.size(); ++i)
            of_B.compare(row, light.radiosity()[i].b, expected[i], 1e-9);
    }
}

TEST(ProgressiveRefinement, AgreesWithGaussSeidelWithinTheStatedErrors) {
    for (const test::OracleRow& row : test::OracleTable("radiosity_box")) {
        const Box box(row);
        const SweptRadiosity swept = solve_by_gauss_seidel(box.exchange(), box.all());
        for (const double allowed : {1e-1, 1e-3, 1e-9}) {
            ProgressiveRefinement light = shooting(box.exchange(), box.all());
            light.refine(allowed, 100000);
            double missing = 0, all = 0;
            for (std::size_t i = 0; i < box.exchange().size(); ++i) {
                const double area = box.exchange().area(i);
                missing += area * (swept.radiosity[i].g - light.radiosity()[i].g);
                all += area * light.radiosity()[i].g;
            }
            EXPECT_LE(light.remaining(), allowed) << row.id();
            EXPECT_LE(missing / all, light.remaining() + 1e-11) << row.id();
            EXPECT_GT(missing / all, allowed < 1e-6 ? -1e-11 : light.remaining() / 100);
        }
    }
}

// What [Cohen1988] adds it for: the mean is right long before light has arrived.
TEST(ProgressiveRefinement, EstimatesWhatHasNotArrivedByAmbientLight) {
    const ExchangeAreas exchange = open_exchange(box_room({3, 4, 5}, 2));
    std::vector<Reflector> all(exchange.size(), {Rgb(0.7), Rgb()});
    for (std::size_t i = 20; i < 24; ++i) all[i].exitance = Rgb(1000);
    const SweptRadiosity swept = solve_by_gauss_seidel(exchange, all);
    ProgressiveRefinement light = shooting(exchange, all);
    for (int step = 0; step < 4; ++step) light.shoot();
    const auto error = [&](const std::vector<Rgb>& found) {
        double sum = 0;
        for (std::size_t i = 0; i < found.size(); ++i)
            sum += exchange.area(i) * std::abs(found[i].g - swept.radiosity[i].g);
        return sum;
    };
    EXPECT_LT(error(light.with_ambient()), error(light.radiosity()) / 5);
    light.refine(1e-9, 100000);
    EXPECT_LT(light.ambient().g, 1e-5);
}

TEST(ProgressiveRefinement, DoesNotCallLightThatIsNoNumberFinished) {
    const ExchangeAreas exchange = open_exchange(box_room(Vec3(1)));
    const double none = std::numeric_limits<double>::quiet_NaN();
    ProgressiveRefinement light = shooting(exchange, {6, {Rgb(0.5), Rgb(none)}});
    EXPECT_EQ(light.refine(1e-6, 1000), 0);
    EXPECT_FALSE(std::isfinite(light.remaining()));
    EXPECT_EQ(shooting(exchange, {6, {Rgb(0.5), Rgb()}}).remaining(), 0);
}

TEST(ProgressiveRefinement, StopsWithWhatItHas) {
    const ExchangeAreas exchange = open_exchange(box_room(Vec3(1)));
    std::stop_source stop;
    stop.request_stop();
    Job job;
    job.stop = stop.get_token();
    ProgressiveRefinement light = shooting(exchange, {6, {Rgb(0.5), Rgb(100)}});
    EXPECT_THROW(light.refine(1e-6, 1000, job), Cancelled);
    EXPECT_EQ(light.radiosity()[0], Rgb(100));
}

/// Exchange areas of two surfaces by their form factors.
ExchangeAreas two_surfaces(double area1, double F11, double F12, double area2, double F22) {
    return {{area1, area2}, [=](std::size_t i, std::size_t j) {
                return i != j ? area1 * F12 : i == 0 ? area1 * F11 : area2 * F22;
            }};
}

TEST(RadiositySolvers, HaveTheClosedFormsOfEnclosures) {
    test::WorstError of_B1("B1"), of_ind("E_ind"), of_B2("B2"), of_net("net_12");
    constexpr double allowed = 1e-11;
    const auto both = [](const ExchangeAreas& exchange, const std::vector<Reflector>& all) {
        const SweptRadiosity swept = solve_by_gauss_seidel(exchange, all, {1e-16, 10000});
        ProgressiveRefinement light = shooting(exchange, all);
        light.refine(1e-14, 10000);
        for (std::size_t i = 0; i < 2; ++i)
            EXPECT_NEAR(light.radiosity()[i].g, swept.radiosity[i].g, 1e-11 * swept.radiosity[i].g);
        return swept.radiosity;
    };
    for (const test::OracleRow& row : test::OracleTable("enclosure_closed")) {
        const double rho = row.number("in.rho1");
        if (row.text("in.kind") == "sphere") {
            const double R = row.number("in.R"), ports = row.number("in.f");
            const double area = 4 * std::numbers::pi * R * R, direct = row.number("in.Phi") / area;
            EXPECT_NEAR(direct, row.number("out.E_direct"), 1e-11 * direct);
            const double wall = area * (1 - ports);
            // A sphere sees each part of itself by its share; ports are black.
            const ExchangeAreas exchange =
                two_surfaces(wall, 1 - ports, ports, std::max(area * ports, 1e-30), ports);
            const auto B = both(exchange, {{Rgb(rho), Rgb(rho * direct)}, {Rgb(), Rgb()}});
            of_B1.compare(row, B[0].r, row.number("out.B1"), allowed);
            of_ind.compare(row, B[0].r / rho - direct, row.number("out.E_ind"), allowed);
            continue;
        }
        const double F12 = row.number("out.F12"), F21 = row.number("out.F21");
        if (row.text("in.kind") == "spheres") {
            const double ratio = row.number("in.R1") / row.number("in.R2");
            EXPECT_NEAR(row.text("in.shape") == "sphere" ? ratio * ratio : ratio, F21, 1e-14);
        }
        const ExchangeAreas exchange = two_surfaces(1, 0, F12, F12 / F21, row.number("out.F22"));
        const auto B = both(exchange, {{Rgb(rho), Rgb(row.number("in.M1"))},
                                       {Rgb(row.number("in.rho2")), Rgb(row.number("in.M2"))}});
        of_B1.compare(row, B[0].r, row.number("out.B1"), allowed);
        of_B2.compare(row, B[1].r, row.number("out.B2"), allowed);
        of_net.compare(row, F12 * (B[0].r - B[1].r), row.number("out.net_12"), 1e-10);
    }
}

TEST(GaussSeidel, BoundsItsErrorByTheResidual) {
    const ExchangeAreas exchange = open_exchange(box_room({1, 2, 3}));
    const std::vector<Reflector> all(6, {Rgb(0.6), Rgb(100)});
    const SweptRadiosity exact = solve_by_gauss_seidel(exchange, all);
    EXPECT_NEAR(exact.radiosity[3].r, 250, 1e-7); // M / (1 - rho), all alike
    for (const int sweeps : {1, 3, 8}) {
        const SweptRadiosity found = solve_by_gauss_seidel(exchange, all, {0, sweeps});
        const double error = std::abs(found.radiosity[0].r - 250);
        EXPECT_EQ(found.sweeps, sweeps);
        EXPECT_LE(error, found.error);
        EXPECT_GT(error, found.error / 20);
    }
    const std::vector<Reflector> white(6, {Rgb(1), Rgb(1)});
    EXPECT_EQ(solve_by_gauss_seidel(exchange, white, {0, 3}).error,
              std::numeric_limits<double>::infinity());
}

} // namespace
} // namespace keiko
