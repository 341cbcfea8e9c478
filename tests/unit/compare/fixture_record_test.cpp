#include "keiko/compare/fixture_record.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

Metric metric(const std::string& name, double value) {
    return {"shape", name, Quantity::count, value};
}

TEST(FixtureDifference, CountsMetricsOfBothRecordsAsCompared) {
    const FixtureRecord before{{metric("faces", 2), metric("seams", 1), metric("patches", 4)}, {}};
    const FixtureRecord after{{metric("faces", 3)}, {}};
    const FixtureDifference found = fixture_difference(before, after, {});
    EXPECT_EQ(found.metrics.size(), 3u);
    EXPECT_EQ(found.metrics_compared, 3u);
    EXPECT_EQ(fixture_difference(after, before, {}).metrics_compared, 3u);
}

} // namespace
} // namespace keiko
