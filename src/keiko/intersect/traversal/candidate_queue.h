#pragma once

#include "keiko/intersect/kernels/ray_packet.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

namespace keiko {

/// A sub-patch that may hold roots of a ray, between two distances along it.
struct CandidatePatch {
    std::uint32_t box = 0;
    bool single = false;   ///< at most one root
    bool doubtful = false; ///< what is behind it may be the nearest hit
    double nearest = 0, farthest = 0;
};

/// The sub-patches that a search has put off: a list for each ray of a block, all in one array.
class CandidateQueue {
public:
    void clear() {
        entries_.clear();
        first_.fill(none);
        doubtful_until_.fill(infinity);
        lanes_ = doubtful_ = 0;
    }
    void clear(std::size_t lane) {
        first_[lane] = none;
        lanes_ &= ~(LaneMask{1} << lane);
        find_doubtful(lane);
    }
    void add(std::size_t lane, const CandidatePatch& sub_patch) {
        entries_.push_back({sub_patch, first_[lane]});
        first_[lane] = static_cast<std::uint32_t>(entries_.size() - 1);
        lanes_ |= LaneMask{1} << lane;
        if (sub_patch.doubtful) note_doubtful(lane, sub_patch.farthest);
    }
    /// Takes out the nearest sub-patch that begins before `high` and ends before `until`. Leaves
    /// that begin behind `high` are forgotten.
    std::optional<CandidatePatch> take(std::size_t lane, double high, double until);

    /// Those that have any.
    LaneMask lanes() const { return lanes_; }
    /// Those that have a doubtful one, and where the first of them ends.
    LaneMask doubtful() const { return doubtful_; }
    double doubtful_until(std::size_t lane) const { return doubtful_until_[lane]; }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    struct Entry {
        CandidatePatch sub_patch;
        std::uint32_t next;
    };

    void note_doubtful(std::size_t lane, double farthest) {
        doubtful_until_[lane] = std::min(doubtful_until_[lane], farthest);
        doubtful_ |= LaneMask{1} << lane;
    }
    void find_doubtful(std::size_t lane) {
        doubtful_until_[lane] = infinity;
        doubtful_ &= ~(LaneMask{1} << lane);
        for (std::uint32_t i = first_[lane]; i != none; i = entries_[i].next)
            if (entries_[i].sub_patch.doubtful) note_doubtful(lane, entries_[i].sub_patch.farthest);
    }

    std::vector<Entry> entries_;
    RayPacket::Lanes<std::uint32_t> first_{}; ///< of the list, into entries_
    RayPacket::Lanes<double> doubtful_until_{};
    LaneMask lanes_ = 0, doubtful_ = 0;
};

inline std::optional<CandidatePatch> CandidateQueue::take(std::size_t lane, double high,
                                                          double until) {
    std::uint32_t* best = nullptr;
    for (std::uint32_t* link = &first_[lane]; *link != none;) {
        const Entry& entry = entries_[*link];
        const bool possible = entry.sub_patch.nearest <= high;
        if (possible && entry.sub_patch.farthest <= until &&
            (!best || entry.sub_patch.nearest < entries_[*best].sub_patch.nearest))
            best = link;
        if (possible)
            link = &entries_[*link].next;
        else
            *link = entry.next;
    }
    std::optional<CandidatePatch> taken;
    if (best) {
        taken = entries_[*best].sub_patch;
        *best = entries_[*best].next;
    }
    if (first_[lane] == none) lanes_ &= ~(LaneMask{1} << lane);
    if ((doubtful_ >> lane & 1) != 0) find_doubtful(lane);
    return taken;
}

} // namespace keiko
