#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/new_file.h"
#include "keiko/base/output_file.h"

#include "tests/support/abandoned_name.h"
#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <thread>

// What others may have put where Keiko writes, to have it write somewhere else.

namespace keiko {
namespace {
namespace fs = std::filesystem;

/// A file of the user that a link of somebody else leads to.
struct Planted : testing::Test {
    test::TemporaryFolder folder;
    fs::path victim = folder.file("victim", "precious");

    /// A folder where everybody may write, as /tmp is.
    fs::path shared_folder() const {
        const fs::path shared = folder.path() / "shared";
        fs::create_directory(shared);
        EXPECT_EQ(chmod(shared.c_str(), 01777), 0);
        return shared;
    }
};

std::string reason_of_writing(const fs::path& path) {
    try {
        write_text_file(path, "text");
    } catch (const Error& error) {
        EXPECT_EQ(error.file(), path.string());
        return error.reason();
    }
    return "no error";
}

constexpr uid_t somebody_else = 65534;

TEST_F(Planted, LinksBesideAnOutputAreNotFollowed) {
    const std::string pid = std::to_string(getpid());
    for (const std::string& name : {".x." + pid + ".tmp.txt", ".x.txt." + pid + ".tmp"})
        fs::create_symlink(victim, folder.path() / name);
    write_text_file(folder.path() / "x.txt", "text");
    EXPECT_EQ(read_file(folder.path() / "x.txt"), "text");
    EXPECT_EQ(read_file(victim), "precious");
}

TEST_F(Planted, NothingGoesThroughTheFolderOfTemporaryFiles) {
    const fs::path temporary = folder.path() / "tmp";
    fs::create_directory(temporary);
    for (int i = 1; i <= 100; ++i)
        fs::create_symlink(victim, temporary / (".null-" + std::to_string(i) + "." +
                                                std::to_string(getpid()) + ".tmp"));
    const char* const before = std::getenv("TMPDIR");
    const std::string kept = before ? before : "";
    setenv("TMPDIR", temporary.c_str(), 1);
    write_text_file("/dev/null", "text");
    before ? setenv("TMPDIR", kept.c_str(), 1) : unsetenv("TMPDIR");
    EXPECT_EQ(read_file(victim), "precious");
}

TEST_F(Planted, ALinkOfAnotherUserInASharedFolderIsRefused) {
    if (geteuid() != 0) GTEST_SKIP() << "only root may give a link away";
    const fs::path link = shared_folder() / "x.txt";
    fs::create_symlink(victim, link);
    ASSERT_EQ(lchown(link.c_str(), somebody_else, somebody_else), 0);
    for (const mode_t mode : {01777, 0777}) {
        ASSERT_EQ(chmod(link.parent_path().c_str(), mode), 0);
        EXPECT_EQ(reason_of_writing(link),
                  "is a link of another user in a folder where everybody may write");
    }
    EXPECT_EQ(read_file(victim), "precious");
}

TEST_F(Planted, ALinkOfTheUserInASharedFolderIsFollowed) {
    const fs::path link = shared_folder() / "x.txt";
    fs::create_symlink("../victim", link);
    write_text_file(link, "text");
    EXPECT_EQ(read_file(victim), "text");
}

TEST_F(Planted, APipeOfAnotherUserInASharedFolderIsRefused) {
    if (geteuid() != 0) GTEST_SKIP() << "only root may give a pipe away";
    const fs::path pipe = shared_folder() / "x.txt";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0666), 0);
    ASSERT_EQ(chown(pipe.c_str(), somebody_else, somebody_else), 0);
    EXPECT_EQ(reason_of_writing(pipe),
              "is a pipe of another user in a folder where everybody may write");
}

TEST_F(Planted, LinksInACircleAreAnError) {
    fs::create_symlink("b", folder.path() / "a");
    fs::create_symlink("a", folder.path() / "b");
    EXPECT_EQ(reason_of_writing(folder.path() / "a"), "is a link that leads nowhere");
}

TEST_F(Planted, ANewFileTakesNoPlaceThatIsTaken) {
    fs::create_symlink(victim, folder.path() / "link");
    fs::create_symlink("nowhere", folder.path() / "dangling");
    for (const fs::path& taken : {victim, folder.path() / "link", folder.path() / "dangling"}) {
        try {
            create_file(taken);
            FAIL() << "nothing thrown";
        } catch (const Error& error) {
            EXPECT_EQ(error.reason(), "cannot write: File exists");
        }
    }
    EXPECT_EQ(read_file(victim), "precious");
    EXPECT_FALSE(fs::exists(folder.path() / "nowhere"));
}

TEST(TemporaryName, IsNeverTheSameAndOfAProcessThatRuns) {
    const std::string first = temporary_name(), second = temporary_name();
    EXPECT_NE(first, second);
    EXPECT_FALSE(is_abandoned(first));
    const std::string gone = test::abandoned_name();
    EXPECT_TRUE(is_abandoned(gone));
    const std::string end = gone.substr(gone.find("99-") + 2);
    for (const std::string& other :
         {".keiko-" + end, ".keiko-x" + end, std::string(".keiko-999999999.tmp"), gone.substr(1),
          gone + "l", std::string()})
        EXPECT_FALSE(is_abandoned(other)) << other;
}

TEST(TemporaryName, OfAnotherMachineIsNotJudged) {
    const std::string gone = test::abandoned_name();
    const std::string here = gone.substr(gone.find('-', gone.find("99-") + 3));
    const std::string nameless = gone.substr(0, gone.size() - here.size());
    EXPECT_FALSE(is_abandoned(nameless + "-elsewhere.tmp"));
    EXPECT_FALSE(is_abandoned(nameless + "-rack" + here)) << "of a machine whose name ends so";
}

TEST(Streams, AReaderThatGoesAwayIsAnErrorAndEndsNobody) {
    const test::TemporaryFolder folder;
    const fs::path pipe = folder.path() / "pipe.txt";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::thread reader([&] { std::ifstream(pipe).get(); });
    try {
        write_text_file(pipe, std::string(1'000'000, 'a'));
        ADD_FAILURE() << "nothing thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.reason(), "cannot write: Broken pipe");
    }
    reader.join();
}

TEST(Streams, ADeviceThatTakesNothingSaysWhy) {
    EXPECT_EQ(reason_of_writing("/dev/full"), "cannot write: No space left on device");
}

TEST(Streams, ASocketIsRefused) {
    const test::TemporaryFolder folder;
    const fs::path path = folder.path() / "socket";
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    const Descriptor socket(::socket(AF_UNIX, SOCK_STREAM, 0));
    ASSERT_EQ(bind(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address),
              0);
    EXPECT_EQ(reason_of_writing(path), "is a socket, not a file");
}

} // namespace
} // namespace keiko
