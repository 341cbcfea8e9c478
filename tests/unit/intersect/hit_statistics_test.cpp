#include "keiko/intersect/hit/hit.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

Hit hit_with(HitFlags flags) {
    Hit hit;
    hit.flags = flags;
    return hit;
}

TEST(HitStatistics, CountsEachHitOnce) {
    HitStatistics counts;
    counts.count(hit_with(HitFlags::none));
    counts.count(hit_with(HitFlags::seam));
    counts.count(hit_with(HitFlags::clipped));
    counts.count(hit_with(HitFlags::clipped | HitFlags::tangential));
    EXPECT_EQ(counts, (HitStatistics{.unique = 2, .clipped = 1, .tangential = 1}));
    HitStatistics sum = counts;
    sum += counts;
    EXPECT_EQ(sum.sum(), 8u);
}

TEST(HitStatistics, ReadsAsShares) {
    EXPECT_EQ(path_text({.unique = 2, .clipped = 1, .tangential = 1}),
              "4 hits: 50.00 % unique, 25.00 % clipped, 25.00 % tangential");
    EXPECT_EQ(path_text({}), "0 hits: 0.00 % unique, 0.00 % clipped, 0.00 % tangential");
}

} // namespace
} // namespace keiko
