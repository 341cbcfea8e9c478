#pragma once

#include "keiko/base/export.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace KEIKO_API keiko {

static_assert(std::endian::native == std::endian::little,
              "numbers are written as they lie in memory, which must be little-endian");

/// Takes bytes, piece by piece.
using TakeBytes = std::function<void(std::string_view piece)>;

/// Hands values on as bytes, little-endian, without padding, in pieces of a size that files and
/// pipes like.
class ByteWriter {
public:
    /// Writer that hands its bytes to `sink`, once flush() has been called all of them.
    explicit ByteWriter(TakeBytes sink) : sink_(std::move(sink)) {}

    /// Writes a number as it lies in memory.
    template <class T>
    requires std::is_arithmetic_v<T>
    void put(T value) { put_bytes({reinterpret_cast<const char*>(&value), sizeof value}); }
    /// Writes a text: the number of its bytes in 64 bits, then these.
    void put(std::string_view text) {
        put(static_cast<std::uint64_t>(text.size()));
        put_bytes(text);
    }
    /// Writes bytes without their number. More of them than a piece holds reach the sink at once.
    void put_bytes(std::string_view bytes) {
        if (bytes.size() > piece_.size() - size_) flush();
        if (bytes.size() > piece_.size()) return sink_(bytes);
        std::memcpy(piece_.data() + size_, bytes.data(), bytes.size());
        size_ += bytes.size();
    }
    /// Hands on what has not been yet.
    void flush() {
        sink_({piece_.data(), size_});
        size_ = 0;
    }

private:
    TakeBytes sink_;
    std::size_t size_ = 0;
    std::array<char, 1 << 16> piece_;
};

/// Exception of a ByteReader whose bytes do not hold the requested value.
class DamagedBytes : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Takes values from bytes; never reads beyond them.
class ByteReader {
public:
    /// Reader of bytes that must outlive it.
    explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

    /// Takes a number as ByteWriter::put writes it. Throws DamagedBytes if too few bytes remain.
    template <class T>
    requires std::is_arithmetic_v<T> T take() {
        T value;
        std::memcpy(&value, take_bytes(sizeof value).data(), sizeof value);
        return value;
    }
    /// Takes a text as ByteWriter::put writes it. Throws DamagedBytes if it would end beyond the
    /// last byte.
    std::string take_text() { return std::string(take_bytes(take_count(1))); }
    /// Takes a count of elements that need at least `least_size` > 0 bytes each: more of them than
    /// bytes remain is damage, found before anything is allocated.
    std::size_t take_count(std::size_t least_size);
    /// Number of bytes that have not been taken.
    std::size_t remaining() const { return bytes_.size(); }

private:
    std::string_view take_bytes(std::size_t count);

    std::string_view bytes_;
};

/// FNV-1a hash [FNV] of 64 bits of pieces that follow each other.
class Checksum {
public:
    /// Appends bytes; their division into pieces has no effect.
    void add(std::string_view bytes);
    /// Hash of all bytes so far.
    std::uint64_t value() const { return hash_; }

private:
    std::uint64_t hash_ = 0xcbf29ce484222325;
};

inline std::size_t ByteReader::take_count(std::size_t least_size) {
    const auto count = take<std::uint64_t>();
    if (count > bytes_.size() / least_size) throw DamagedBytes("a count beyond the end");
    return static_cast<std::size_t>(count);
}

inline std::string_view ByteReader::take_bytes(std::size_t count) {
    if (count > bytes_.size()) throw DamagedBytes("it ends too early");
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
}

inline void Checksum::add(std::string_view bytes) {
    std::uint64_t hash = hash_;
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    hash_ = hash;
}

/// FNV-1a hash of bytes in one piece.
inline std::uint64_t checksum(std::string_view bytes) {
    Checksum sum;
    sum.add(bytes);
    return sum.value();
}

} // namespace keiko
