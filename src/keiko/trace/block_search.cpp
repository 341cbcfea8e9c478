#include "keiko/trace/block_search.h"

#include "keiko/trace/clipped_roots.h"
#include "keiko/trace/narrowed_roots.h"
#include "keiko/trace/ray_blur.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace keiko {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr LaneMask bit(std::size_t lane) {
    return LaneMask{1} << lane;
}

std::size_t first_lane(LaneMask mask) {
    return static_cast<std::size_t>(std::countr_zero(mask));
}

/// Calls `work(lane)` for each lane of a mask.
template <class Work>
void for_lanes(LaneMask mask, const Work& work) {
    for (; mask != 0; mask &= mask - 1) work(first_lane(mask));
}

} // namespace

void BlockSearch::run(const SearchScene& scene, Goal goal, std::span<const Ray> rays) {
    scene_ = &scene;
    goal_ = goal;
    block_.count = rays.size();
    for (std::size_t lane = 0; lane < rays.size(); ++lane) {
        block_.rays[lane] = &rays[lane];
        found_[lane].clear();
        pending_[lane].clear();
        doubtful_until_[lane] = infinity;
    }
    scene.kernels.enter({scene.boxes.center(), scene.boxes.radius()}, block_);
    if (block_.active == 0) return;
    scene.boxes.trace(block_, *this);
    RayBlock::Lanes<double> always;
    always.fill(infinity);
    settle(block_.active, always);
}

void BlockSearch::visit(std::uint32_t box, LaneMask lanes) {
    const HotLeaf& hot = scene_->model.hot[box];
    if (std::has_single_bit(lanes))
        scene_->kernels.look_single(block_, first_lane(lanes), hot, look_);
    else
        scene_->kernels.look(block_, lanes, hot, look_);
    const LaneMask left = look_.certain | look_.single | look_.undecided;
    if (left == 0) return;
    LaneMask in_front = 0;
    for_lanes(left, [&](std::size_t lane) {
        if (doubtful_until_[lane] < look_.nearest[lane]) in_front |= bit(lane);
    });
    if (in_front != 0) settle(in_front, look_.nearest);
    for_lanes(left, [&](std::size_t lane) { consider(lane, candidate(lane, box)); });
}

BlockSearch::Pending BlockSearch::candidate(std::size_t lane, std::uint32_t box) const {
    Pending c;
    c.box = box;
    c.certain = (look_.certain & bit(lane)) != 0 && scene_->model.hot[box].material;
    c.single = ((look_.certain | look_.single) & bit(lane)) != 0;
    c.nearest = look_.nearest[lane];
    c.farthest = look_.farthest[lane];
    if (!std::isfinite(c.nearest) || !std::isfinite(c.farthest)) {
        const PlacedLeaf& placed = scene_->model.placed[box];
        const PartPlacement& at = scene_->model.placements[placed.instance];
        const Leaf& leaf = scene_->model.leaves.leaves[placed.leaf];
        const Vec3 center = at.identity ? leaf.center : at.to_world.point(leaf.center);
        const TracedRay ray = block_.ray(lane);
        const double foot = (center - ray.start).dot(ray.direction);
        const double reach = 1.000001 * at.magnification * leaf.radius + block_.blur[lane];
        c.nearest = foot - reach;
        c.farthest = foot + reach;
    }
    return c;
}

void BlockSearch::consider(std::size_t lane, Pending c) {
    if (!(c.nearest <= block_.high[lane])) return;
    const bool excluding = block_.rays[lane]->excluded.has_value();
    if (excluding) {
        const TracedRay ray = block_.ray(lane);
        const RootCheck check(scene_->model, ray, scene_->model.placed[c.box]);
        if (c.single && check.meets_excluded_only(c.nearest, c.farthest)) return;
        c.certain = c.certain && check.clear_of_excluded(c.nearest, c.farthest);
    }
    const double room = 2 * block_.slack[lane];
    c.certain =
        c.certain && c.nearest > block_.low[lane] + room && c.farthest < block_.high[lane] - room;
    if (c.certain && goal_ == Goal::any) {
        found_[lane].push_back({.t = block_.t_at(lane, c.farthest), .leaf = c.box});
        return end(lane);
    }
    if (c.certain && goal_ == Goal::nearest)
        block_.high[lane] = std::min(block_.high[lane], c.farthest);
    if (!c.certain && goal_ != Goal::all)
        doubtful_until_[lane] = std::min(doubtful_until_[lane], c.farthest);
    pending_[lane].push_back(c);
}

const BlockSearch::Pending* BlockSearch::first_pending(std::size_t lane, double until) {
    const Pending* first = nullptr;
    for (const Pending& p : pending_[lane])
        if (p.nearest <= block_.high[lane] && p.farthest <= until &&
            (!first || p.nearest < first->nearest))
            first = &p;
    return first;
}

void BlockSearch::remove_pending(std::size_t lane, std::uint32_t box) {
    std::vector<Pending>& all = pending_[lane];
    std::erase_if(all, [&](const Pending& p) { return p.box == box; });
    doubtful_until_[lane] = infinity;
    if (goal_ == Goal::all) return;
    for (const Pending& p : all)
        if (!p.certain) doubtful_until_[lane] = std::min(doubtful_until_[lane], p.farthest);
}

