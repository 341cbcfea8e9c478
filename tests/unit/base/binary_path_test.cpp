#include "keiko/base/build_id.h"

#include "tests/support/temporary_folder.h"
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstddef>

namespace keiko {
namespace {

namespace fs = std::filesystem;

/// binary_path() as a shared library has it that this program loads.
fs::path path_in_library(const fs::path& file) {
    void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library) return dlerror();
    const auto character =
        reinterpret_cast<char (*)(std::size_t)>(dlsym(library, "keiko_binary_path_character"));
    std::string path;
    while (const char next = character(path.size())) path += next;
    dlclose(library);
    return path;
}

TEST(BinaryPath, IsThatOfTheLibraryWithTheCodeNotOfTheProgramThatLoadedIt) {
    EXPECT_EQ(path_in_library(KEIKO_LIBRARY_PROBE), fs::canonical(KEIKO_LIBRARY_PROBE));
}

TEST(BinaryPath, FollowsTheLinksThatALibraryIsLoadedBy) {
    const test::TemporaryFolder folder;
    const fs::path link = folder.path() / "link.so";
    fs::create_symlink(KEIKO_LIBRARY_PROBE, link);
    EXPECT_EQ(path_in_library(link), fs::canonical(KEIKO_LIBRARY_PROBE));
}

TEST(BinaryPath, OfAProgramIsItsOwn) {
    EXPECT_EQ(binary_path(), fs::canonical("/proc/self/exe"));
}

} // namespace
} // namespace keiko
