#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/output_file.h"
#include "keiko/base/output_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

namespace fs = std::filesystem;
using namespace keiko;

namespace {

class Batch : public testing::Test {
protected:
    Batch() { fs::create_directories(folder_); }
    ~Batch() override { fs::remove_all(folder_); }

    std::size_t entries() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

    const fs::path folder_ =
        fs::temp_directory_path() / ("keiko-batch-" + std::to_string(getpid()));
    FileTransaction batch_;
};

} // namespace

TEST_F(Batch, WritesAllAndMakesTheFoldersOfFolders) {
    batch_.add(folder_ / "a.json", "{}");
    batch_.add_folder(folder_ / "deep" / "out", {{"b.txt", "b"}, {"c.txt", "c"}});
    batch_.write();
    EXPECT_EQ(read_file(folder_ / "a.json"), "{}");
    EXPECT_EQ(read_file(folder_ / "deep" / "out" / "c.txt"), "c");
    EXPECT_EQ(entries(), 2u);
}

TEST_F(Batch, WritesNothingWhereOneFileCannotBeWritten) {
    write_text_file(folder_ / "a.json", "old");
    batch_.add(folder_ / "a.json", "new");
    batch_.add_folder(folder_ / "deep" / "out", {{"b.txt", "b"}});
    batch_.add(folder_ / "missing" / "c.txt", "c");
    try {
        batch_.write();
        FAIL() << "nothing thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.file(), (folder_ / "missing" / "c.txt").string());
    }
    EXPECT_EQ(read_file(folder_ / "a.json"), "old");
    EXPECT_EQ(entries(), 1u);
}

TEST_F(Batch, NamesTheFolderItCannotMake) {
    write_text_file(folder_ / "file", "in the way");
    batch_.add_folder(folder_ / "file" / "sub", {});
    try {
        batch_.write();
        FAIL() << "nothing thrown";
    } catch (const Error& error) {
        EXPECT_NE(error.reason().find("cannot make the folder"), std::string::npos);
    }
}

TEST_F(Batch, TakesADeviceMoreThanOnce) {
    batch_.add("/dev/null", "a");
    batch_.add("/dev/null", "b");
    EXPECT_NO_THROW(batch_.write());
}
