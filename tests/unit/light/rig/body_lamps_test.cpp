#include "keiko/light/rig/body_lamps.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

const PolygonLight screen{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Rgb(5)};

PolygonLight shining_face() {
    PolygonLight face = screen;
    face.shown = false;
    return face;
}

LightRig rig_of(std::vector<LightSource> sources) {
    LightRig rig;
    rig.sources = std::move(sources);
    return rig;
}

TEST(BodyLamps, AreThoseThatABodyShows) {
    EXPECT_TRUE(is_body_lamp(shining_face()));
    EXPECT_FALSE(is_body_lamp(screen));
    EXPECT_FALSE(is_body_lamp(Sun()));
}

TEST(BodyLamps, AloneAreNoRigOfLamps) {
    EXPECT_TRUE(shines_by_bodies_alone(rig_of({})));
    EXPECT_TRUE(shines_by_bodies_alone(rig_of({shining_face()})));
    EXPECT_FALSE(shines_by_bodies_alone(rig_of({shining_face(), screen})));
    LightRig even = rig_of({shining_face()});
    even.ambient = Rgb(1);
    EXPECT_FALSE(shines_by_bodies_alone(even));
}

TEST(BodyLamps, StayWithTheirBodyUnderAnotherRig) {
    LightRig other = rig_of({Sun()});
    add_body_lamps(std::nullopt, other);
    EXPECT_EQ(other.sources.size(), 1U);
    add_body_lamps(rig_of({screen, shining_face()}), other);
    ASSERT_EQ(other.sources.size(), 2U);
    EXPECT_TRUE(is_body_lamp(other.sources[1]));
}

TEST(BodyLamps, MoveAndShineOutwardsWhenMirrored) {
    LightRig rig = rig_of({screen, shining_face()});
    Affine motion;
    motion.translation = Vec3(0, 0, 7);
    move_body_lamps(motion, rig);
    EXPECT_EQ(std::get<PolygonLight>(rig.sources[0]), screen);
    EXPECT_EQ(std::get<PolygonLight>(rig.sources[1]).corners[1], Vec3(1, 0, 7));
    EXPECT_EQ(std::get<PolygonLight>(rig.sources[1]).normal(), Vec3(0, 0, 1));
    motion.rows[0] = Vec3(-1, 0, 0);
    move_body_lamps(motion, rig);
    EXPECT_EQ(std::get<PolygonLight>(rig.sources[1]).normal(), Vec3(0, 0, 1));
}

} // namespace
} // namespace keiko
