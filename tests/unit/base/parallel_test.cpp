#include "keiko/base/parallel.h"

#include "keiko/base/error.h"
#include "keiko/base/job.h"

#include <gtest/gtest.h>

#include <atomic>
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

TEST(ParallelFor, EveryThreadIsInTheScopeOfTheCaller) {
    std::atomic<int> asked = 0;
    const StopScope scope([&] { return ++asked > 50; });
    std::atomic<int> calls = 0;
    EXPECT_THROW(parallel_for(4, {}, "",
                              [&](std::size_t) {
                                  for (;; ++calls) check_stop();
                              }),
                 Cancelled);
    EXPECT_LE(calls, 50);
    EXPECT_THROW(check_stop(), Cancelled);
}

TEST(ParallelFor, AStopOfItsJobReachesLoopsBelow) {
    std::stop_source source;
    const Job job{.progress = {}, .stop = source.get_token(), .threads = 2};
    EXPECT_THROW(parallel_for(2, job, "",
                              [&](std::size_t) {
                                  parallel_for(2, {}, "", [&](std::size_t) {
                                      for (;;) {
                                          check_stop();
                                          source.request_stop();
                                      }
                                  });
                              }),
                 Cancelled);
    EXPECT_EQ(StopScope::innermost(), nullptr);
    check_stop();
}

TEST(ParallelFor, HandsOnWhatTheBodyThrows) {
    EXPECT_THROW(parallel_for(10, {}, "",
                              [](std::size_t i) {
                                  if (i == 7) throw std::domain_error("seven");
                              }),
                 std::domain_error);
}

namespace {

/// Sends the numbers below `count` through three slots, squared on the way.
std::vector<int> squares(int count, const Job& job, int most = 1000000) {
    std::vector<int> slots(3), written;
    int next = 0;
    parallel_stream(slots.size(), job,
                    {.read =
                         [&](std::size_t slot) {
                             if (next == count) return false;
                             slots[slot] = next++;
                             return true;
                         },
                     .work = [&](std::size_t slot) { slots[slot] *= slots[slot]; },
                     .write =
                         [&](std::size_t slot) {
                             written.push_back(slots[slot]);
                             return static_cast<int>(written.size()) < most;
                         }});
    return written;
}

} // namespace

TEST(ParallelStream, WritesInTheOrderOfReadingForAnyThreadCount) {
    std::vector<int> expected(1000);
    for (int i = 0; i < 1000; ++i) expected[static_cast<std::size_t>(i)] = i * i;
    for (const int threads : {0, 1, 2, 5})
        EXPECT_EQ(squares(1000, {.progress = {}, .stop = {}, .threads = threads}), expected);
    EXPECT_TRUE(squares(0, {}).empty());
}

TEST(ParallelStream, EndsWhenTheWriterHasEnough) {
    EXPECT_EQ(squares(1000, {}, 4), (std::vector<int>{0, 1, 4, 9}));
}

TEST(ParallelStream, HandsOnWhatAStageThrowsAndStopsWhenAsked) {
    const auto refuse = [](std::size_t) -> bool { throw std::domain_error("no"); };
    const auto agree = [](std::size_t) { return true; };
    const auto nothing = [](std::size_t) {};
    EXPECT_THROW(parallel_stream(2, {}, {.read = refuse, .work = nothing, .write = agree}),
                 std::domain_error);
    EXPECT_THROW(parallel_stream(2, {}, {.read = agree, .work = nothing, .write = refuse}),
                 std::domain_error);
    std::stop_source source;
    source.request_stop();
    EXPECT_THROW(squares(10, {.progress = {}, .stop = source.get_token(), .threads = 0}),
                 Cancelled);
}
