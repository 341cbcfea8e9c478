#include "keiko/light/sky/sky_irradiance.h"

#include "keiko/light/luminance/irradiance_tensor.h"
#include "keiko/math/quadrature.h"

#include "tests/support/oracle.h"
#include "tests/support/random.h"
#include "tests/support/sky_row.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using std::numbers::pi;

Vec3 tilted(double tilt, double azimuth) {
    return {std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth), std::cos(tilt)};
}

TEST(SkyIrradiance, OpenSkyMeetsTheOracle) {
    constexpr double degrees = pi / 180;
    test::WorstError closed("E"), by_rule("E_clear");
    for (const test::OracleRow& row : test::OracleTable("sky")) {
        const SkyLight sky = test::sky_of(row, row.number("in.sun_el") * degrees, 0);
        const Vec3 normal =
            tilted(row.number("in.beta_deg") * degrees, row.number("in.az_deg") * degrees);
        const double lx = sky.luminance.r * unobstructed_illuminance(sky, normal);
        const bool clear = sky.model == SkyModel::clear;
        (clear ? by_rule : closed).compare(row, lx, row.number("out.E"), clear ? 1e-6 : 1e-11);
    }
}

TEST(SkyIrradiance, WindowMeetsTheOracleWithoutObstruction) {
    test::WorstError uniform("E_uniform"), overcast("E_overcast"), clear("E_clear");
    for (const test::OracleRow& row : test::OracleTable("sky_window")) {
        const SkyLight sky = test::sky_of_window(row, row.vector("in.a"), row.vector("in.b"));
        const Vec3 point = row.vector("in.P"), normal = row.unit("in.N");
        const auto panel = sky_panel(sky, 0, point);
        const double lx = panel ? illuminance_from(sky, *panel, point, normal).r : 0;
        const bool even = sky.model == SkyModel::uniform, around_sun = sky.model == SkyModel::clear;
        (even         ? uniform
         : around_sun ? clear
                      : overcast)
            .compare(row, row.number("in.tau") * lx, row.number("out.E_free"),
                     even         ? 1e-11
                     : around_sun ? 1e-6
                                  : 1e-8,
                     1e-9);
    }
}

TEST(SkyIrradiance, OutdoorsIlluminanceOfTheOracleFollows) {
    for (const test::OracleRow& row : test::OracleTable("sky_window")) {
        if (!row.has("out.E_out")) continue;
        const SkyLight sky = test::sky_of_window(row, row.vector("in.a"), row.vector("in.b"));
        const double out = sky.luminance.r * unobstructed_illuminance(sky, {0, 0, 1});
        EXPECT_NEAR(out, row.number("out.E_out"), 1e-11 * out) << row.id();
        const double within = row.number("out.E_sky") + row.number("out.E_ob");
        EXPECT_NEAR(within / out, row.number("out.DF"), 1e-12) << row.id();
    }
}

/// Sum over directions of a whole sky, by the midpoint rule in elevation and azimuth.
double summed(const SkyLight& sky, const Vec3& normal) {
    constexpr int rings = 300, spokes = 600;
    const SkyDistribution shares(sky);
    double sum = 0;
    for (int i = 0; i < rings; ++i)
        for (int k = 0; k < spokes; ++k) {
            const double zenith = (i + 0.5) * pi / 2 / rings, azimuth = (k + 0.5) * 2 * pi / spokes;
            const Vec3 w = tilted(zenith, azimuth);
            sum += std::max(0.0, normal.dot(w)) * shares(w) * std::sin(zenith);
        }
    return sum * (pi / 2 / rings) * (2 * pi / spokes);
}

TEST(SkyIrradiance, OpenSkyIsTheSumOverDirections) {
    test::Random random(7);
    for (const SkyModel model :
         {SkyModel::uniform, SkyModel::overcast, SkyModel::gradient, SkyModel::clear}) {
        SkyLight sky{model};
        sky.horizon = 2.5;
        sky.sun = Vec3(0.5, -0.3, 0.6).normalized();
        for (int i = 0; i < 4; ++i) {
            const Vec3 normal = test::random_direction(random);
            const double lx = unobstructed_illuminance(sky, normal);
            EXPECT_NEAR(lx, summed(sky, normal), 2e-5 * (lx + 1)) << static_cast<int>(model);
        }
    }
}

