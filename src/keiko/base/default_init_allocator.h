#pragma once

#include <memory>
#include <new>
#include <utility>

namespace keiko {

/// For vectors of large records that are made blank and filled in at once: a record made without a
/// value has what its members' initialisers say. std::allocator has all of it cleared before.
template <class T>
struct DefaultInitAllocator : std::allocator<T> {
    template <class U>
    struct rebind { // NOLINT(readability-identifier-naming): std::allocator_traits looks for it
        using other = DefaultInitAllocator<U>;
    };

    DefaultInitAllocator() = default;
    template <class U>
    explicit DefaultInitAllocator(const DefaultInitAllocator<U>&) {}

    template <class U>
    void construct(U* at) {
        ::new (static_cast<void*>(at)) U;
    }
    template <class U, class... Values>
    void construct(U* at, Values&&... values) {
        std::construct_at(at, std::forward<Values>(values)...);
    }
};

} // namespace keiko
