#include "keiko/intersect/hit/hit.h"

#include <array>
#include <cstdio>

namespace keiko {

namespace {

std::string share(std::uint64_t part, std::uint64_t whole) {
    std::array<char, 32> text{};
    const double percent =
        whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
    std::snprintf(text.data(), text.size(), "%.2f %% ", percent);
    return text.data();
}

} // namespace

void HitStatistics::count(const Hit& hit) {
    std::uint64_t& path = has(hit.flags, HitFlags::tangential) ? tangential
                          : has(hit.flags, HitFlags::clipped)  ? clipped
                                                               : unique;
    ++path;
}

HitStatistics& HitStatistics::operator+=(const HitStatistics& other) {
    unique += other.unique, clipped += other.clipped, tangential += other.tangential;
    return *this;
}

std::string path_text(const HitStatistics& counts) {
    const std::uint64_t sum = counts.sum();
    return std::to_string(sum) + " hits: " + share(counts.unique, sum) + "unique, " +
           share(counts.clipped, sum) + "clipped, " + share(counts.tangential, sum) + "tangential";
}

} // namespace keiko
