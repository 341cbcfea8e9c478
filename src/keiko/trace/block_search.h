#pragma once

#include "keiko/trace/embree_scene.h"
#include "keiko/trace/leaf_kernels.h"
#include "keiko/trace/root_check.h"

#include <span>
#include <vector>

namespace keiko {

/// What a search looks for along each of its rays.
enum class Goal { nearest, any, all };

/// All that a search reads.
struct SearchScene {
    const TracedModel& model;
    const EmbreeScene& boxes;
    const LeafKernels& kernels;
    bool clipping_only = false;
};

/// The search of up to 16 rays at once, as one packet when they are coherent. A leaf that the
/// first look does not rule out is kept for later: a proved root already ends the ray behind it,
/// and only what may still be the nearest in the end is solved. Keeps its buffers between runs;
/// not for two threads at once.
class BlockSearch final : EmbreeScene::Visitor {
public:
    /// Afterwards found(i) holds the answers for rays[i]: none or one for `nearest` and `any` (for
    /// `any` some hit, with its leaf and a distance that it is not beyond), every one in no order
    /// for `all`.
    void run(const SearchScene& scene, Goal goal, std::span<const Ray> rays);
    std::span<const Crossing> found(std::size_t lane) const { return found_[lane]; }

private:
    /// A leaf that may hold roots between two distances along the ray.
    struct Pending {
        std::uint32_t box = 0;
        double nearest = 0, farthest = 0;
        bool single = false;  ///< at most one
        bool certain = false; ///< and at least one, that counts
    };

    void visit(std::uint32_t box, LaneMask lanes) override;
    Pending candidate(std::size_t lane, std::uint32_t box) const;
    void consider(std::size_t lane, Pending candidate);
    /// Solves what is pending in lanes and ends before their `until`.
    void settle(LaneMask lanes, const RayBlock::Lanes<double>& until);
    /// Takes the nearest pending leaf that ends before `until`, nothing when there is none.
    const Pending* first_pending(std::size_t lane, double until);
    void remove_pending(std::size_t lane, std::uint32_t box);
    /// Those of the lanes that can be solved together with the first.
    LaneMask alike(LaneMask lanes, const RayBlock::Lanes<std::uint32_t>& boxes) const;
    /// Each lane's single root on its own leaf.
    void solve(LaneMask lanes, const RayBlock::Lanes<std::uint32_t>& boxes);
    void find_single_roots(LaneMask lanes, const RayBlock::Lanes<std::uint32_t>& boxes);
    void clip(std::uint32_t box, std::size_t lane);
    void accept(std::size_t lane, Crossing crossing);
    void end(std::size_t lane);

    const SearchScene* scene_ = nullptr;
    Goal goal_ = Goal::nearest;
    RayBlock block_;
    LeafLook look_;
    LeafRoots roots_;
    RayBlock::Lanes<std::vector<Pending>> pending_;
    /// Where the first pending leaf ends that may turn out to hold nothing.
    RayBlock::Lanes<double> doubtful_until_;
    RayBlock::Lanes<std::vector<Crossing>> found_;
    std::vector<Crossing> clipped_;
};

} // namespace keiko
