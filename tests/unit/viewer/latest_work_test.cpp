#include "keiko/viewer/latest_work.h"

#include "keiko/base/error.h"
#include "keiko/viewer/client_watch.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <string_view>
#include <thread>

namespace keiko::viewer {
namespace {

/// A client that may go.
class Client : public Outlet {
public:
    bool write(std::string_view) override { return is_here; }
    bool is_open() const override { return is_here; }

    std::atomic<bool> is_here = true;
};

/// True once a stop is requested, within ten seconds.
bool ends(const LatestWork::Turn& turn) {
    using namespace std::chrono;
    for (const auto begin = steady_clock::now(); steady_clock::now() - begin < seconds(10);) {
        if (turn.stop().stop_requested()) return true;
        std::this_thread::sleep_for(milliseconds(1));
    }
    return false;
}

} // namespace

TEST(LatestWork, NewerWorkEndsOlderOfTheSameClientAndKindAlone) {
    LatestWork work;
    const LatestWork::Turn older(work, "a", "still"), deep(work, "a", "deep"),
        other(work, "b", "still");
    const LatestWork::Turn newer(work, "a", "still");
    EXPECT_TRUE(older.stop().stop_requested());
    EXPECT_FALSE(deep.stop().stop_requested());
    EXPECT_FALSE(other.stop().stop_requested());
    EXPECT_FALSE(newer.stop().stop_requested());
    EXPECT_THROW(older.job(1).check(), Cancelled);
}

TEST(LatestWork, OlderWorkThatIsOverLeavesTheNewerInItsPlace) {
    LatestWork work;
    auto older = std::make_optional<LatestWork::Turn>(work, "a", "still");
    const LatestWork::Turn newer(work, "a", "still");
    older.reset();
    const LatestWork::Turn newest(work, "a", "still");
    EXPECT_TRUE(newer.stop().stop_requested());
    EXPECT_FALSE(newest.stop().stop_requested());
}

TEST(LatestWork, EndsAllWorkAndAllThatBeginsLater) {
    LatestWork work;
    const LatestWork::Turn before(work, "a", "still");
    work.end_all();
    const LatestWork::Turn after(work, "b", "deep");
    EXPECT_TRUE(before.stop().stop_requested());
    EXPECT_TRUE(after.stop().stop_requested());
}

TEST(LatestWork, TellsEachClientItsOwnProgressOnce) {
    LatestWork work;
    const LatestWork::Turn own(work, "a", "still"), other(work, "b", "seams");
    own.job(1).report("render", 0.25);
    other.job(1).report("measure", 0.5);
    const auto seen = work.next_progress("a", 0, {});
    ASSERT_TRUE(seen);
    EXPECT_EQ(seen->kind, "still");
    EXPECT_EQ(seen->stage, "render");
    EXPECT_EQ(seen->fraction, 0.25);
    EXPECT_FALSE(work.next_progress("a", seen->number, {}));
    own.job(1).report("render", 0.75);
    const auto next = work.next_progress("a", seen->number, {});
    ASSERT_TRUE(next);
    EXPECT_EQ(next->fraction, 0.75);
    EXPECT_GT(next->number, seen->number);
}

TEST(LatestWork, ForgetsTheProgressOfWorkThatIsOver) {
    LatestWork work;
    {
        const LatestWork::Turn turn(work, "a", "still");
        turn.job(1).report("render", 0.5);
    }
    EXPECT_FALSE(work.next_progress("a", 0, {}));
}

TEST(LatestWork, TellsTheEndOfWorkToAClientThatHasOther) {
    LatestWork work;
    const LatestWork::Turn events(work, "a", "events");
    {
        const LatestWork::Turn turn(work, "a", "still");
        turn.job(1).report("render", 0.5);
    }
    const auto last = work.next_progress("a", 0, {});
    ASSERT_TRUE(last);
    EXPECT_EQ(last->kind, "still");
    EXPECT_EQ(last->fraction, 1);
    EXPECT_FALSE(work.next_progress("a", last->number, {}));
}

TEST(LatestWork, WakesAListenerAtItsEnd) {
    LatestWork work;
    std::stop_source stop;
    const std::jthread ending([&] { stop.request_stop(); });
    EXPECT_FALSE(work.next_progress("a", 0, stop.get_token()));
}

TEST(ClientWatch, EndsTheWorkOfAClientThatHasGone) {
    LatestWork work;
    LatestWork::Turn turn(work, "a", "still");
    Client client;
    const ClientWatch watch(client, turn);
    EXPECT_FALSE(turn.stop().stop_requested());
    client.is_here = false;
    EXPECT_TRUE(ends(turn));
}

TEST(ClientWatch, LeavesTheWorkOfAClientThatStays) {
    LatestWork work;
    LatestWork::Turn turn(work, "a", "still");
    const Client client;
    { const ClientWatch watch(client, turn); }
    EXPECT_FALSE(turn.stop().stop_requested());
}

} // namespace keiko::viewer
