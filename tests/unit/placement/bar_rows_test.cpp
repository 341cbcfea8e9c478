#include "keiko/placement/bar_rows.h"

#include "keiko/placement/place_lamps.h"
#include "keiko/scene/view.h"

#include "tests/support/analytic_models.h"
#include <gtest/gtest.h>

#include <algorithm>

namespace keiko {
namespace {

CPlane slanted_row() {
    CPlane row;
    row.origin = {-500, 200, 1500};
    row.u = {0, 1900, 0}, row.v = {1000, 0, 400};
    row.lamps = 5, row.luminance = Rgb(7000, 8000, 9000);
    return row;
}

/// Lamps of a row from one of its ends to the other, as ends of their axes.
std::vector<Segment> axes_of(const CPlane& row) {
    const CPlaneFrame frame(row);
    std::vector<Segment> axes;
    for (int lamp = 0; lamp < frame.lamps; ++lamp)
        axes.push_back({frame.at(0, frame.axis(lamp)), frame.at(frame.length, frame.axis(lamp))});
    return axes;
}

/// True if each lamp of a row is one of another, whichever way both count them.
bool same_lamps(const CPlane& a, const CPlane& b) {
    const std::vector<Segment> others = axes_of(b), own = axes_of(a);
    return std::all_of(own.begin(), own.end(), [&](const Segment& axis) {
        return std::any_of(others.begin(), others.end(), [&](const Segment& other) {
            return std::min((axis.a - other.a).length() + (axis.b - other.b).length(),
                            (axis.a - other.b).length() + (axis.b - other.a).length()) < 1e-9;
        });
    });
}

TEST(BarRows, AScreenIsTheRowThatItWasMadeOf) {
    for (const Vec3& body : {Vec3(0), Vec3(0, 0, 4000)}) {
        LightRig rig{"", lights_of(slanted_row(), LampKind::screen, body)};
        const std::vector<CPlane> rows = rows_of(rig, body);
        ASSERT_EQ(rows.size(), 1U);
        EXPECT_TRUE(same_lamps(rows[0], slanted_row()));
        EXPECT_NEAR(rows[0].v.length(), slanted_row().v.length(), 1e-9);
        EXPECT_EQ(rows[0].luminance, Rgb(7000, 8000, 9000));
        EXPECT_EQ(kind_of(rig, rows), LampKind::screen);
        EXPECT_TRUE(rows_of(rig, Vec3(0, 0, 4000) - body).empty()) << "behind them";
        std::rotate(rig.sources.begin(), rig.sources.begin() + 2, rig.sources.end());
        EXPECT_EQ(rows_of(rig, body).size(), 1U) << "in any order";
        std::get<PolygonLight>(rig.sources[0]).corners.pop_back();
        EXPECT_EQ(rows_of(rig, body).size(), 4U) << "bars of an uneven row stand alone";
    }
}

TEST(BarRows, APanelIsARowOfOneLampAsLargeAsItself) {
    const LightRig rig{"", lights_of(slanted_row(), LampKind::panel, Vec3(0))};
    const std::vector<CPlane> rows = rows_of(rig, Vec3(0));
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].lamps, 1);
    EXPECT_NEAR(rows[0].u.length(), 1900, 1e-9);
    EXPECT_NEAR(rows[0].v.length(), slanted_row().v.length(), 1e-9);
    EXPECT_EQ(kind_of(rig, rows), LampKind::panel);
}

TEST(BarRows, TubesComeFirst) {
    LightRig rig{"", lights_of(slanted_row(), LampKind::screen, Vec3(0))};
    rig.sources.emplace_back(slanted_row());
    const std::vector<CPlane> rows = rows_of(rig, Vec3(0));
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_GT(rows[0].diameter, 0);
    EXPECT_EQ(kind_of(rig, rows), LampKind::tube);
}

TEST(BarRows, RatingAPlacedScreenReportsWhatPlacingReported) {
    const SurfaceModel model = test::bonnet_model(1100, 1400, 60);
    const Tracer tracer(model);
    const Camera camera = frame_view("high-front", tracer.bounds(), {.width = 320, .height = 180});
    PlacementOptions options;
    options.sampling.samples = 4000;
    const auto samples = [&] {
        return sample_views(tracer, model, std::span(&camera, 1), options.sampling);
    };
    for (const LampKind kind : {LampKind::screen, LampKind::panel}) {
        options.kind = kind;
        const Placement placed =
            place_lamps(samples(), model, tracer.bounds(), camera.height, options);
        const Placement rated = rated_rig(samples(), model, camera.height, placed.rig);
        EXPECT_EQ(rated.kind, kind);
        EXPECT_NEAR(rated.coverage, placed.coverage, 1e-9);
        EXPECT_EQ(rated.planes.size(), placed.planes.size());
        if (kind == LampKind::panel) continue;
        EXPECT_NEAR(rated.stripes.median, placed.stripes.median, 1e-6);
        EXPECT_NEAR(rated.stripes.in_range, placed.stripes.in_range, 1e-3);
    }
}

} // namespace
} // namespace keiko
