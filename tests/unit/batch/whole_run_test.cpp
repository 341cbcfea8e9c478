#include "keiko/batch/whole_run.h"

#include "keiko/base/error.h"

#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {
namespace fs = std::filesystem;

ShardRecord record(int number) {
    return {shard_folder("out", number),
            {number, 3},
            "1.0",
            "key",
            {"a", "b", "c"},
            {std::string(1, static_cast<char>('a' + number - 1))}};
}

std::string refusal(const std::vector<ShardRecord>& records,
                    const std::optional<ShardPlan>& plan = {}) {
    try {
        require_whole_run(records, plan);
        return "none";
    } catch (const Error& error) {
        return error.what();
    }
}

ShardPlan plan_of_three() {
    return {"regress", "1.0", "build", "key", 3, {{"a", "1", 1}, {"b", "2", 2}, {"c", "3", 3}}};
}

TEST(WholeRun, HasEveryShardOnce) {
    EXPECT_EQ(refusal({record(3), record(1), record(2)}), "none");
    EXPECT_EQ(refusal({record(3), record(1), record(2)}, plan_of_three()), "none");
    EXPECT_EQ(refusal({record(1), record(2), record(2), record(3)}),
              "out/shard-2: is shard 2, as is out/shard-2");
    ShardRecord hollow = record(2);
    hollow.done.clear();
    EXPECT_EQ(refusal({record(1), hollow, record(3)}), "\"b\" is in no shard");
}

TEST(WholeRun, NamesAllShardsThatAreMissing) {
    EXPECT_EQ(refusal({record(1), record(3)}), "shard 2 of 3 is missing; run again as shard 2/3");
    EXPECT_EQ(refusal({record(2)}, plan_of_three()),
              "shards 1, 3 of 3 are missing, with a, c; run again as shard 1/3");
    EXPECT_EQ(refusal({}, plan_of_three()),
              "shards 1, 2, 3 of 3 are missing, with a, b, c; run again as shard 1/3");
    EXPECT_EQ(refusal({}), "no shard is there");
}

TEST(WholeRun, HasNoShardOfAnother) {
    const auto with = [](const auto& change) {
        ShardRecord other = record(2);
        change(other);
        return std::vector{record(1), other, record(3)};
    };
    EXPECT_EQ(refusal(with([](ShardRecord& r) { r.tool_version = "0.9"; })),
              "out/shard-2: is a shard of another run: it is of Keiko 0.9, out/shard-1 of 1.0");
    EXPECT_EQ(refusal(with([](ShardRecord& r) { r.parts.pop_back(); })),
              "out/shard-2: is a shard of another run: it has other parts");
    EXPECT_EQ(refusal(with([](ShardRecord& r) { r.shard.count = 4; })),
              "out/shard-2: is a shard of another run: it is one of 4 shards, not of 3");
    EXPECT_EQ(refusal(with([](ShardRecord& r) { r.key = "other"; })),
              "out/shard-2: is a shard of another run: files, options, baselines or the program "
              "were others when it ran");
    ShardPlan newer = plan_of_three();
    newer.key = "newer";
    EXPECT_EQ(refusal({record(1), record(2), record(3)}, newer).substr(0, 11), "out/shard-1");
}

TEST(ShardFolders, AreFoundInTheOutputOfARunByNumber) {
    const test::TemporaryFolder folder;
    for (const char* name : {"shard-10", "shard-2", "shard-3", "other", "shard-x"})
        fs::create_directory(folder.path() / name);
    for (const char* name : {"shard-10", "shard-2", "other", "shard-x"})
        folder.file(std::string(name) + "/parts.json", "{}");
    const fs::path out = folder.path();
    EXPECT_EQ(shard_folders({&out, 1}, "parts.json").folders,
              (std::vector{out / "shard-2", out / "shard-10"}));
    const std::vector named{out / "other", out / "shard-3"};
    EXPECT_EQ(shard_folders(named, "parts.json").folders, named); // as they were named
}

} // namespace
} // namespace keiko
