#include "keiko/files/scene/rig_file.h"

#include "tests/support/rig_text.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using test::rig_error;

const std::string head = "format = \"keiko-rig/1\"\n";
const std::string board =
    "[[sign]]\ncorners = [[0, 0, 2000], [0, 500, 2000], [900, 500, 2000], [900, 0, 2000]]\n";
const std::string bar =
    "[[sign.legend]]\ncorners = [[100, 100, 2000], [200, 100, 2000], [200, 400, 2000], [100, 400, "
    "2000]]\n";

TEST(SignTable, IsReadWithItsLegend) {
    const LightRig rig = parse_rig(
        head + board + "luminance = 25\n" + bar + "luminance = [1, 0.5, 0]\ncolor = 200\n",
        "rig.toml");
    ASSERT_EQ(rig.signs.size(), 1U);
    const LuminousSign& sign = rig.signs[0];
    EXPECT_EQ(sign.panel.luminance, Rgb(25));
    ASSERT_EQ(sign.legend.size(), 1U);
    EXPECT_EQ(sign.legend[0].luminance, Rgb(200, 100, 0));
    EXPECT_EQ(sign.legend[0].normal(), sign.panel.normal()) << "whichever way its corners run";
    ASSERT_EQ(rig.sources.size(), 2U);
    EXPECT_EQ(std::get<PolygonLight>(rig.sources[1]), sign.legend[0]);
}

/// The panels of a sign are not written a second time, and sources stay in order.
TEST(SignTable, WhatIsWrittenReadsBackTheSame) {
    const std::string globe = "[[sphere]]\ncenter = [1, 2, 3]\nradius = 150\n";
    const LightRig rig = parse_rig(head + globe + board + bar + board + bar + globe, "rig.toml");
    const LightRig again = parse_rig(rig_text(rig, ""), "again.toml");
    EXPECT_EQ(rig_text(again, ""), rig_text(rig, ""));
    EXPECT_EQ(again.signs, rig.signs);
    ASSERT_EQ(again.sources.size(), 6U);
    for (const std::size_t sphere : {0U, 5U})
        EXPECT_TRUE(std::holds_alternative<SphereLight>(again.sources[sphere]));
}

TEST(SignTable, PanelsThatWereTakenAwayAreNotWritten) {
    LightRig rig = parse_rig(head + board + bar, "rig.toml");
    rig.sources.erase(rig.sources.begin());
    const LightRig again = parse_rig(rig_text(rig, ""), "again.toml");
    EXPECT_TRUE(again.signs.empty());
    EXPECT_EQ(again.sources.size(), 1U);
}

TEST(SignTable, BadLegendsAreNamed) {
    const auto with = [](const std::string& corners) {
        return rig_error(head + board + bar + "[[sign.legend]]\ncorners = " + corners + "\n");
    };
    const std::string at = "bad.toml:7:11: sign[0].legend[1].corners: ";
    EXPECT_EQ(with("[[300, 100, 2000], [400, 100, 2000], [400, 200, 2001]]"),
              at + "must lie in the plane of the sign");
    const std::string inside = at + "must lie inside of the sign, apart from its outline";
    EXPECT_EQ(with("[[300, 100, 2000], [1400, 100, 2000], [400, 200, 2000]]"), inside);
    EXPECT_EQ(with("[[1300, 100, 2000], [1400, 100, 2000], [1400, 200, 2000]]"), inside);
    EXPECT_EQ(with("[[300, 0, 2000], [400, 0, 2000], [400, 200, 2000]]"), inside);
    const std::string apart = at + "must lie apart from legend 1";
    EXPECT_EQ(with("[[150, 150, 2000], [400, 150, 2000], [400, 200, 2000]]"), apart);
    EXPECT_EQ(with("[[120, 150, 2000], [140, 150, 2000], [140, 200, 2000]]"), apart);
    EXPECT_EQ(with("[[50, 50, 2000], [300, 50, 2000], [300, 450, 2000], [50, 450, 2000]]"), apart);
    EXPECT_EQ(with("[[200, 100, 2000], [400, 150, 2000], [400, 200, 2000]]"), apart) << "touches";
    EXPECT_EQ(with("[[300, 100, 2000], [400, 100, 2000]]"), at + "must be at least 3 corners");
    EXPECT_EQ(rig_error(head + "[[sign]]\n"), "bad.toml:2:1: sign[0]: 'corners' is missing");
    EXPECT_TRUE(rig_error(head + board + "luminance = -1\n")
                    .starts_with("bad.toml:4:13: sign[0].luminance: "));
    EXPECT_TRUE(rig_error(head + board + bar + "lumen = 1\n").starts_with("bad.toml:6:1: "));
}

} // namespace
} // namespace keiko
