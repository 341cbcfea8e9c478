#include "keiko/files/model/byte_stream.h"

namespace keiko {

std::size_t ByteReader::take_count(std::size_t least_size) {
    const auto count = take<std::uint64_t>();
    if (count > bytes_.size() / least_size) throw DamagedBytes("a count beyond the end");
    return static_cast<std::size_t>(count);
}

std::string_view ByteReader::take_bytes(std::size_t count) {
    if (count > bytes_.size()) throw DamagedBytes("it ends too early");
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
}

void Checksum::add(std::string_view bytes) {
    std::uint64_t hash = hash_;
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    hash_ = hash;
}

std::uint64_t checksum(std::string_view bytes) {
    Checksum sum;
    sum.add(bytes);
    return sum.value();
}

} // namespace keiko
