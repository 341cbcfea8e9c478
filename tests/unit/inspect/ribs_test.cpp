// Panels with a rib below their seam.
#include "keiko/base/units.h"
#include "keiko/inspect/seams/seam_measure.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

/// Two panels, `gap` mm apart, that bend by an angle. A rib's edge lies between them, at a share of
/// the gap from the first, or there is no rib.
SurfaceModel panels(double gap, double degrees, double share, bool has_rib) {
    test::ModelBuilder builder;
    const double angle = degrees_to_radians(degrees), begin = -share * gap;
    builder.plane({begin - 100, 0, 0}, {100, 0, 0}, {0, 200, 0});
    builder.plane({begin + gap, 0, 0}, {100 * std::cos(angle), 0, 100 * std::sin(angle)},
                  {0, 200, 0});
    if (has_rib) builder.plane({0, 0, 0}, {0, 0, -50}, {0, 200, 0});
    return builder.build();
}

/// The seam of the two panels.
MeasuredSeam seam_of(const SurfaceModel& model) {
    constexpr double join = 0.5; // mm
    for (const MeasuredSeam& seam : measure_seams(model, pair_seams(model, join), {}, join).seams)
        if (seam.face_a == 0 && seam.face_b == 1) return seam;
    ADD_FAILURE() << "not judged";
    return {};
}

TEST(Ribs, HideNeitherKinkNorGapOfThePanelsAboveThem) {
    for (const double share : {0.02, 0.25, 0.4, 0.5, 0.6, 1.0})
        for (const double gap : {0.001, 0.009, 0.0101, 0.012, 0.0195, 0.02, 0.03, 0.1, 0.45})
            for (const double degrees : {0.0, 3.0}) {
                SCOPED_TRACE(testing::Message() << share << ' ' << gap << ' ' << degrees);
                const MeasuredSeam bare = seam_of(panels(gap, degrees, share, false));
                const MeasuredSeam seam = seam_of(panels(gap, degrees, share, true));
                EXPECT_EQ(seam.verdict, bare.verdict);
                EXPECT_NEAR(seam.gap.value, bare.gap.value, 1e-9);
                EXPECT_NEAR(seam.length, bare.length, 1e-6);
                ASSERT_TRUE(seam.angle.has_value());
                EXPECT_NEAR(seam.angle->value, degrees, 1e-9);
            }
}

} // namespace
} // namespace keiko
