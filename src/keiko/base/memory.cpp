#include "keiko/base/memory.h"

#include <sys/mman.h>

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace keiko {

void request_large_pages(void* memory, std::size_t bytes) {
    constexpr std::size_t page = std::size_t{2} << 20;
    if (std::align(page, page, memory, bytes)) madvise(memory, bytes / page * page, MADV_HUGEPAGE);
}

void keep_freed_memory() {
#ifdef __GLIBC__
    if (std::getenv("MALLOC_TRIM_THRESHOLD_") || std::getenv("MALLOC_MMAP_THRESHOLD_")) return;
    mallopt(M_TRIM_THRESHOLD, 64 << 20);
    mallopt(M_MMAP_THRESHOLD, 4 << 20);
#endif
}

} // namespace keiko
