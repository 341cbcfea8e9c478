#include "tests/bench/leaf_visits.h"

#include <algorithm>
#include <bit>

namespace keiko::bench {
namespace {

std::size_t count(LaneMask mask) {
    return static_cast<std::size_t>(std::popcount(mask));
}

class Gatherer final : public EmbreeScene::Visitor {
public:
    Gatherer(const TracedModel& model, const SubPatchKernels& kernels, LeafVisits& to)
        : model_(model), kernels_(kernels), to_(to) {}

    void begin(std::size_t block) {
        block_ = block;
        nearest_.fill(nowhere);
    }
    LaneMask visit(std::uint32_t sub_patch, LaneMask lanes) override {
        RayPacket& rays = to_.blocks[block_];
        const PackedSubPatch& hot = model_.hot[sub_patch];
        kernels_.existence_test(rays, lanes, hot, existence_);
        const std::size_t here = to_.visits.size();
        to_.visits.push_back({block_, sub_patch, lanes});
        if (!hot.material) return 0;
        LaneMask lowered = 0;
        for (LaneMask left = existence_.certain; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            if (!(existence_.farthest[lane] < rays.high[lane])) continue;
            rays.high[lane] = existence_.farthest[lane];
            lowered |= LaneMask{1} << lane;
            if (nearest_[lane] != nowhere)
                to_.visits[nearest_[lane]].solved &= ~(LaneMask{1} << lane);
            to_.visits[here].solved |= LaneMask{1} << lane;
            nearest_[lane] = here;
        }
        return lowered;
    }

private:
    static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

    const TracedModel& model_;
    const SubPatchKernels& kernels_;
    LeafVisits& to_;
    std::size_t block_ = 0;
    RayPacket::Lanes<std::size_t> nearest_{};
    ExistenceResult existence_;
};

} // namespace

std::size_t LeafVisits::pairs() const {
    std::size_t sum = 0;
    for (const LeafVisit& v : visits) sum += count(v.rays);
    return sum;
}

std::size_t LeafVisits::solved() const {
    std::size_t sum = 0;
    for (const LeafVisit& v : visits) sum += count(v.solved);
    return sum;
}

LeafVisits leaf_visits(const TracedModel& model, const EmbreeScene& boxes,
                       const SubPatchKernels& kernels, std::span<const Ray> rays, Mode mode) {
    LeafVisits result;
    const std::size_t step = mode == Mode::single ? 1 : RayPacket::capacity;
    result.blocks.resize((rays.size() + step - 1) / step);
    Gatherer gatherer(model, kernels, result);
    for (std::size_t b = 0; b < result.blocks.size(); ++b) {
        RayPacket& block = result.blocks[b];
        block.count = std::min(step, rays.size() - b * step);
        for (std::size_t lane = 0; lane < block.count; ++lane)
            block.rays[lane] = &rays[b * step + lane];
        kernels.enter({boxes.center(), boxes.radius()}, block);
        gatherer.begin(b);
        if (block.active != 0) boxes.trace(block, gatherer);
    }
    return result;
}

} // namespace keiko::bench
