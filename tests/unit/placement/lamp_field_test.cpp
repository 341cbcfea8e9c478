#include "keiko/placement/lamp_field.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

/// Places on the ground along x, seen from (0, 0, 1000).
std::vector<ViewSample> row_of_samples(int count, double step) {
    std::vector<ViewSample> samples(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        ViewSample& s = samples[static_cast<std::size_t>(i)];
        s.eye = {0, 0, 1000};
        s.mirror = {{(i - count / 2) * step, 0, 0}, {0, 0, 1}, {}};
        s.normal = {0, 0, 1};
        s.weight = 1;
    }
    return samples;
}

TEST(LampField, HidesWhatIsBehindATubeAndNotWhatIsSeenBetweenTwo) {
    // Tubes along y, 100 mm before the eye and 20 mm apart.
    CPlane plane;
    plane.origin = {-110, -500, 900};
    plane.u = {0, 1000, 0};
    plane.v = {220, 0, 0};
    plane.lamps = 11;
    plane.pitch = 20;
    plane.diameter = 6;
    LampField field(row_of_samples(801, 1));
    field.place(plane);
    for (std::size_t i = 0; i < field.samples().size(); ++i) {
        // Distance of the way from the eye to the nearest tube's axis.
        const double angle = std::atan2(field.samples()[i].position().x, 1000);
        double least = HUGE_VAL;
        for (int lamp = -5; lamp <= 5; ++lamp)
            least = std::min(least, std::abs(20 * lamp * std::cos(angle) - 100 * std::sin(angle)));
        EXPECT_EQ(field.hidden(i), least < 3) << i;
    }
}

TEST(LampField, HidesNothingBeforeALampOrBeyondItsEnds) {
    CPlane plane;
    plane.origin = {-10, 50, 500};
    plane.u = {0, 1000, 0};
    plane.v = {20, 0, 0};
    plane.lamps = 1;
    plane.diameter = 10;
    LampField beside(row_of_samples(3, 1));
    beside.place(plane);
    plane.origin = {-10, -500, -100};
    LampField below(row_of_samples(3, 1));
    below.place(plane);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_FALSE(beside.hidden(i));
        EXPECT_FALSE(below.hidden(i));
    }
}

} // namespace
} // namespace keiko
