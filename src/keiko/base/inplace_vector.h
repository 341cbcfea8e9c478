#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>

namespace keiko {

/// Up to `capacity` values in order, kept in place: a vector that asks for no memory.
template <class T, std::size_t capacity>
class InplaceVector {
public:
    using value_type = T;

    /// Throws std::length_error beyond the capacity.
    void push_back(const T& value) {
        if (size_ == capacity) throw std::length_error("a short list is full");
        values_[size_++] = value;
    }
    const T& operator[](std::size_t i) const { return values_[i]; }
    const T& back() const { return values_[size_ - 1]; }
    const T* data() const { return values_.data(); }
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    const T* begin() const { return data(); }
    const T* end() const { return data() + size_; }

private:
    std::array<T, capacity> values_;
    std::size_t size_ = 0;
};

} // namespace keiko
