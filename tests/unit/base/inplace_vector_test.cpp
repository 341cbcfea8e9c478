#include "keiko/base/memory.h"

#include <gtest/gtest.h>

#include <span>

namespace keiko {
namespace {

TEST(InplaceVector, KeepsWhatItTakesInOrder) {
    InplaceVector<int, 3> list;
    EXPECT_TRUE(list.empty());
    for (const int value : {5, 7, 9}) list.push_back(value);
    const std::span<const int> all(list);
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[0], 5);
    EXPECT_EQ(all[1], 7);
    EXPECT_EQ(list.back(), 9);
}

TEST(InplaceVector, RefusesMoreThanItHolds) {
    InplaceVector<int, 1> list;
    list.push_back(1);
    EXPECT_THROW(list.push_back(2), std::length_error);
    EXPECT_EQ(list.size(), 1U);
}

} // namespace
} // namespace keiko
