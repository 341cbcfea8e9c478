#include "keiko/stream/trace_rays.h"

#include "keiko/base/error.h"
#include "keiko/stream/hit_columns.h"

#include "tests/unit/stream/cut_text.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>

namespace keiko {
namespace {

/// z = (x^2 - y^2) / 400 over +-100 mm.
const Scene& saddle() {
    static const Scene scene = [] {
        const std::vector<std::filesystem::path> inputs{KEIKO_SOURCE_DIR "/surfaces/saddle.bpt"};
        return open_scene(inputs);
    }();
    return scene;
}

/// Rays down onto a grid that reaches beyond the saddle.
std::string grid(int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
        text += std::to_string(-110 + 220.0 * (i % 97) / 97) + "," +
                std::to_string(-110 + 220.0 * (i % 89) / 89) + ",200,0,0,-1\n";
    return text;
}

struct Traced {
    std::string text;
    TraceCounts counts;
};

Traced traced(const std::string& rays, const TraceOptions& options = {}, std::size_t cut = 1 << 16,
              int threads = 0) {
    Traced result;
    const auto sink = [&](std::string_view text) {
        result.text += text;
        return true;
    };
    result.counts = trace_rays(saddle(), test::cut_text(rays, cut), sink, options,
                               {.progress = {}, .stop = {}, .threads = threads});
    return result;
}

TEST(TraceRays, TellsWhereTheyMeetTheSurface) {
    const Traced result = traced("10,20,200,0,0,-2\n500,0,200,0,0,-1\n", {.columns = "t,x,y,z"});
    double t = 0;
    Vec3 p(0);
    const int read =
        std::sscanf(result.text.c_str(), "t,x,y,z\n%lf,%lf,%lf,%lf\n", &t, &p.x, &p.y, &p.z);
    ASSERT_EQ(read, 4) << result.text;
    EXPECT_NEAR(t, 100.375, 1e-10);
    EXPECT_LT((p - Vec3(10, 20, -0.75)).length(), 1e-10);
    EXPECT_TRUE(result.text.ends_with("\n,,,\n"));
    EXPECT_EQ(result.counts.rays, 2u);
    EXPECT_EQ(result.counts.hits.sum(), 1u);
}

TEST(TraceRays, TellsTheCurvaturesOfTheSaddle) {
    const std::string text = traced("1e-3,0,200,0,0,-1\n", {.columns = "k1,k2"}).text;
    double k1 = 0, k2 = 0;
    ASSERT_EQ(std::sscanf(text.c_str(), "k1,k2\n%lf,%lf\n", &k1, &k2), 2);
    EXPECT_NEAR(k1, 0.005, 1e-9);
    EXPECT_NEAR(k2, -0.005, 1e-9);
}

TEST(TraceRays, NumbersTheRaysOfAllTheirHits) {
    const std::string rays = "ox,oy,oz,dx,dy,dz\n500,0,200,0,0,-1\n-300,3,10,1,0,0\n";
    const std::string text = traced(rays, {.columns = "instance", .all = true}).text;
    EXPECT_EQ(text, "ray,instance\n0,\n1,0\n1,0\n");
}

TEST(TraceRays, GivesTheSameBytesForAnyThreadsAndCuts) {
    const std::string rays = grid(5000);
    for (const bool all : {false, true}) {
        const TraceOptions options{.columns = "t,face,patch,u,v,nx,k1,bound,flags", .all = all};
        const std::string expected = traced(rays, options, 1 << 16, 1).text;
        EXPECT_EQ(traced(rays, options, 1 << 16, 0).text, expected);
        EXPECT_EQ(traced(rays, options, 997, 2).text, expected);
        EXPECT_EQ(traced(rays, options, 61, 0).text, expected);
    }
}

TEST(TraceRays, WritesTheRowsBeforeAMalformedLine) {
    const std::string rays = grid(3000) + "1,2,3\n" + grid(3000);
    const std::string expected = traced(grid(3000)).text;
    std::string text;
    const auto sink = [&](std::string_view more) {
        text += more;
        return true;
    };
    try {
        trace_rays(saddle(), test::cut_text(rays, 1000), sink);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.where(), "3001");
    }
    EXPECT_EQ(text, expected);
}

/// Sends a ray only when the one before is answered; gives up after a while.
class Conversation {
public:
    std::size_t ask(std::span<char> bytes) {
        std::unique_lock lock(mutex_);
        const bool heard = answer_.wait_for(lock, std::chrono::seconds(10),
                                            [this] { return answers_ == asked_ + 1; });
        if (!heard || asked_ == 5) return 0;
        ++asked_;
        constexpr std::string_view line = "3,7,200,0,0,-1\n";
        std::copy(line.begin(), line.end(), bytes.begin());
        return line.size();
    }
    bool hear(std::string_view text) {
        const std::scoped_lock lock(mutex_);
        answers_ += std::count(text.begin(), text.end(), '\n');
        answer_.notify_one();
        return true;
    }
    std::ptrdiff_t asked() const { return asked_; }

private:
    std::mutex mutex_;
    std::condition_variable answer_;
    std::ptrdiff_t asked_ = 0, answers_ = 0; ///< answers: the header too
};

TEST(TraceRays, AnswersARayBeforeTheNextComes) {
    for (const int threads : {1, 2}) {
        Conversation conversation;
        trace_rays(
            saddle(), [&](std::span<char> bytes) { return conversation.ask(bytes); },
            [&](std::string_view text) { return conversation.hear(text); }, {},
            {.progress = {}, .stop = {}, .threads = threads});
        EXPECT_EQ(conversation.asked(), 5) << threads << " threads";
    }
}

TEST(TraceRays, EndsWhenNobodyReadsTheRows) {
    std::size_t reads = 0, writes = 0;
    const ByteSource endless = [&](std::span<char> bytes) {
        const std::string line = "0,0,200,0,0,-1\n";
        ++reads;
        std::copy(line.begin(), line.end(), bytes.begin());
        return line.size();
    };
    trace_rays(saddle(), endless, [&](std::string_view) { return ++writes < 5; });
    EXPECT_EQ(writes, 5u);
    EXPECT_LT(reads, 1000u);
}

TEST(TraceRays, StopsWhenAsked) {
    std::stop_source source;
    const ByteSource endless = [&](std::span<char> bytes) {
        const std::string line = "0,0,200,0,0,-1\n";
        std::copy(line.begin(), line.end(), bytes.begin());
        return line.size();
    };
    std::size_t writes = 0;
    const auto sink = [&](std::string_view) {
        if (++writes == 10) source.request_stop();
        return true;
    };
    EXPECT_THROW(trace_rays(saddle(), endless, sink, {},
                            {.progress = {}, .stop = source.get_token(), .threads = 2}),
                 Cancelled);
    EXPECT_LT(writes, 20u);
}

TEST(TraceRays, RefusesLightWhereThereIsNone) {
    EXPECT_THROW(traced("", {.columns = "t,luminance"}), Error);
    EXPECT_THROW(require_columns({.columns = "t,r", .all = true}), Error);
    EXPECT_NO_THROW(require_columns({.columns = "t,r"}));
}

TEST(TraceRays, SeesTheLampsOfTheRigByTheirReflection) {
    const std::vector<std::filesystem::path> inputs{KEIKO_SOURCE_DIR "/surfaces/saddle.bpt"};
    Scene scene = open_scene(inputs, {.load = {}, .material = "mirror"});
    CPlane lamp; // above the middle of the saddle
    lamp.origin = {-1000, -500, 1000}, lamp.u = {2000, 0, 0}, lamp.v = {0, 1000, 0};
    lamp.lamps = 1, lamp.diameter = 26, lamp.luminance = Rgb(8000);
    scene.rig = LightRig{.name = "", .sources = {lamp}};
    std::string text;
    const auto sink = [&](std::string_view more) {
        text += more;
        return true;
    };
    const std::string rays = "1e-3,1e-3,500,0,0,-1\n1e-3,60,500,0,0,-1\n900,0,500,0,0,-1\n";
    trace_rays(scene, test::cut_text(rays, 4096), sink, {.columns = "luminance,r,g,b"});
    double towards = 0, aside = 0;
    const int read =
        std::sscanf(text.c_str(), "luminance,r,g,b\n%lf,%*f,%*f,%*f\n%lf", &towards, &aside);
    ASSERT_EQ(read, 2) << text;
    EXPECT_GT(towards, 1000);
    EXPECT_LT(aside, 10);
    EXPECT_TRUE(text.ends_with("\n,,,\n")) << text;
}

} // namespace
} // namespace keiko
