#include "keiko/base/output_folder.h"

#include "keiko/base/error.h"

#include "tests/unit/io/temporary_folder.h"
#include <gtest/gtest.h>
#include <unistd.h>

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

TEST(FolderLock, LetsNobodyElseIn) {
    const test::TemporaryFolder folder;
    const FolderLock lock(folder.path());
    EXPECT_THROW(FolderLock(folder.path()), Error);
}

TEST(FolderLock, ClearsAwayWhatKilledWritersLeft) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder.path() / ".kept.999999999.tmp");
    folder.file(".junit.999999999.tmp.xml", "half");
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
    folder.file(".x." + std::to_string(getpid()) + ".tmp.png", "being written");
    const FolderLock lock(folder.path());
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 4);
}

} // namespace
} // namespace keiko
