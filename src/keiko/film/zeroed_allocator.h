#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace keiko {

/// Has the kernel back what will be touched of a large piece of memory by few large pages, where it
/// can: thousands of small ones each stop the thread that touches them first.
inline void ask_for_large_pages(void* memory, std::size_t bytes) {
    constexpr std::size_t page = std::size_t{2} << 20;
    if (std::align(page, page, memory, bytes)) madvise(memory, bytes / page * page, MADV_HUGEPAGE);
}

/// Memory of zeros, on pages that a large picture's threads touch first, each its own: clearing
/// them in one thread takes longer than some pictures need. What is made without a value there is
/// left as it is, and so is zero once: containers must not be shortened and made longer again.
template <class T>
struct ZeroedAllocator {
    static_assert(std::is_trivial_v<T>, "zeros must be a value, and need no construction");
    static_assert(alignof(T) <= alignof(std::max_align_t), "std::calloc aligns no further");

    using value_type = T;

    ZeroedAllocator() = default;
    template <class U>
    explicit ZeroedAllocator(const ZeroedAllocator<U>&) {}

    T* allocate(std::size_t count) {
        void* const memory = std::calloc(count, sizeof(T));
        if (!memory) throw std::bad_alloc();
        ask_for_large_pages(memory, count * sizeof(T));
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t) { std::free(memory); }

    void construct(T*) {}
    template <class... Values>
    void construct(T* at, Values&&... values) {
        ::new (static_cast<void*>(at)) T(std::forward<Values>(values)...);
    }

    bool operator==(const ZeroedAllocator&) const = default;
};

} // namespace keiko
