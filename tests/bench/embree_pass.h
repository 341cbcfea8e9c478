#pragma once

#include "tests/bench/embree_body.h"
#include "tests/bench/embree_rays.h"

#include <functional>

namespace keiko::bench {

/// Rays through an Embree scene by rtcIntersect1 or rtcIntersect16.
class EmbreePass final : public Pass {
public:
    /// Makes an answer of a hit; none: the pass has no answers.
    using Reader = std::function<Answer(const EmbreeHit&)>;

    EmbreePass(const EmbreeBody& body, const RaySet& rays, EmbreeRays prepared, Reader reader = {});
    void reset() override { prepared_.reset(); }
    void run() override;
    Answers answers() const override;

private:
    const EmbreeBody& body_;
    bool coherent_;
    std::size_t count_;
    EmbreeRays prepared_;
    Reader reader_;
};

} // namespace keiko::bench
