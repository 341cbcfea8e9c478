#include "keiko/import/worker/worker_answer.h"

#include "keiko/base/error.h"
#include "keiko/files/model/model_serialization.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

constexpr std::uint64_t no_limit = 0;

/// Outcome of an answer that arrives in one piece; "model" where it is one.
std::string outcome_of(const std::string& text, std::uint64_t most_bytes = no_limit) {
    const Job job;
    WorkerAnswer answer("part.step", most_bytes, job);
    try {
        answer.receive(text);
        answer.model();
        return "model";
    } catch (const Error& error) {
        EXPECT_EQ(error.file(), "part.step");
        return error.reason();
    }
}

std::string serialised_model() {
    test::ModelBuilder builder;
    builder.plane(Vec3(0), {1, 0, 0}, {0, 1, 0});
    return serialize(builder.build());
}

const std::string damaged = "the reader's answer is damaged: ";

TEST(WorkerAnswer, AModelAfterItsProgress) {
    EXPECT_EQ(outcome_of("progress 0\nprogress 0.250\nprogress 1\nmodel\n" + serialised_model()),
              "model");
}

TEST(WorkerAnswer, AModelByteByByte) {
    const Job job;
    WorkerAnswer answer("part.step", no_limit, job);
    for (const char c : "progress 0.5\nmodel\n" + serialised_model())
        answer.receive(std::string_view(&c, 1));
    EXPECT_EQ(serialize(answer.model()), serialised_model());
}

TEST(WorkerAnswer, TheReasonOfTheWorkerIsKeptToALine) {
    EXPECT_EQ(outcome_of("error no faces in the file\n"), "no faces in the file");
    EXPECT_EQ(outcome_of("error a\tb\x1b[2J\n"), "a?b?[2J");
    EXPECT_EQ(outcome_of("error " + std::string(2000, 'x') + "\n"), std::string(300, 'x') + "...");
}

TEST(WorkerAnswer, ThePlaceOfAReasonIsKept) {
    const Job job;
    WorkerAnswer answer("cage.obj", no_limit, job);
    answer.receive("where 12:3\nerror no number\n");
    try {
        answer.model();
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.where(), "12:3");
        EXPECT_EQ(error.reason(), "no number");
    }
}

TEST(WorkerAnswer, LinesThatAreNoneAreDamage) {
    EXPECT_EQ(outcome_of("rubbish\n"), damaged + "\"rubbish\" is no line of it");
    for (const std::string share : {"nan", "inf", "-0.1", "1.1", "1e999", "", "0.5 "})
        EXPECT_EQ(outcome_of("progress " + share + "\n"),
                  damaged + "\"progress " + share + "\" is no line of it");
    EXPECT_EQ(outcome_of("progress 0.5\n"), damaged + "it ends before the result");
    EXPECT_EQ(outcome_of("model"), damaged + "it ends before the result");
    EXPECT_EQ(outcome_of("error"), damaged + "it ends before the result");
}

TEST(WorkerAnswer, AWorkerThatNeverStopsWritingIsCutOff) {
    EXPECT_EQ(outcome_of(std::string(5000, 'x')),
              damaged + '"' + std::string(40, 'x') + "...\" is too long a line");
    const std::string model = serialised_model();
    EXPECT_EQ(outcome_of("model\n" + model, model.size()), "model");
    EXPECT_EQ(outcome_of("model\n" + model, model.size() - 1),
              damaged + "its result is larger than the memory it may use");
}

} // namespace
} // namespace keiko
