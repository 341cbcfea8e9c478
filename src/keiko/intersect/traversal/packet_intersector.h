#pragma once

#include "keiko/intersect/kernels/sub_patch_kernels.h"
#include "keiko/intersect/traversal/candidate_queue.h"
#include "keiko/intersect/traversal/embree_scene.h"
#include "keiko/intersect/traversal/hit_filter.h"

#include <span>
#include <vector>

namespace keiko {

/// All that a search reads.
struct SearchScene {
    const TracedModel& model;
    const EmbreeScene& boxes;
    const SubPatchKernels& kernels;
    bool clipping_only = false;
};

/// The search of up to 16 rays at once, as one packet when they are coherent. A sub-patch that the
/// first look does not rule out is kept for later: a proved root already ends the ray behind it,
/// and only what may still be the nearest in the end is solved. Keeps its buffers between runs;
/// not for two threads at once.
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
    /// Whether the sub-patch is put off, for it may hold the hit; as it was looked at last.
    bool enqueue(std::size_t lane, std::uint32_t box);
    /// Solves what is pending in lanes and ends before their `until`.
    void resolve(LaneMask lanes, const RayPacket::Lanes<double>& until);
    /// Lanes that are best solved together: several on one sub-patch, else all that are left.
    LaneMask together(LaneMask lanes) const;
    LaneMask on_sub_patch_of_first(LaneMask lanes) const;
    /// Each lane's single root on the sub-patch in boxes_.
    void solve(LaneMask lanes);
    void find_single_roots(LaneMask lanes);
    /// Each lane's roots on the sub-patch in boxes_, the same for all, of which the look says
    /// nothing.
    void narrow(LaneMask lanes);
    /// What roots_ has of each lane; lanes that failed are clipped.
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
    ExistenceResult look_;
    SubPatchRoots roots_;
    CandidateQueue pending_;
    RayPacket::Lanes<std::uint32_t> boxes_{}; ///< what settle() is about to solve
    std::span<Crossing> nearest_;
    RayPacket::Lanes<std::vector<Crossing>> all_;
    std::vector<Crossing> clipped_;
};

} // namespace keiko
