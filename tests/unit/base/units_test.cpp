#include "keiko/base/units.h"

#include <gtest/gtest.h>

using keiko::millimetres_per;

TEST(Units, KnowsLengthUnitsInAnyCase) {
    EXPECT_EQ(millimetres_per("mm"), 1);
    EXPECT_EQ(millimetres_per("INCH"), 25.4);
    EXPECT_EQ(millimetres_per("Metre"), 1000);
    EXPECT_EQ(millimetres_per("ft"), 304.8);
    EXPECT_FALSE(millimetres_per("parsec"));
    EXPECT_FALSE(millimetres_per(""));
}
