#include "keiko/base/output_folder.h"

#include "keiko/base/error.h"
#include "keiko/base/new_file.h"

#include "tests/support/abandoned_name.h"
#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <thread>

namespace keiko {
namespace {
namespace fs = std::filesystem;

TEST(OutputFolder, TakesThePlaceOfTheOldOneWithAllItsFiles) {
    const test::TemporaryFolder folder;
    const fs::path target = folder.path() / "kept";
    write_folder_atomically(target, {{"a", "1"}, {"b", "2"}});
    write_folder_atomically(target, {{"c", "3"}});
    EXPECT_EQ(read_folder(target), (FolderContent{{"c", "3"}}));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator{}), 1);
}

TEST(OutputFolder, StaysAsItWasWhereTheNewOneCannotBeWritten) {
    const test::TemporaryFolder folder;
    const fs::path target = folder.path() / "kept";
    write_folder_atomically(target, {{"a", "1"}});
    EXPECT_THROW(write_folder_atomically(target, {{"b", "2"}, {"no/such/folder", "3"}}), Error);
    EXPECT_EQ(read_folder(target), (FolderContent{{"a", "1"}}));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator{}), 1);
}

TEST(OutputFolder, OneThatIsNotThereHasNoFiles) {
    const test::TemporaryFolder folder;
    EXPECT_TRUE(read_folder(folder.path() / "nowhere").empty());
}

TEST(OutputFolder, NamesTheFileThatCannotBeWritten) {
    const test::TemporaryFolder folder;
    try {
        write_folder_atomically(folder.path() / "kept", {{"no/a", "1"}});
        FAIL() << "nothing thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.file(), (folder.path() / "kept/no/a").string());
        EXPECT_EQ(error.reason(), "cannot write: No such file or directory");
    }
}

TEST(FolderLock, LetsNobodyElseIn) {
    const test::TemporaryFolder folder;
    const FolderLock lock(folder.path());
    EXPECT_THROW(FolderLock(folder.path()), Error);
}

TEST(FolderLock, WaitsForOneThatEndsInTime) {
    const test::TemporaryFolder folder;
    auto held = std::make_unique<FolderLock>(folder.path());
    std::jthread ends([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(1200));
        held.reset();
    });
    EXPECT_NO_THROW(FolderLock(folder.path(), std::chrono::minutes(1)));
}

TEST(FolderLock, ClearsAwayWhatKilledWritersLeft) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder.path() / test::abandoned_name());
    folder.file(test::abandoned_name(), "half");
    fs::create_directory(folder.path() / ".lost.before"); // set aside, its new one never came
    fs::create_directory(folder.path() / ".kept.before"); // set aside, its new one came
    fs::create_directory(folder.path() / "kept");
    const FolderLock lock(folder.path());
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder.path()))
        names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    EXPECT_EQ(names, (std::vector<std::string>{"kept", "lost"}));
}

TEST(FolderLock, LeavesWhatIsNotKeikos) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder.path() / ".tmp");
    fs::create_directory(folder.path() / ".cache.tmpl");
    folder.file(".notes.before", "mine");
    folder.file(".x.999999999.tmp", "another program's");
    folder.file(".keiko-cache.tmp", "mine");
    folder.file(temporary_name(), "being written");
    const FolderLock lock(folder.path());
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 6);
}

} // namespace
} // namespace keiko
