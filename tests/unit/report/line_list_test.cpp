#include "keiko/report/content/line_list.h"

#include "tests/unit/report/sample_report.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using namespace test;

TEST(Lines, AreRankedThroughAllViewsAndThoseWithoutAVerdictAreNot) {
    const LineList list = lines();
    const std::vector<CrossingPlace> ranked = ranked_crossings(list);
    ASSERT_EQ(ranked.size(), 3u);
    EXPECT_EQ(ranked[0].in(list).faces, "bad <1>");
    EXPECT_EQ(ranked[1].in(list).faces, "near");
    EXPECT_EQ(ranked[2].in(list).faces, "good");
    EXPECT_EQ(count_crossings(list).not_judged, 1u);
}

TEST(Lines, TableHasRanksAndSignsAndNoMinusZero) {
    LineList list = lines();
    list.views[0].found.crossings[0].jump.value = -1e-9;
    const std::string table = crossings_table(list, 2);
    EXPECT_NE(table.find("\n  1  fail           2.5    0.0000  -0.2500   4.0000"),
              std::string::npos)
        << table;
    EXPECT_EQ(table.find("-0.0000"), std::string::npos) << table;
    EXPECT_NE(table.find("... and 1 crossings less bad\n"), std::string::npos);
}

} // namespace
} // namespace keiko
