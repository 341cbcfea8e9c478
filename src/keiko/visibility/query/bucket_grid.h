#pragma once

#include "keiko/visibility/query/scan_plane.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace keiko {

/// Boxes of a screen in order of where they lie across its scan lines, to find those that one line
/// after the other meets.
class BucketGrid {
public:
    /// `low` to `high`: the places across that will mostly be asked for.
    BucketGrid(std::vector<ScanBounds> boxes, double low, double high);

    /// Calls `visit` with the number of each box that meets a scan line between two places along
    /// it, rising.
    template <class Visit>
    void each_met(double across, double along_low, double along_high, const Visit& visit) const {
        const std::size_t bucket = bucket_of(across);
        for (std::uint32_t i = first_[bucket]; i < first_[bucket + 1]; ++i) {
            const ScanBounds& box = boxes_[members_[i]];
            if (box.across_low <= across && box.across_high >= across &&
                box.along_low <= along_high && box.along_high >= along_low)
                visit(members_[i]);
        }
    }

private:
    std::size_t bucket_of(double across) const {
        const double place = (across - low_) * per_width_;
        return place > 0 ? static_cast<std::size_t>(
                               std::min(place, static_cast<double>(first_.size() - 2)))
                         : 0;
    }

    std::vector<ScanBounds> boxes_;
    double low_, per_width_;
    std::vector<std::uint32_t> first_;   ///< of each bucket's members, and their number
    std::vector<std::uint32_t> members_; ///< numbers of boxes
};

} // namespace keiko
