#include "keiko/film/film.h"

#include "keiko/base/error.h"

#include <gtest/gtest.h>

using namespace keiko;

TEST(Aov, NamesLeadBackToTheAov) {
    EXPECT_EQ(every_aov().size(), 9u);
    for (const Aov aov : every_aov()) EXPECT_EQ(aov_by_name(name_of(aov)), aov);
}

TEST(Aov, ChannelsAreNamed) {
    EXPECT_EQ(name_of(Aov::c_plane_uv), "c_plane_uv");
    EXPECT_EQ(channel_names(Aov::normal), (std::vector<std::string>{"X", "Y", "Z"}));
    EXPECT_EQ(channel_names(Aov::luminance), (std::vector<std::string>{"Y"}));
    EXPECT_EQ(channel_names(Aov::face), (std::vector<std::string>{"id"}));
}

TEST(Aov, AnUnknownNameListsTheKnownOnes) {
    try {
        aov_by_name("normals");
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("\"normals\""), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("luminance, normal, uv, face"), std::string::npos);
    }
}

TEST(Image, PixelsLieInRowsFromTheTop) {
    Image image(3, 2, 2, 7);
    EXPECT_EQ(image.values.size(), 12u);
    image.pixel(2, 1)[1] = 5;
    EXPECT_EQ(image.values.back(), 5);
    EXPECT_EQ(image.pixel(0, 0)[0], 7);
}
