#include "keiko/base/text.h"

#include <gtest/gtest.h>

#include <vector>

namespace keiko {
namespace {

const std::vector<std::string> words{"pitch", "lamps", "luminance", "luminous_flux"};

TEST(Suggestion, FindsTheNearestWord) {
    EXPECT_EQ(did_you_mean("ptich", words), " (did you mean 'pitch'?)");
    EXPECT_EQ(did_you_mean("Lamps", words), " (did you mean 'lamps'?)");
    EXPECT_EQ(did_you_mean("lumninance", words), " (did you mean 'luminance'?)");
    EXPECT_EQ(did_you_mean("luminousflux", words), " (did you mean 'luminous_flux'?)");
}

TEST(Suggestion, StaysSilentWhereNothingIsNear) {
    EXPECT_EQ(did_you_mean("diameter", words), "");
    EXPECT_EQ(did_you_mean("", words), "");
    EXPECT_EQ(did_you_mean("pitch", {}), "");
    EXPECT_EQ(did_you_mean("v", std::vector<std::string>{"u"}), "") << "nothing in common";
}

TEST(Suggestion, ListsWords) {
    EXPECT_EQ(comma_list(words), "pitch, lamps, luminance, luminous_flux");
    EXPECT_EQ(comma_list({}), "");
}

} // namespace
} // namespace keiko
