#include "keiko/visibility/query/bucket_grid.h"

#include <numeric>

namespace keiko {
namespace {

std::size_t bucket_count(std::size_t boxes) {
    return std::clamp<std::size_t>(boxes, 512, 4096);
}

} // namespace

BucketGrid::BucketGrid(std::vector<ScanBounds> boxes, double low, double high)
    : boxes_(std::move(boxes)),
      low_(low),
      per_width_(static_cast<double>(bucket_count(boxes_.size())) / std::max(high - low, 1e-12)),
      first_(bucket_count(boxes_.size()) + 1, 0) {
    const auto each_place = [&](const auto& visit) {
        for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
            if (boxes_[i].empty()) continue;
            const std::size_t last = bucket_of(boxes_[i].across_high);
            for (std::size_t b = bucket_of(boxes_[i].across_low); b <= last; ++b) visit(b, i);
        }
    };
    each_place([&](std::size_t bucket, std::uint32_t) { ++first_[bucket + 1]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    members_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    each_place([&](std::size_t bucket, std::uint32_t box) { members_[next[bucket]++] = box; });
}

} // namespace keiko
