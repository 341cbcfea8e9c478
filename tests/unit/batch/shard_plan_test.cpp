#include "keiko/batch/shard_plan.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"

#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <functional>

namespace keiko {
namespace {
namespace fs = std::filesystem;

ShardPlan plan() {
    return balanced_plan("regress", "key", {{"dome", "1"}, {"hood", "2"}, {"mast", "3"}},
                         std::vector<double>{1, 5, 1}, 2);
}

/// The reason for which a changed plan does not get a folder that has the plan.
std::string refusal(const std::function<void(ShardPlan&)>& change) {
    const test::TemporaryFolder folder;
    claim_shard(folder.path(), plan(), 1);
    ShardPlan other = plan();
    change(other);
    const std::string before = read_file(folder.path() / "shards.json");
    try {
        claim_shard(folder.path(), other, 2);
        return "none";
    } catch (const Error& error) {
        EXPECT_EQ(error.file(), (folder.path() / "shards.json").string());
        EXPECT_EQ(read_file(folder.path() / "shards.json"), before);
        EXPECT_FALSE(fs::exists(folder.path() / "shard-2"));
        return error.reason();
    }
}

TEST(ShardPlan, IsReadAsItWasWritten) {
    const ShardPlan written = plan();
    const ShardPlan read = parse_plan(plan_json(written), "shards.json");
    EXPECT_EQ(plan_json(read), plan_json(written));
    EXPECT_EQ(read.parts[1].name, "hood");
    EXPECT_EQ(read.parts[0].shard, 2);
    EXPECT_EQ(read.parts[1].shard, 1);
}

TEST(ShardPlan, DamagedIsRefusedByName) {
    for (const char* text : {"", "{", "[]", R"({"format": "keiko-parts/1"})"}) {
        try {
            parse_plan(text, "shards.json");
            FAIL() << text;
        } catch (const Error& error) {
            EXPECT_EQ(error.file(), "shards.json");
        }
    }
}

TEST(ShardPlan, GivesAFolderToOneRunAlone) {
    EXPECT_EQ(refusal([](ShardPlan&) {}), "none");
    const auto reason_of = [](const std::function<void(ShardPlan&)>& change,
                              const std::string& words) {
        const std::string reason = refusal(change);
        EXPECT_NE(reason.find("is the plan of another run: "), std::string::npos) << reason;
        EXPECT_NE(reason.find(words), std::string::npos) << reason;
    };
    reason_of([](ShardPlan& p) { p.command = "check"; }, "it is one of keiko regress");
    reason_of([](ShardPlan& p) { p.tool_version = "9"; }, "it is of Keiko 0.");
    reason_of([](ShardPlan& p) { p.program = "f00d avx2"; }, ", here f00d avx2");
    reason_of([](ShardPlan& p) { p.shards = 3; }, "it has 2 shards, here 3");
    reason_of([](ShardPlan& p) { p.parts[1].key = "x"; }, "files or options of \"hood\"");
    reason_of([](ShardPlan& p) { p.parts[1].name = "x"; }, "\"x\" is not in it");
    reason_of([](ShardPlan& p) { p.parts.pop_back(); }, "\"mast\" is in it");
    reason_of([](ShardPlan& p) { p.key = "x"; }, "its files or options were others");
}

TEST(ShardPlan, TakenByAnotherRunMeanwhileIsNoticed) {
    const test::TemporaryFolder folder;
    claim_shard(folder.path(), plan(), 1);
    EXPECT_NO_THROW(require_claimed(folder.path(), plan()));
    fs::remove(folder.path() / "shards.json");
    EXPECT_THROW(require_claimed(folder.path(), plan()), Error);
    ShardPlan other = plan();
    other.key = "other";
    claim_shard(folder.path(), other, 1);
    EXPECT_THROW(require_claimed(folder.path(), plan()), Error);
}

} // namespace
} // namespace keiko
