#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/job.h"
#include "keiko/base/output_file.h"
#include "keiko/base/output_target.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <future>
#include <string>
#include <thread>
#include <vector>

namespace fs = std::filesystem;
using namespace keiko;

namespace {

class Files : public testing::Test {
protected:
    Files() { fs::create_directories(folder_); }
    ~Files() override { fs::remove_all(folder_); }

    std::size_t entries() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

    const fs::path folder_ =
        fs::temp_directory_path() / ("keiko-files-" + std::to_string(getpid()));
};

std::string reason_of(const fs::path& path) {
    try {
        read_file(path);
    } catch (const Error& error) {
        EXPECT_EQ(error.file(), path.string());
        return error.reason();
    }
    return "no error";
}

} // namespace

TEST_F(Files, ReadingSaysWhyItCannot) {
    EXPECT_EQ(reason_of(folder_ / "missing.step"), "no such file");
    EXPECT_EQ(reason_of(folder_), "is a directory, not a file");
    EXPECT_EQ(reason_of("/dev/zero"), "is a device, not a file");
    std::ofstream(folder_ / "empty.step").close();
    EXPECT_EQ(reason_of(folder_ / "empty.step"), "the file is empty");
}

// A sparse file: nothing of it is read.
TEST_F(Files, TextsOfMoreThanAGibibyteAreRefusedUnread) {
    const fs::path file = folder_ / "endless.ies";
    std::ofstream(file).put('I');
    fs::resize_file(file, largest_text + 1);
    try {
        read_text_file(file);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.reason(), "has 1073741825 bytes; a text may have 1073741824");
    }
}

TEST_F(Files, WritingRoundTripsAndLeavesNothingElse) {
    const std::string text("a\0b\n", 4);
    write_text_file(folder_ / "x.bin", text);
    write_text_file(folder_ / "x.bin", text);
    EXPECT_EQ(read_file(folder_ / "x.bin"), text);
    EXPECT_EQ(entries(), 1u);
}

TEST_F(Files, AnOutputThatIsNotPutInPlaceLeavesTheOldFileAndNothingElse) {
    write_text_file(folder_ / "x.txt", "old");
    AtomicFile(folder_ / "x.txt").fill("half");
    EXPECT_EQ(read_file(folder_ / "x.txt"), "old");
    EXPECT_EQ(entries(), 1u);
}

TEST_F(Files, ANameAsLongAsTheFileSystemTakesIsWritten) {
    const fs::path longest = folder_ / std::string(255, 'a');
    write_text_file(longest, "text");
    EXPECT_EQ(read_file(longest), "text");
}

TEST_F(Files, WritersOfOneFileDoNotMeet) {
    const auto write = [&](char letter) {
        for (int i = 0; i < 20; ++i) write_text_file(folder_ / "x", std::string(100'000, letter));
    };
    std::vector<std::future<void>> writers;
    for (const char letter : {'a', 'b', 'c', 'd'})
        writers.push_back(std::async(std::launch::async, write, letter));
    for (std::future<void>& writer : writers) EXPECT_NO_THROW(writer.get());
    const std::string text = read_file(folder_ / "x");
    EXPECT_EQ(text, std::string(100'000, text.front()));
    EXPECT_EQ(entries(), 1u);
}

TEST_F(Files, ALinkStaysALinkToTheFileThatIsWritten) {
    write_text_file(folder_ / "x.txt", "old");
    fs::create_symlink("x.txt", folder_ / "link.txt");
    write_text_file(folder_ / "link.txt", "new");
    EXPECT_TRUE(fs::is_symlink(folder_ / "link.txt"));
    EXPECT_EQ(read_file(folder_ / "x.txt"), "new");
    EXPECT_EQ(entries(), 2u);
    fs::remove(folder_ / "x.txt");
    write_text_file(folder_ / "link.txt", "again");
    EXPECT_TRUE(fs::is_symlink(folder_ / "link.txt"));
    EXPECT_EQ(read_file(folder_ / "x.txt"), "again");
}

TEST_F(Files, APipeIsWrittenIntoAndStays) {
    const fs::path pipe = folder_ / "pipe.txt";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::string got;
    std::thread reader([&] { std::getline(std::ifstream(pipe), got); });
    write_text_file(pipe, "through\n");
    reader.join();
    EXPECT_EQ(got, "through");
    EXPECT_TRUE(fs::is_fifo(pipe));
    EXPECT_EQ(entries(), 1u);
}

TEST_F(Files, APipeIsNoInput) {
    const fs::path pipe = folder_ / "pipe.toml";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(reason_of(pipe), "is a pipe, not a file: save what comes out of it");
    try {
        require_readable_file(pipe);
        FAIL() << "nothing thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.reason(), "is a pipe, not a file: save what comes out of it");
    }
}

TEST_F(Files, AWaitForTheReaderOfAPipeEndsWithAStop) {
    const fs::path pipe = folder_ / "pipe.txt";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    int asked = 0;
    const StopScope nobody_reads([&] { return ++asked == 3; });
    EXPECT_THROW(write_text_file(pipe, "through\n"), Cancelled);
    const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    asked = 0;
    EXPECT_THROW(write_text_file(pipe, std::string(1 << 20, 'x')), Cancelled) << "it is full";
    close(reader);
}

TEST_F(Files, APathIsWithinAFolderWhateverLinksLeadThere) {
    fs::create_directories(folder_ / "suite/baselines");
    fs::create_directory_symlink("suite/baselines", folder_ / "link");
    const fs::path baselines = folder_ / "suite/baselines";
    EXPECT_TRUE(lies_within(baselines, baselines));
    EXPECT_TRUE(lies_within(folder_ / "link/new/deep", baselines));
    EXPECT_TRUE(lies_within(folder_ / "suite/other/../baselines/", baselines));
    EXPECT_FALSE(lies_within(folder_ / "suite", baselines));
    EXPECT_FALSE(lies_within(folder_ / "suite/baselines-2", baselines));
}

TEST_F(Files, WritingIntoAMissingFolderNamesTheTarget) {
    try {
        write_text_file(folder_ / "no" / "x.txt", "text");
        FAIL() << "nothing thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.file(), (folder_ / "no" / "x.txt").string());
    }
}

TEST_F(Files, ATargetThatCannotBeLookedAtIsAnErrorOfThatFile) {
    const fs::path target = folder_ / std::string(300, 'a');
    try {
        write_text_file(target, "text");
        FAIL() << "nothing thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.file(), target.string());
    }
}

TEST(ErrorText, NamesFilePlaceAndReasonOnOneLine) {
    EXPECT_STREQ(Error("rig.toml", "3:1", "unknown key").what(), "rig.toml:3:1: unknown key");
    EXPECT_STREQ(Error("rig.toml", "", "empty").what(), "rig.toml: empty");
    EXPECT_STREQ(Error("", "camera", "unknown").what(), "camera: unknown");
    EXPECT_STREQ(FieldError("views", "unknown").what(), "views: unknown");
}
