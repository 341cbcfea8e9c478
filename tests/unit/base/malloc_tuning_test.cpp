#include "keiko/base/memory.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <memory>
#include <vector>

namespace keiko {
namespace {

constexpr std::size_t page = 4096;

long faults() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_minflt;
}

/// Takes, touches and frees memory in pieces of a page.
void churn(std::size_t pages) {
    std::vector<std::unique_ptr<char[]>> pieces(pages);
    for (std::unique_ptr<char[]>& piece : pieces) {
        piece.reset(new char[page]);
        static_cast<volatile char*>(piece.get())[page / 2] = 1;
    }
}

TEST(KeptMemory, IsThereAgainWithoutNewPages) {
#if !defined(__GLIBC__) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "not glibc's allocator";
#endif
    keep_freed_memory();
    churn(2000);
    const long before = faults();
    churn(2000);
    EXPECT_LT(faults() - before, 200);
}

} // namespace
} // namespace keiko
