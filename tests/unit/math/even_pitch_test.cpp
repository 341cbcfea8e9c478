#include "keiko/math/even_pitch.h"

#include <gtest/gtest.h>

#include <vector>

namespace keiko {
namespace {

TEST(EvenPitch, IsTheDistanceOfLevelsEquallyFarApart) {
    EXPECT_EQ(even_pitch(std::vector{-1.0, 1.0, 3.0}, 1e-4), 2);
    EXPECT_TRUE(even_pitch(std::vector{0.0, 2.00005, 4.0}, 1e-4));
}

TEST(EvenPitch, OthersHaveNone) {
    EXPECT_FALSE(even_pitch(std::vector{0.0, 2.001, 4.0}, 1e-4));
    EXPECT_FALSE(even_pitch(std::vector{5.0}, 1e-4));
    EXPECT_FALSE(even_pitch(std::vector{5.0, 5.0}, 1e-4));
}

} // namespace
} // namespace keiko
