#pragma once

#include "keiko/intersect/kernels/ray_packet.h"
#include "keiko/intersect/kernels/sub_patch_kernels.h"
#include "keiko/intersect/traversal/bezier_clipping.h"
#include "keiko/intersect/traversal/embree_scene.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// A sub-patch that may hold roots of a ray, between two distances along it.
struct CandidatePatch {
    std::uint32_t box = 0;            ///< index among the placed sub-patches
    bool single = false;              ///< at most one root
    bool doubtful = false;            ///< what is behind it may be the nearest hit
    double nearest = 0, farthest = 0; ///< mm along the ray from its start
};

/// The sub-patches that a search has put off: a list for each ray of a block, all in one array.
class CandidateQueue {
public:
    /// Forgets every candidate of every lane.
    void clear() {
        entries_.clear();
        lanes_ = doubtful_ = 0;
    }
    /// Forgets the candidates of one lane.
    void clear(std::size_t lane) {
        lanes_ &= ~bit(lane);
        doubtful_ &= ~bit(lane);
    }
    /// Puts a sub-patch off for one lane.
    void add(std::size_t lane, const CandidatePatch& sub_patch) {
        entries_.push_back({sub_patch, (lanes_ & bit(lane)) != 0 ? first_[lane] : none});
        first_[lane] = static_cast<std::uint32_t>(entries_.size() - 1);
        lanes_ |= bit(lane);
        if (sub_patch.doubtful) note_doubtful(lane, sub_patch.farthest);
    }
    /// Takes out the nearest sub-patch that begins before `high` and ends before `until`; nothing
    /// where there is none. Sub-patches that begin behind `high` are forgotten.
    std::optional<CandidatePatch> take(std::size_t lane, double high, double until);

    /// Lanes that have any candidate.
    LaneMask lanes() const { return lanes_; }
    /// Lanes that have a doubtful candidate.
    LaneMask doubtful() const { return doubtful_; }
    /// Least distance, mm, at which a doubtful candidate of a lane of doubtful() ends.
    double doubtful_until(std::size_t lane) const { return doubtful_until_[lane]; }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    static constexpr LaneMask bit(std::size_t lane) { return LaneMask{1} << lane; }

    struct Entry {
        CandidatePatch sub_patch;
        std::uint32_t next;
    };

    void note_doubtful(std::size_t lane, double farthest) {
        const bool first = (doubtful_ & bit(lane)) == 0;
        doubtful_until_[lane] = first ? farthest : std::min(doubtful_until_[lane], farthest);
        doubtful_ |= bit(lane);
    }
    void find_doubtful(std::size_t lane) {
        doubtful_ &= ~bit(lane);
        for (std::uint32_t i = first_[lane]; i != none; i = entries_[i].next)
            if (entries_[i].sub_patch.doubtful) note_doubtful(lane, entries_[i].sub_patch.farthest);
    }

    std::vector<Entry> entries_;
    RayPacket::Lanes<std::uint32_t> first_{};   ///< of the list, into entries_, for `lanes_`
    RayPacket::Lanes<double> doubtful_until_{}; ///< for `doubtful_`
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
    if (first_[lane] == none) lanes_ &= ~bit(lane);
    if ((doubtful_ >> lane & 1) != 0) find_doubtful(lane);
    return taken;
}

/// All that a search reads.
struct SearchScene {
    const TracedModel& model;       ///< the surfaces
    const EmbreeScene& boxes;       ///< one box for each of TracedModel::placed
    const SubPatchKernels& kernels; ///< of this processor
    bool clipping_only = false;     ///< as TracerOptions has it
    /// By placed sub-patch whether rays pass through it; null: through none.
    const std::vector<bool>* hidden = nullptr;
};

/// The search of up to 16 rays at once, as one packet when they are coherent. A sub-patch that the
/// existence test does not rule out is kept for later. A proved root already ends the ray behind
/// it, and only candidates that may still be the nearest in the end are solved. Keeps its buffers
/// between runs; not for two threads at once.
class PacketIntersector final : EmbreeScene::Visitor {
public:
    /// Puts the nearest crossing of each ray into `found`, which must hold as many without a hit.
    void nearest(const SearchScene& scene, std::span<const Ray> rays, std::span<Crossing> found);
    /// The rays that cross anything.
    LaneMask any(const SearchScene& scene, std::span<const Ray> rays);
    /// Every crossing of each ray, in no order; until the next search.
    std::span<const std::vector<Crossing>> all(const SearchScene& scene, std::span<const Ray> rays);

private:
    enum class Goal { nearest, any, all };

    void run(const SearchScene& scene, Goal goal, std::span<const Ray> rays);
    LaneMask visit(std::uint32_t box, LaneMask lanes) override;
    void fetch_polynomial(const PackedSubPatch& hot) const;
    /// Between which distances a sub-patch without bounds can be met.
    struct Reach {
        double nearest, farthest;
    };
    Reach reach(std::size_t lane, std::uint32_t box) const;
    /// Puts the sub-patch off if it may hold the hit, by the last existence test; returns whether
    /// it did.
    bool enqueue(std::size_t lane, std::uint32_t box);
    /// Solves what is pending in lanes and ends before their `until`.
    void resolve(LaneMask lanes, const RayPacket::Lanes<double>& until);
    /// Lanes that are best solved together: several on one sub-patch, else all that are left.
    LaneMask together(LaneMask lanes) const;
    LaneMask on_sub_patch_of_first(LaneMask lanes) const;
    /// Each lane's single root on the sub-patch in boxes_.
    void solve(LaneMask lanes);
    void find_single_roots(LaneMask lanes);
    /// Finds each lane's roots in boxes_ on the sub-patch, the same for all, where the existence
    /// test proves nothing.
    void narrow(LaneMask lanes);
    /// Accepts the lanes of roots_; lanes that failed are clipped.
    void accept_roots();
    void clip(std::uint32_t box, std::size_t lane);
    bool counts(std::size_t lane, Crossing& crossing) const;
    void accept(std::size_t lane, Crossing crossing);
    void lower(std::size_t lane, double high);
    void end(std::size_t lane);

    const SearchScene* scene_ = nullptr;
    Goal goal_ = Goal::nearest;
    RayPacket block_;
    LaneMask excluding_ = 0, met_ = 0; ///< rays that exclude a root, and that any() has ended
    LaneMask lowered_ = 0;             ///< rays that have become shorter at the last visit
    ExistenceResult existence_;
    SubPatchRoots roots_;
    CandidateQueue pending_;
    RayPacket::Lanes<std::uint32_t> boxes_{}; ///< what resolve() is about to solve
    std::span<Crossing> nearest_;
    RayPacket::Lanes<std::vector<Crossing>> all_;
    std::vector<Crossing> clipped_;
};

} // namespace keiko
