#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace keiko {

static_assert(std::endian::native == std::endian::little,
              "numbers are written as they lie in memory, which must be little-endian");

/// Appends values to a string of bytes, little-endian, without padding.
class ByteWriter {
public:
    template <class T>
    requires std::is_arithmetic_v<T>
    void put(T value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); }
    void put(std::string_view text) {
        put(static_cast<std::uint64_t>(text.size()));
        bytes_.append(text);
    }
    void put_bytes(std::string_view bytes) { bytes_.append(bytes); }
    /// Writes over a value that was put before.
    void replace(std::size_t at, std::uint64_t value) {
        std::memcpy(&bytes_[at], &value, sizeof value);
    }
    void reserve(std::size_t size) { bytes_.reserve(size); }
    const std::string& bytes() const { return bytes_; }
    std::string take() && { return std::move(bytes_); }

private:
    std::string bytes_;
};

/// What a ByteReader throws when the bytes do not hold what is asked for.
class DamagedBytes : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Takes values from bytes; never reads beyond them.
class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

    template <class T>
    requires std::is_arithmetic_v<T> T take() {
        T value;
        std::memcpy(&value, take_bytes(sizeof value).data(), sizeof value);
        return value;
    }
    std::string take_text() { return std::string(take_bytes(take_count(1))); }
    /// A count of elements that need at least `least_size` bytes each: more of them than bytes
    /// remain is damage, found before anything is allocated.
    std::size_t take_count(std::size_t least_size);
    std::size_t remaining() const { return bytes_.size(); }

private:
    std::string_view take_bytes(std::size_t count);

    std::string_view bytes_;
};

/// FNV-1a, 64 bits.
std::uint64_t checksum(std::string_view bytes);

} // namespace keiko
