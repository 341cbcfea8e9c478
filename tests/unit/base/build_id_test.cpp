#include "keiko/base/build_id.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstddef>

namespace keiko {
namespace {

/// build_id() as a shared library has it that this program loads.
std::string id_of_library() {
    void* const library = dlopen(KEIKO_LIBRARY_PROBE, RTLD_NOW | RTLD_LOCAL);
    if (!library) return dlerror();
    const auto digit =
        reinterpret_cast<char (*)(std::size_t)>(dlsym(library, "keiko_build_id_digit"));
    std::string id;
    while (const char next = digit(id.size())) id += next;
    dlclose(library);
    return id;
}

TEST(BuildId, IsThatOfTheLibraryWithTheCodeNotOfTheProgramThatLoadedIt) {
    EXPECT_EQ(id_of_library(), "0123456789abcdef"); // as CMakeLists.txt has it linked
    EXPECT_NE(id_of_library(), build_id());
}

TEST(BuildId, OfAProgramIsAHashByTheLinker) {
    EXPECT_EQ(build_id().size(), 40u);
    EXPECT_EQ(build_id().find_first_not_of("0123456789abcdef"), std::string::npos);
}

} // namespace
} // namespace keiko