void BlockSearch::settle(LaneMask lanes, const RayBlock::Lanes<double>& until) {
    while (true) {
        LaneMask single = 0, other = 0;
        RayBlock::Lanes<std::uint32_t> boxes;
        for_lanes(lanes, [&](std::size_t lane) {
            const Pending* p = first_pending(lane, until[lane]);
            if (!p) {
                lanes &= ~bit(lane);
                return;
            }
            boxes[lane] = p->box;
            (p->single ? single : other) |= bit(lane);
        });
        if (lanes == 0) return;
        for_lanes(lanes, [&](std::size_t lane) { remove_pending(lane, boxes[lane]); });
        for_lanes(other, [&](std::size_t lane) { clip(boxes[lane], lane); });
        while (single != 0) {
            const LaneMask together = alike(single, boxes);
            solve(together, boxes);
            single &= ~together;
        }
    }
}

LaneMask BlockSearch::alike(LaneMask lanes, const RayBlock::Lanes<std::uint32_t>& boxes) const {
    const std::vector<HotLeaf>& leaves = scene_->model.hot;
    const HotLeaf& first = leaves[boxes[first_lane(lanes)]];
    const bool gathers = first.coefficients() <= largest_gathered;
    LaneMask same = 0;
    for_lanes(lanes, [&](std::size_t lane) {
        const HotLeaf& leaf = leaves[boxes[lane]];
        const bool fits = leaf.degree_u == first.degree_u && leaf.degree_v == first.degree_v &&
                          leaf.rational == first.rational;
        if (&leaf == &first || (gathers && fits)) same |= bit(lane);
    });
    return same;
}

void BlockSearch::find_single_roots(LaneMask lanes, const RayBlock::Lanes<std::uint32_t>& boxes) {
    const TracedModel& model = scene_->model;
    const Component4* polynomials = model.leaves.polynomials.data();
    RayBlock::Lanes<const HotLeaf*> leaves;
    bool one_leaf = true;
    const HotLeaf& first = model.hot[boxes[first_lane(lanes)]];
    for_lanes(lanes, [&](std::size_t lane) {
        leaves[lane] = &model.hot[boxes[lane]];
        one_leaf = one_leaf && leaves[lane] == &first;
    });
    const LeafKernels& kernels = scene_->kernels;
    if (!one_leaf)
        kernels.solve_gathered(block_, lanes, leaves, polynomials, roots_);
    else if (std::has_single_bit(lanes))
        kernels.solve_single(block_, first_lane(lanes), first, polynomials + first.polynomial,
                             roots_);
    else
        kernels.solve(block_, lanes, first, polynomials + first.polynomial, roots_);
}

void BlockSearch::solve(LaneMask lanes, const RayBlock::Lanes<std::uint32_t>& boxes) {
    find_single_roots(lanes, boxes);
    const LaneMask failed = roots_.failed;
    for_lanes(roots_.found, [&](std::size_t lane) {
        accept(lane, {.t = block_.t_at(lane, roots_.s[lane]),
                      .leaf = boxes[lane],
                      .uv = Vec2(roots_.x[lane] + 1, roots_.y[lane] + 1) * 0.5,
                      .error = Vec2(roots_.error[lane] * 0.5)});
    });
    for_lanes(failed, [&](std::size_t lane) { clip(boxes[lane], lane); });
}

void BlockSearch::clip(std::uint32_t box, std::size_t lane) {
    clipped_.clear();
    const bool proved =
        scene_->model.hot[box].regular &&
        narrowed_roots(scene_->model, scene_->kernels, box, block_.ray(lane), clipped_);
    if (!proved)
        clipped_roots(scene_->model, box, block_.ray(lane), scene_->clipping_only, clipped_);
    for (const Crossing& c : clipped_) accept(lane, c);
}

void BlockSearch::accept(std::size_t lane, Crossing crossing) {
    const Ray& ray = *block_.rays[lane];
    if (!(crossing.t >= ray.t_min && crossing.t <= ray.t_max)) return;
    std::vector<Crossing>& found = found_[lane];
    if (goal_ != Goal::all && !found.empty() && !crossing.before(found.front())) return;
    const HotLeaf& hot = scene_->model.hot[crossing.leaf];
    const bool plain = hot.material && hot.on_patch(2 * crossing.uv.x - 1, 2 * crossing.uv.y - 1);
    if (ray.excluded || !plain) {
        const TracedRay traced = block_.ray(lane);
        const RootCheck check(scene_->model, traced, scene_->model.placed[crossing.leaf]);
        if (!check.passes(crossing)) return;
    }
    if (goal_ != Goal::all) found.clear();
    found.push_back(crossing);
    if (goal_ == Goal::any) return end(lane);
    if (goal_ == Goal::nearest)
        block_.high[lane] =
            std::min(block_.high[lane],
                     (crossing.t - block_.t_start[lane]) * block_.speed[lane] + block_.slack[lane]);
}

void BlockSearch::end(std::size_t lane) {
    block_.high[lane] = -infinity;
    pending_[lane].clear();
    doubtful_until_[lane] = infinity;
}

} // namespace keiko
