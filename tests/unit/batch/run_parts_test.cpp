#include "keiko/batch/run_parts.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/batch/part_names.h"

#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <stop_token>

namespace keiko {
namespace {
namespace fs = std::filesystem;

/// Models that are judged by their length, without being read as such.
struct Parts : testing::Test {
    test::TemporaryFolder folder;
    std::vector<std::string> judged;
    fs::path out = folder.path() / "out";

    PartsOptions options(int number, int count) {
        PartsOptions options{.command = "check", .output = out, .shard = {number, count}};
        for (const char* name : {"a", "b", "c"})
            options.models.push_back(folder.path() / (std::string(name) + ".step"));
        return options;
    }
    void SetUp() override {
        for (const char* name : {"a", "b", "c"}) folder.file(std::string(name) + ".step", name);
    }
    JudgePart judge() {
        return [this](const fs::path& model, const fs::path& results, const Job&) -> PartResult {
            judged.push_back(model.stem().string());
            EXPECT_EQ(results, out / part_folder(judged.back()));
            const std::string text = read_file(model);
            if (text == "broken") throw Error(model.string(), "", "is broken");
            const PartState state = text.size() > 1 ? PartState::fail : PartState::pass;
            return {state, "read " + text, "page.txt", {{"page.txt", text}}};
        };
    }
    PartsRun run(int number, int count) { return run_parts(options(number, count), judge()); }
    std::string merged() {
        merge_parts(out);
        return read_file(out / "parts.json") + read_file(out / "index.html") +
               read_file(out / "junit.xml");
    }
};

TEST_F(Parts, AreTheSameBytesHoweverTheyAreDivided) {
    folder.file("b.step", "long");
    folder.file("c.step", "broken");
    EXPECT_EQ(run(1, 1).state(), PartState::error);
    const std::string whole = merged();
    fs::remove_all(out);
    for (const int number : {2, 4, 1, 3}) run(number, 4); // one of them has no part
    EXPECT_EQ(merged(), whole);
    EXPECT_EQ(merged(), whole); // idempotent
    EXPECT_EQ(read_file(out / "parts/b/results/page.txt"), "long");
}

TEST_F(Parts, ThatAreDoneAreNotJudgedAgainUnlessTheyChange) {
    run(1, 1);
    EXPECT_EQ(judged.size(), 3u);
    run(1, 1);
    EXPECT_EQ(judged.size(), 3u);
    folder.file("b.step", "changed");
    EXPECT_THROW(run(1, 1), Error); // the folder is that of a run over other files
    fs::remove(out / "shards.json");
    EXPECT_EQ(run(1, 1).parts[1].state, PartState::fail);
    EXPECT_EQ(judged, (std::vector<std::string>{"a", "b", "c", "b"}));
}

TEST_F(Parts, AreJudgedAgainWithOtherSettingsOrFiles) {
    PartsOptions with = options(1, 1);
    with.files = {folder.file("preset.toml", "")};
    run_parts(with, judge());
    const auto judged_again = [&] {
        judged.clear();
        fs::remove(out / "shards.json");
        run_parts(with, judge());
        return judged.size();
    };
    EXPECT_EQ(judged_again(), 0u);
    with.settings = "--join=1";
    EXPECT_EQ(judged_again(), 3u);
    folder.file("preset.toml", "# changed");
    EXPECT_EQ(judged_again(), 3u);
}

TEST_F(Parts, ThatFailedAreJudgedAgain) {
    folder.file("a.step", "broken");
    run(1, 1);
    EXPECT_FALSE(fs::exists(out / "parts/a/results"));
    run(1, 1);
    EXPECT_EQ(judged, (std::vector<std::string>{"a", "b", "c", "a"}));
}

TEST_F(Parts, OfAMissingShardAreNamedAndNoReportIsLeft) {
    run(1, 2), run(2, 2);
    merged();
    fs::remove(out / "shard-2/parts.json");
    try {
        merged();
        FAIL() << "nothing thrown";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "shard 2 of 2 is missing, with b; run again as shard 2/2");
    }
    for (const char* name : {"parts.json", "index.html", "junit.xml"})
        EXPECT_FALSE(fs::exists(out / name));
}

TEST_F(Parts, LeaveNoRecordOfAnInterruptedShard) {
    run(1, 1);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(run_parts(options(1, 1), judge(), {.stop = stop.get_token()}), Cancelled);
    EXPECT_FALSE(fs::exists(out / "shard-1/parts.json"));
    EXPECT_EQ(run(1, 1).parts.size(), 3u);
    EXPECT_EQ(judged.size(), 3u);
}

TEST_F(Parts, AreThoseOfTheFolderThatHasTheirPlan) {
    EXPECT_FALSE(holds_parts(out));
    run(1, 1);
    EXPECT_TRUE(holds_parts(out));
}

TEST(PartNames, AreThoseOfFilesUnlessTwoAreTheSame) {
    const auto names = [](const std::vector<fs::path>& files) { return part_names(files); };
    EXPECT_EQ(names({"x/hood.step", "y/door.igs"}), (std::vector<std::string>{"hood", "door"}));
    EXPECT_EQ(names({"x/hood.step", "../y/hood.step"}),
              (std::vector<std::string>{"x-hood.step", "y-hood.step"}));
    EXPECT_THROW(names({"x/hood.step", "./x/hood.step"}), Error);
    EXPECT_THROW(names({".."}), Error);
    EXPECT_THROW(names({".step"}), Error);
    EXPECT_THROW(names({"../.x/hood.step", "y/hood.step"}), Error) << "a hidden folder";
}

} // namespace
} // namespace keiko
