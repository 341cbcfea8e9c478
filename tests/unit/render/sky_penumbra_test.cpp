#include "keiko/light/sky/sky_irradiance.h"
#include "keiko/math/polygon.h"
#include "keiko/render/shading/occluded_visibility.h"

#include "tests/support/model_builder.h"
#include "tests/support/oracle.h"
#include "tests/support/sky_row.h"
#include <gtest/gtest.h>

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

} // namespace
} // namespace keiko
