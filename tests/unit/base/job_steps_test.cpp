#include "keiko/base/job_steps.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace keiko {
namespace {

struct Report {
    std::string stage;
    double fraction;
};

/// A job that keeps its reports.
struct Listener {
    std::vector<Report> reports{};
    Job job{.progress = [this](const Progress& p) {
        reports.push_back({std::string(p.stage), p.fraction});
    }};

    void expect_last(const std::string& stage, double fraction) const {
        ASSERT_FALSE(reports.empty());
        EXPECT_EQ(reports.back().stage, stage);
        EXPECT_NEAR(reports.back().fraction, fraction, 1e-12);
    }
};

TEST(JobSteps, TakeTheirSharesOneAfterTheOther) {
    Listener heard;
    JobSteps steps(heard.job, 4);
    steps.next(1).report("read", 0.5);
    heard.expect_last("read", 0.125);
    steps.next(3, 1, "front").report("render", 1.0 / 3);
    heard.expect_last("render front", 0.5);
}

TEST(JobSteps, RiseThroughTheirStages) {
    Listener heard;
    JobSteps steps(heard.job, 1);
    const Job job = steps.next(1, 4);
    job.report("pair", 1);
    heard.expect_last("pair", 0.25);
    job.report("measure", 0.5);
    heard.expect_last("measure", 0.375);
    job.report("measure", 0); // once more
    heard.expect_last("measure", 0.5);
    job.report("faces", 1);
    heard.expect_last("faces", 1);
    job.report("faces", 0.5); // one stage too many
    heard.expect_last("faces", 1);
}

TEST(JobSteps, NestAndNeverFall) {
    Listener heard;
    JobSteps outer(heard.job, 3);
    outer.next(1, 2).report("open", 1);
    {
        const Job of_steps = outer.next_of_steps(2);
        JobSteps inner(of_steps, 1); // the last of the three steps is one too many
        for (int step = 0; step < 3; ++step)
            for (const char* stage : {"a", "b"}) {
                const Job job = inner.next(0.5, 1);
                job.report(stage, 0);
                job.report(stage, 1);
            }
    }
    double last = 0;
    for (const Report& report : heard.reports) {
        EXPECT_GE(report.fraction, last);
        EXPECT_LE(report.fraction, 1);
        last = report.fraction;
    }
    EXPECT_NEAR(last, 1, 1e-12);
}

TEST(JobSteps, KeepThreadsAndTheStopOfTheirJob) {
    std::stop_source stop;
    const Job job{.stop = stop.get_token(), .threads = 3};
    JobSteps steps(job, 1);
    const Job step = steps.next(1);
    EXPECT_EQ(step.threads, 3);
    EXPECT_FALSE(step.progress);
    stop.request_stop();
    EXPECT_TRUE(step.stop.stop_requested());
}

} // namespace
} // namespace keiko