/// Quarters of the sky and of the ground that shines as much as a uniform sky: of any surface, all
/// of its hemisphere.
TEST(SkyIrradiance, PanelsAddUpToTheWhole) {
    test::Random random(8);
    for (const SkyModel model : {SkyModel::uniform, SkyModel::overcast, SkyModel::gradient}) {
        SkyLight sky{model, Rgb(1)};
        sky.horizon = 0.2, sky.ground = Rgb(0.5);
        ASSERT_EQ(panel_count(sky), 8);
        for (int i = 0; i < 20; ++i) {
            const Vec3 normal = test::random_direction(random),
                       point = test::random_direction(random) * 500;
            double above = 0, below = 0;
            for (int k = 0; k < 8; ++k) {
                const auto panel = sky_panel(sky, k, point);
                const double lx = illuminance_from(sky, *panel, point, normal).g;
                (panel->ground ? below : above) += lx;
            }
            EXPECT_NEAR(above, unobstructed_illuminance(sky, normal), 2e-9);
            EXPECT_NEAR(below, pi / 4 * (1 - normal.z), 1e-9);
        }
    }
}

/// A plane wall through a place that hides what is beyond it, and counts the lines that are asked.
class Wall final : public Visibility {
public:
    /// The wall hides the places at which `normal` times them exceeds `distance`.
    Wall(const Vec3& normal, double distance) : normal_(normal), distance_(distance) {}

    int lines() const { return lines_; }
    using Visibility::intervals;
    IntervalSet intervals(const Segment& line) const override {
        ++lines_;
        const double a = normal_.dot(line.a) - distance_, b = normal_.dot(line.b) - distance_;
        if (a <= 0 && b <= 0) return IntervalSet::whole();
        if (a >= 0 && b >= 0) return {};
        return a < 0 ? IntervalSet::whole(0, a / (a - b)) : IntervalSet::whole(a / (a - b), 1);
    }

private:
    Vec3 normal_;
    double distance_;
    mutable int lines_ = 0;
};

/// In pictures the corners of a quarter, which light next to nothing, need no lines.
TEST(SkyIrradiance, SharesOfPanelsAddUpToOne) {
    SkyLight sky{SkyModel::uniform, Rgb(40, 50, 20)};
    sky.ground = Rgb(10, 5, 4);
    for (const double tilt : {0.0, 0.4, 1.5, 2.7, pi}) {
        const Vec3 normal = tilted(tilt, 0.3);
        double sum = 0;
        for (int i = 0; i < panel_count(sky); ++i)
            sum += panel_share(sky, *sky_panel(sky, i, Vec3(0)), Vec3(0), normal);
        EXPECT_NEAR(sum, 1, 1e-12) << tilt;
    }
    const SkyPanel quarter = *sky_panel(sky, 0, Vec3(0));
    EXPECT_NEAR(panel_share(sky, quarter, Vec3(0), Vec3(0, 0, 1)), 0.25, 1e-12);
}

TEST(SkyIrradiance, CornersOfAQuarterTakeNoLines) {
    const SkyLight sky{SkyModel::overcast, Rgb(1)};
    const SkyPanel panel = *sky_panel(sky, 0, Vec3(0));
    const Vec3 up(0, 0, 1);
    const Wall nowhere(up, 1e9);
    EXPECT_EQ(visible_share(sky, panel, Vec3(0), up, nowhere, {3e-3, 1, false, true}), 1);
    EXPECT_EQ(nowhere.lines(), 7);
    for (const Vec3& side : {Vec3(0, 0, -1), Vec3(0.3, 1, 0.1), Vec3(0.2, -0.4, -1)})
        for (const double distance : {-4e6, -1e6, 0.0, 2e6}) {
            const Wall wall(side, distance);
            EXPECT_NEAR(visible_share(sky, panel, Vec3(0), up, wall, {3e-3, 1, false, true}),
                        visible_share(sky, panel, Vec3(0), up, wall, {1e-6, 0.12, false}), 3e-3)
                << side << ' ' << distance;
        }
}

/// The second moments of a triangle against a quadrature over it, of either orientation.
TEST(IrradianceTensor, IsTheIntegralOverThePolygon) {
    test::Random random(9);
    for (int i = 0; i < 10; ++i) {
        const auto corner = [&] { return test::random_direction(random) + Vec3(0, 0, 2); };
        const Vec3 p = corner(), q = corner(), r = corner(), plane = (q - p).cross(r - p);
        const Vec3 a = test::random_direction(random), b = test::random_direction(random);
        const double sum = integrate(
            [&](double s) {
                return integrate(
                    [&](double t) {
                        const Vec3 at = p + (q - p) * s + (r - p) * (t * (1 - s));
                        const double l = at.length();
                        return a.dot(at) * b.dot(at) * std::abs(plane.dot(at)) * (1 - s) /
                               (l * l * l * l * l);
                    },
                    0, 1, 48);
            },
            0, 1, 48);
        EXPECT_NEAR(second_irradiance_moment(std::vector{p, q, r}, a, b), sum, 1e-8);
        EXPECT_NEAR(second_irradiance_moment(std::vector{r, q, p}, a, b), sum, 1e-8);
    }
}

} // namespace
} // namespace keiko
