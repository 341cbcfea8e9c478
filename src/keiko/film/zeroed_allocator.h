#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <type_traits>
#include <utility>

namespace keiko {

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
        if (void* const memory = std::calloc(count, sizeof(T))) return static_cast<T*>(memory);
        throw std::bad_alloc();
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
