#pragma once

#include "keiko/trace/crossing.h"
#include "keiko/trace/leaf_kernels.h"
#include "keiko/trace/traced_model.h"

namespace keiko {

/// Makes hits of crossings: everything about them, in world coordinates. Several are evaluated
/// side by side.
class HitEvaluation {
public:
    HitEvaluation(const TracedModel& model, const LeafKernels& kernels, bool second_derivatives)
        : model_(model), kernels_(kernels), second_derivatives_(second_derivatives) {}

    /// Fetches what add() will read of a crossing that soon follows.
    void announce(const Crossing& crossing) const;
    /// `hit` is written at the latest by finish(); both must stay where they are until then.
    void add(const Crossing& crossing, Hit& hit);
    void finish();

private:
    void ask(std::size_t lane);
    void write(std::size_t lane);
    /// What depends on the derivatives, but for the bound.
    void write_surface(std::size_t lane, const PartPlacement& placement, Hit& hit) const;
    /// mm, of the world.
    double position_bound(std::size_t lane, const Leaf& leaf, const PartPlacement& placement,
                          const Vec3& position) const;

    const TracedModel& model_;
    const LeafKernels& kernels_;
    bool second_derivatives_;
    HitBlock block_;
    HitBlock::Lanes<const Crossing*> crossings_{};
    HitBlock::Lanes<Hit*> hits_{};
};

/// One of them.
Hit evaluated(const TracedModel& model, const LeafKernels& kernels, const Crossing& crossing,
              bool second_derivatives);

} // namespace keiko
