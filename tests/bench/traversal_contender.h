#pragma once

#include "tests/bench/contender.h"
#include "tests/bench/embree_body.h"

#include <span>
#include <vector>

namespace keiko::bench {

/// Embree over boxes with a callback that does nothing: what traversal alone costs. Rays run
/// through the whole body, or end at the hit, as if each hit had been known beforehand.
class TraversalContender : public Contender {
public:
    /// `boxes` in world coordinates, as the Tracer hands them to Embree.
    TraversalContender(std::span<const Box3> boxes, bool end_at_hit);
    std::unique_ptr<Pass> pass(const RaySet& rays, Mode mode) const override;

private:
    Ball ball_;
    std::vector<Box3> boxes_; ///< about the ball's centre
    bool end_at_hit_;
    EmbreeBody body_;
};

} // namespace keiko::bench
