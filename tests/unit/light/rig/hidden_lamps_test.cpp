#include "keiko/light/rig/hidden_lamps.h"

#include "keiko/geometry/model/primitive.h"
#include "keiko/light/rig/primitive_lights.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

const Box3 body{Vec3(-500, -500, 0), Vec3(500, 500, 1000)};

Diagnostics remarks_of(const std::vector<PrimitiveShape>& shapes) {
    LightRig rig;
    for (const PrimitiveShape& shape : shapes)
        for (LightSource& light : lights_of(shape, Rgb(1))) rig.sources.push_back(std::move(light));
    return hidden_lamp_remarks(rig, body);
}

EllipsoidShape globe(const Vec3& center, double r) {
    return {center, {r, 0, 0}, {0, r, 0}, {0, 0, r}};
}

const PlaneShape ceiling{{-2000, -2000, 3000}, {0, 4000, 0}, {4000, 0, 0}}; // shines down

TEST(HiddenLamps, GlobeBelowAPanelIsReported) {
    const Diagnostics remarks = remarks_of({ceiling, globe({0, 0, 2500}, 300)});
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_TRUE(remarks[0].message.starts_with("1 of 2 panels"));
}

/// Bodies of several faces hide their own backs, which do not shine at the body.
TEST(HiddenLamps, LampsBesideEachOtherAreNot) {
    const BoxShape box{{1500, 0, 1500}, {300, 0, 0}, {0, 300, 0}, {0, 0, 300}};
    const FrustumShape can{{-1500, 0, 1500}, {-1500, 300, 1800}, 100, 60, false};
    EXPECT_TRUE(remarks_of({ceiling, box, can, globe({0, 2500, 1500}, 200)}).empty());
    EXPECT_TRUE(remarks_of({}).empty());
}

/// Only the face towards the body is hidden of a box above a globe.
TEST(HiddenLamps, NeighboursOfAHiddenLampAreNot) {
    const BoxShape box{{-150, -150, 2500}, {300, 0, 0}, {0, 300, 0}, {0, 0, 300}};
    const Diagnostics remarks = remarks_of({box, globe({0, 0, 1800}, 200)});
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_TRUE(remarks[0].message.starts_with("1 of 7 panels")) << remarks[0].message;
}

/// The middle of an L is not on it: a globe there hides nothing, one below a leg does.
TEST(HiddenLamps, PanelsAreViewedWhereTheyAre) {
    const PolygonShape angle{{{-900, -900, 3000},
                              {-900, 900, 3000},
                              {-700, 900, 3000},
                              {-700, -700, 3000},
                              {900, -700, 3000},
                              {900, -900, 3000}}}; // shines down
    EXPECT_TRUE(remarks_of({angle, globe({300, 300, 2900}, 90)}).empty());
    EXPECT_EQ(remarks_of({angle, globe({-800, 300, 2600}, 200)}).size(), 1U);
}

/// From behind a panel with one face is neither light nor wall.
TEST(HiddenLamps, DarkFacesHideNothing) {
    const PlaneShape upwards{{-200, -200, 2500}, {400, 0, 0}, {0, 400, 0}};
    EXPECT_TRUE(remarks_of({ceiling, upwards}).empty());
}

} // namespace
} // namespace keiko
