#include "keiko/inspect/seams/class_stretches.h"

#include "tests/unit/inspect/sloped_seam.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using test::SeamSlope;
using test::SlopedSeam;

TEST(RunOutPlaces, HoldThePlacesWhereACreaseFades) {
    const SeamSlope slope{{{100, {8, 8, 8, 8}}, {160, {8, 8, 0, 0}}, {260, {0, 0, 0, 0}}}};
    const SlopedSeam seam(slope);
    const StretchLimits limits;
    const RunOutPlaces places(seam.probes(), limits);
    const double begin = slope.place_of(limits.feature_angle, 100, 160);
    const double end = slope.place_of(limits.angle, 100, 160);
    constexpr double reach = 0.02; // mm
    for (const double x : {begin - 0.01, begin, (begin + end) / 2, end, end + 0.01})
        EXPECT_TRUE(places.hold({x, 0, 0}, reach)) << x;
    for (const double x : {50.0, begin - 0.03, end + 0.03, 200.0})
        EXPECT_FALSE(places.hold({x, 0, 0}, reach)) << x;
    const double middle = (begin + end) / 2;
    EXPECT_TRUE(places.hold({middle, 0, 0.019}, reach));
    EXPECT_FALSE(places.hold({middle, 0, 0.021}, reach));
}

TEST(RunOutPlaces, HoldNothingWhereNoCreaseFades) {
    // To a plateau, and a peak that is shorter than what would be its run-out.
    for (const SeamSlope& slope :
         {SeamSlope{{{100, {8, 8, 8, 8}}, {160, {8, 8, 2, 2}}, {260, {2, 2, 2, 2}}}},
          SeamSlope{{{100, {0, 0, 5.1, 5.1}}, {200, {5.1, 5.1, 0, 0}}}}}) {
        const SlopedSeam seam(slope);
        const RunOutPlaces places(seam.probes(), {});
        for (double x = 0; x <= slope.length(); x += 5)
            EXPECT_FALSE(places.hold({x, 0, 0}, 1)) << x;
    }
}

TEST(RunOutPlaces, CountTheCreaseBeyondTheEndOfItsLine) {
    // Only some 15 mm of the crease are on the line of its run-out of some 30 mm.
    const SlopedSeam seam({{{100, {8, 8, 8, 8}}, {160, {8, 8, 0, 0}}, {260, {0, 0, 0, 0}}}});
    const SeamProbe& whole = seam.probes().front();
    const auto part = [&](double from, double to) {
        return whole.part(whole.at(from / 260), whole.at(to / 260));
    };
    const std::vector<SeamProbe> own{part(110, 260)};
    const Vec3 fading(140, 0, 0);
    EXPECT_FALSE(RunOutPlaces(own, {}).hold(fading, 1));
    const auto beyond = [&](double from, double to) {
        return RunOutPlaces(own, {}, [&, from, to] { return std::vector{part(from, to)}; });
    };
    EXPECT_TRUE(beyond(0, 110).hold(fading, 1));
    EXPECT_FALSE(beyond(0, 100).hold(fading, 1));   // does not touch it
    EXPECT_FALSE(beyond(108, 110).hold(fading, 1)); // still shorter
    EXPECT_FALSE(beyond(200, 260).hold(fading, 1)); // no crease
}

} // namespace
} // namespace keiko
