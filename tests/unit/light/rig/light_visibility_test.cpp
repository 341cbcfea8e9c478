#include "keiko/light/rig/light_visibility.h"

#include <gtest/gtest.h>

using namespace keiko;

// Where a shadow comes to an end of a lamp, or parts of it join, its light has a kink.
TEST(LightVisibility, IsAlikeWhereTheSameEndsAreHidden) {
    const LightVisibility whole{IntervalSet::whole()}, hidden{{}, 0, 0};
    const LightVisibility begun{IntervalSet::whole(0.2, 1), 0.8},
        more{IntervalSet::whole(0.6, 1), 0.4};
    const LightVisibility ended{IntervalSet::whole(0, 0.8), 0.8};
    const LightVisibility amid{IntervalSet({{0, 0.3}, {0.6, 1}}), 0.7};
    EXPECT_TRUE(alike(whole, whole));
    EXPECT_TRUE(alike(hidden, hidden));
    EXPECT_TRUE(alike(begun, more));
    for (const auto& [a, b] : {std::pair{whole, hidden},
                               {whole, begun},
                               {begun, ended},
                               {begun, amid},
                               {more, hidden}}) {
        EXPECT_FALSE(alike(a, b));
        EXPECT_FALSE(alike(b, a));
    }
    EXPECT_FALSE(alike({IntervalSet::whole(), 1, 1}, {IntervalSet::whole(), 1, 0.5}));
    EXPECT_FALSE(alike({IntervalSet::whole(), 1, 1}, {IntervalSet::whole(), 0.9, 1}));
}
