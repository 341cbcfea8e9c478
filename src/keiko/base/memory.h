#pragma once

#include "keiko/base/export.h"

#include <array>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace KEIKO_API keiko {

/// Allocator for vectors of large records that are made blank and filled in at once: a record made
/// without a value has what its members' initialisers say. std::allocator has all of it cleared
/// before.
template <class T>
struct DefaultInitAllocator : std::allocator<T> {
    /// Tells the allocator of another type.
    template <class U>
    struct rebind { // NOLINT(readability-identifier-naming): std::allocator_traits looks for it
        using other = DefaultInitAllocator<U>; ///< that allocator
    };

    DefaultInitAllocator() = default;
    /// Allocators of all types are alike.
    template <class U>
    explicit DefaultInitAllocator(const DefaultInitAllocator<U>&) {}

    /// Makes a record without a value.
    template <class U>
    void construct(U* at) {
        ::new (static_cast<void*>(at)) U;
    }
    /// Makes a record from values.
    template <class U, class... Values>
    void construct(U* at, Values&&... values) {
        std::construct_at(at, std::forward<Values>(values)...);
    }
};

/// Requests large pages from the kernel for what will be touched of a large piece of memory, where
/// it has them. Thousands of small ones each stop the thread that touches them first.
void request_large_pages(void* memory, std::size_t bytes);

/// Allocator of zeros, on pages that a large picture's threads touch first, each its own: clearing
/// them in one thread takes longer than some pictures need. What is made without a value there is
/// left as it is, and so is zero once: containers must not be shortened and made longer again.
template <class T>
struct ZeroedAllocator {
    static_assert(std::is_trivial_v<T>, "zeros must be a value, and need no construction");
    static_assert(alignof(T) <= alignof(std::max_align_t), "std::calloc aligns no further");

    using value_type = T; ///< type of the elements

    ZeroedAllocator() = default;
    /// Allocators of all types are alike.
    template <class U>
    explicit ZeroedAllocator(const ZeroedAllocator<U>&) {}

    /// Memory for `count` elements, all zero. Throws std::bad_alloc.
    T* allocate(std::size_t count) {
        void* const memory = std::calloc(count, sizeof(T));
        if (!memory) throw std::bad_alloc();
        request_large_pages(memory, count * sizeof(T));
        return static_cast<T*>(memory);
    }
    /// Frees what allocate returned.
    void deallocate(T* memory, std::size_t) { std::free(memory); }

    /// Leaves the zeros that are there.
    void construct(T*) {}
    /// Makes an element from values.
    template <class... Values>
    void construct(T* at, Values&&... values) {
        ::new (static_cast<void*>(at)) T(std::forward<Values>(values)...);
    }

    bool operator==(const ZeroedAllocator&) const = default;
};

/// Up to `capacity` values in order, kept in place: a vector that allocates no memory.
template <class T, std::size_t capacity>
class InplaceVector {
public:
    using value_type = T; ///< type of the elements

    /// Throws std::length_error beyond the capacity.
    void push_back(const T& value) {
        if (size_ == capacity) throw std::length_error("a short list is full");
        values_[size_++] = value;
    }
    /// Element i, below size().
    const T& operator[](std::size_t i) const { return values_[i]; }
    /// The last element; there must be one.
    const T& back() const { return values_[size_ - 1]; }
    /// The first of the elements, which lie side by side.
    const T* data() const { return values_.data(); }
    /// Number of elements.
    std::size_t size() const { return size_; }
    /// True if it has no element.
    bool empty() const { return size_ == 0; }
    /// The first element.
    const T* begin() const { return data(); }
    /// One past the last element.
    const T* end() const { return data() + size_; }

private:
    std::array<T, capacity> values_;
    std::size_t size_ = 0;
};

/// Keeps freed memory with the process: blocks of up to 4 MB, and up to 64 MB of free memory at the
/// top of each heap. To be called in a program's first line. By default glibc hands that back to
/// the system, and then each tile of a picture has its pages made and cleared anew, which costs up
/// to a third of the time. Larger blocks, such as pictures, come from the system, zero already.
/// Leaves alone what MALLOC_TRIM_THRESHOLD_ or MALLOC_MMAP_THRESHOLD_ set; does nothing with other
/// libraries.
void keep_freed_memory();

} // namespace keiko
