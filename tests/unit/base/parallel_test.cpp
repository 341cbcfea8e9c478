#include "keiko/base/parallel.h"

#include "keiko/base/error.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>
#include <vector>

using namespace keiko;

TEST(ParallelFor, CallsEachIndexOnceForAnyThreadCount) {
    for (const int threads : {0, 1, 2, 5}) {
        std::vector<int> calls(1000);
        parallel_for(calls.size(), {.progress = {}, .stop = {}, .threads = threads}, "",
                     [&](std::size_t i) { ++calls[i]; });
        EXPECT_EQ(calls, std::vector<int>(1000, 1)) << threads << " threads";
    }
}

TEST(ParallelFor, ReportsRisingProgressUpToOne) {
    std::vector<double> fractions;
    const Job job{.progress =
                      [&](const Progress& p) {
                          EXPECT_EQ(p.stage, "count");
                          fractions.push_back(p.fraction);
                      },
                  .stop = {},
                  .threads = 0};
    parallel_for(64, job, "count", [](std::size_t) {});
    ASSERT_EQ(fractions.size(), 64u);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_EQ(fractions.back(), 1);
}

TEST(ParallelFor, StopsWhenAsked) {
    std::stop_source source;
    const Job job{.progress = {}, .stop = source.get_token(), .threads = 2};
    std::atomic<int> calls = 0;
    EXPECT_THROW(parallel_for(100000, job, "",
                              [&](std::size_t) {
                                  if (++calls == 10) source.request_stop();
                              }),
                 Cancelled);
    EXPECT_LT(calls, 1000);
}

TEST(ParallelFor, HandsOnWhatTheBodyThrows) {
    EXPECT_THROW(parallel_for(10, {}, "",
                              [](std::size_t i) {
                                  if (i == 7) throw std::domain_error("seven");
                              }),
                 std::domain_error);
}
