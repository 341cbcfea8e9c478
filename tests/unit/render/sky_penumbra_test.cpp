#include "keiko/light/sky/sky_irradiance.h"
#include "keiko/math/axes.h"
#include "keiko/math/quadrature.h"
#include "keiko/render/shading/occluded_visibility.h"

#include "tests/support/analytic_models.h"
#include "tests/support/model_builder.h"
#include "tests/support/oracle.h"
#include "tests/support/sky_row.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using namespace test;

/// The plate outside of the window of a row of sky_window.
SurfaceModel plate_of(const OracleRow& row) {
    const std::vector<Vec3> corners = row.points("in.ob");
    ModelBuilder builder;
    if (!corners.empty())
        builder.patch(1, 1, {corners[0], corners[3], corners[1], corners[2]});
    else
        builder.patch(1, 1, {{0, 0, -9e5}, {0, 1, -9e5}, {1, 0, -9e5}, {1, 1, -9e5}}); // unseen
    return builder.build();
}

/// A point in a room whose window shows the sky beside a plate.
class Room {
public:
    explicit Room(const OracleRow& row)
        : model_(plate_of(row)),
          tracer_(model_),
          occluders_(model_, tracer_),
          point_(row.vector("in.P")),
          normal_(row.unit("in.N")) {}

    /// lx from the sky and from the ground; with `hidden` those that the plate hides.
    Rgb illuminance(const SkyLight& sky, bool hidden, const WidthOptions& options) const {
        Rgb sum;
        for (int i = 0; i < panel_count(sky); ++i) {
            const auto panel = sky_panel(sky, i, point_);
            if (!panel) continue;
            const OccludedVisibility visible(&occluders_, tracer_, Viewpoint::at(point_),
                                             panel->outline.corners, {}, normal_);
            const double share = visible_share(sky, *panel, point_, normal_, visible, options);
            sum += illuminance_from(sky, *panel, point_, normal_) * (hidden ? 1 - share : share);
        }
        return sum;
    }

private:
    SurfaceModel model_;
    Tracer tracer_;
    Occluders occluders_;
    Vec3 point_, normal_;
};

TEST(SkyPenumbra, WindowWithAPlateOutsideMeetsTheOracle) {
    int plates = 0;
    for (const OracleRow& row : OracleTable("sky_window")) {
        const Room room(row);
        const SkyLight sky = sky_of_window(row, row.vector("in.a"), row.vector("in.b"));
        const double free = row.number("out.E_free"), tau = row.number("in.tau");
        plates += row.has("in.ob");
        const auto lx = [&](double tolerance) {
            return tau * room.illuminance(sky, false, {tolerance, 0.12, true}).g;
        };
        EXPECT_NEAR(lx(5e-5), row.number("out.E_sky"), 1e-4 * free + 1e-9) << row.id();
        EXPECT_NEAR(lx(1e-7), row.number("out.E_sky"), 2e-6 * free + 1e-9) << row.id();
        // What the plate hides of uniform surroundings is what a uniform plate sends.
        SkyLight even = sky;
        even.model = SkyModel::uniform, even.luminance = even.ground = Rgb(1);
        const double all = room.illuminance(even, false, {1e-7, 0.12, true}).g;
        const double plate = room.illuminance(even, true, {1e-7, 0.12, true}).g;
        EXPECT_NEAR(tau * row.number("in.Lob") * plate, row.number("out.E_ob"),
                    2e-6 * tau * row.number("in.Lob") * (all + plate) + 1e-9)
            << row.id();
    }
    EXPECT_GE(plates, 5);
}

/// Light of a sky that a cone of directions sends, by quadrature around its axis.
double from_cone(const SkyLight& sky, const Vec3& axis, double half_angle, const Vec3& normal) {
    const SkyDistribution shares(sky);
    const Vec3 x = any_perpendicular(axis).normalized(), y = axis.cross(x);
    constexpr int spokes = 180;
    return integrate(
        [&](double theta) {
            double ring = 0;
            for (int i = 0; i < spokes; ++i) {
                const double phi = i * 2 * std::numbers::pi / spokes;
                const Vec3 across = x * std::cos(phi) + y * std::sin(phi);
                const Vec3 w = axis * std::cos(theta) + across * std::sin(theta);
                ring += std::max(0.0, normal.dot(w)) * shares(w);
            }
            return ring * std::sin(theta) * 2 * std::numbers::pi / spokes;
        },
        0, half_angle, 48);
}

/// A ball in the sky hides a cone of it, which does not reach the horizon, from level and tilted
/// surfaces; over borders between quarters too.
TEST(SkyPenumbra, BallHidesItsConeOfTheOpenSky) {
    for (const SkyModel model :
         {SkyModel::uniform, SkyModel::overcast, SkyModel::gradient, SkyModel::clear})
        for (const Vec3& center : {Vec3(900, 200, 1500), Vec3(-700, 800, 1200)}) {
            constexpr double radius = 600;
            SkyLight sky{model, Rgb(1)};
            sky.horizon = 2, sky.sun = Vec3(-0.4, -0.6, 0.5).normalized();
            const SurfaceModel ball = sphere_model(stretched(Vec3(radius), {0, 0, 1}, center));
            const Tracer tracer(ball);
            const Occluders occluders(ball, tracer);
            for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(0.28, 0.36, 0.89).normalized()}) {
                double lx = 0, all = 0;
                for (int i = 0; i < panel_count(sky); ++i) {
                    const SkyPanel panel = *sky_panel(sky, i, Vec3(0));
                    const OccludedVisibility visible(&occluders, tracer, Viewpoint::at(Vec3(0)),
                                                     panel.outline.corners, {}, normal);
                    const double whole = illuminance_from(sky, panel, Vec3(0), normal).r;
                    all += whole;
                    lx += whole *
                          visible_share(sky, panel, Vec3(0), normal, visible, {5e-5, 0.12, true});
                }
                const double hidden = from_cone(sky, center.normalized(),
                                                std::asin(radius / center.length()), normal);
                EXPECT_NEAR(lx, all - hidden, 1e-4 * all) << static_cast<int>(model);
                EXPECT_GT(hidden, 0.02 * all);
            }
        }
}

} // namespace
} // namespace keiko
