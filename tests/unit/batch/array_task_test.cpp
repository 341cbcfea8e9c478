#include "keiko/base/error.h"
#include "keiko/batch/shard.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace keiko {
namespace {

using Variables = std::map<std::string, std::string>;

Environment environment_of(const Variables& variables) {
    return [&variables](const char* name) -> const char* {
        const auto found = variables.find(name);
        return found == variables.end() ? nullptr : found->second.c_str();
    };
}

/// "3/8" of a text in an environment; the error where there is one.
std::string shard_in(const Variables& variables, const std::string& text = "auto") {
    try {
        const Shard shard = shard_of(text, environment_of(variables));
        return std::to_string(shard.number) + "/" + std::to_string(shard.count);
    } catch (const FieldError& error) {
        EXPECT_EQ(error.field(), "shard");
        return error.reason();
    }
}

Variables slurm(const std::string& index, const std::string& first, const std::string& last,
                const std::string& count) {
    return {{"SLURM_ARRAY_TASK_ID", index},
            {"SLURM_ARRAY_TASK_MIN", first},
            {"SLURM_ARRAY_TASK_MAX", last},
            {"SLURM_ARRAY_TASK_COUNT", count}};
}

TEST(Shard, IsThatOfAText) {
    EXPECT_EQ(shard_in({}, "2/5"), "2/5");
    EXPECT_EQ(shard_in({}, "1/100000"), "1/100000");
    for (const char* text : {"", "/", "1", "0/2", "3/2", "1/2x", "1/0", "-1/2", "1/100001", "auto/",
                             "auto/0", "automatic", " 1/2", "+1/2", "1/2/3"})
        EXPECT_NE(shard_in({}, text).find("is none of K/N"), std::string::npos) << text;
}

TEST(Shard, IsThatOfASlurmTask) {
    EXPECT_EQ(shard_in(slurm("3", "1", "8", "8")), "3/8");
    EXPECT_EQ(shard_in(slurm("0", "0", "7", "8")), "1/8");
    EXPECT_EQ(shard_in(slurm("7", "1", "9", "5")), "4/5"); // --array=1-9:2
    EXPECT_EQ(shard_in(slurm("4", "4", "4", "1")), "1/1");
}

TEST(Shard, OfASlurmArrayWithGapsIsRefusedUnlessTheCountIsGiven) {
    for (const char* index : {"1", "4"}) // --array=1,2,4 is not divided evenly
        EXPECT_NE(shard_in(slurm(index, "1", "4", "3")).find("array with gaps"), std::string::npos);
    EXPECT_NE(shard_in(slurm("2", "1", "7", "4")).find("array with gaps"), std::string::npos);
    EXPECT_EQ(shard_in(slurm("4", "1", "4", "3"), "auto/8"), "4/8");
    EXPECT_EQ(shard_in(slurm("5", "5", "5", "1"), "auto/8"), "5/8");
    EXPECT_NE(shard_in(slurm("9", "9", "9", "1"), "auto/8").find("none of 1 to 8"),
              std::string::npos);
    EXPECT_NE(shard_in(slurm("0", "0", "7", "8"), "auto/8").find("none of 1 to 8"),
              std::string::npos);
}

TEST(Shard, IsThatOfOtherSchedulers) {
    EXPECT_EQ(shard_in({{"SGE_TASK_ID", "6"},
                        {"SGE_TASK_FIRST", "2"},
                        {"SGE_TASK_LAST", "8"},
                        {"SGE_TASK_STEPSIZE", "2"}}),
              "3/4");
    EXPECT_EQ(shard_in({{"CI_NODE_INDEX", "2"}, {"CI_NODE_TOTAL", "3"}}), "2/3");
    EXPECT_EQ(shard_in({{"JOB_COMPLETION_INDEX", "0"}}, "auto/4"), "1/4");
    EXPECT_EQ(shard_in({{"JOB_COMPLETION_INDEX", "3"}}, "auto/4"), "4/4");
    EXPECT_EQ(shard_in({{"PBS_ARRAY_INDEX", "2"}}, "auto/4"), "2/4");
    EXPECT_NE(shard_in({{"PBS_ARRAY_INDEX", "2"}}).find("write auto/N"), std::string::npos);
}

TEST(Shard, IsNotGuessedOutsideOfArrays) {
    EXPECT_NE(shard_in({}).find("no task of an array"), std::string::npos);
    EXPECT_NE(shard_in({{"SGE_TASK_ID", "undefined"}}, "auto/2").find("no task of an array"),
              std::string::npos);
    EXPECT_NE(shard_in(slurm("two", "1", "8", "8")).find("SLURM_ARRAY_TASK_ID: \"two\""),
              std::string::npos);
    EXPECT_NE(shard_in(slurm("99999999999", "1", "8", "8")).find("is no number of a task"),
              std::string::npos);
}

TEST(ArrayThreads, AreTheCoresOfTheTask) {
    const auto threads = [](const Variables& variables) {
        return array_threads(environment_of(variables));
    };
    EXPECT_EQ(threads({}), 0);
    EXPECT_EQ(threads({{"SLURM_JOB_ID", "7"}}), 1);
    EXPECT_EQ(threads({{"SLURM_JOB_ID", "7"}, {"SLURM_CPUS_PER_TASK", "4"}}), 4);
}

TEST(ShardFolder, IsKnownByItsName) {
    EXPECT_EQ(shard_folder("out", 12), std::filesystem::path("out/shard-12"));
    EXPECT_TRUE(is_shard_name("shard-12"));
    for (const char* name : {"shard-", "shard-0", "shard-x", "shard-1.toml", "shard", "Shard-1"})
        EXPECT_FALSE(is_shard_name(name)) << name;
}

} // namespace
} // namespace keiko
