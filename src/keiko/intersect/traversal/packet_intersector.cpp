#include "keiko/intersect/traversal/packet_intersector.h"

#include "keiko/intersect/hit/surface_interaction.h"
#include "keiko/intersect/kernels/prefetch.h"
#include "keiko/intersect/traversal/bezier_clipping.h"
#include "keiko/intersect/traversal/hit_filter.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace keiko {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr RayPacket::Lanes<double> always = [] {
    RayPacket::Lanes<double> lanes{};
    lanes.fill(infinity);
    return lanes;
}();

constexpr LaneMask bit(std::size_t lane) {
    return LaneMask{1} << lane;
}

std::size_t first_lane(LaneMask mask) {
    return static_cast<std::size_t>(std::countr_zero(mask));
}

/// True if a mask has at least `count` lanes. std::popcount calls a library where a processor may
/// lack the instruction.
constexpr bool has_lanes(LaneMask mask, int count) {
    for (; count > 1; --count) mask &= mask - 1;
    return mask != 0;
}

/// Calls `work(lane)` for each lane of a mask.
template <class Work>
void for_lanes(LaneMask mask, const Work& work) {
    for (; mask != 0; mask &= mask - 1) work(first_lane(mask));
}

} // namespace

void PacketIntersector::nearest(const SearchScene& scene, std::span<const Ray> rays,
                                std::span<Crossing> found) {
    nearest_ = found;
    run(scene, Goal::nearest, rays);
}

LaneMask PacketIntersector::any(const SearchScene& scene, std::span<const Ray> rays) {
    met_ = 0;
    run(scene, Goal::any, rays);
    return met_;
}

std::span<const std::vector<Crossing>> PacketIntersector::all(const SearchScene& scene,
                                                              std::span<const Ray> rays) {
    for (std::size_t lane = 0; lane < rays.size(); ++lane) all_[lane].clear();
    run(scene, Goal::all, rays);
    return std::span(all_).first(rays.size());
}

void PacketIntersector::run(const SearchScene& scene, Goal goal, std::span<const Ray> rays) {
    scene_ = &scene;
    goal_ = goal;
    block_.count = rays.size();
    excluding_ = 0;
    for (std::size_t lane = 0; lane < rays.size(); ++lane) {
        block_.rays[lane] = &rays[lane];
        if (rays[lane].excluded) excluding_ |= bit(lane);
    }
    scene.kernels.enter({scene.boxes.center(), scene.boxes.radius()}, block_);
    if (block_.active == 0) return;
    pending_.clear();
    scene.boxes.trace(block_, *this);
    resolve(block_.active, always);
}

LaneMask PacketIntersector::visit(std::uint32_t box, LaneMask lanes) {
    if (scene_->hidden && (*scene_->hidden)[box]) return 0;
    lowered_ = 0;
    const PackedSubPatch& hot = scene_->model.hot[box];
    if (!has_lanes(lanes, 2))
        scene_->kernels.existence_test_single(block_, first_lane(lanes), hot, existence_);
    else
        scene_->kernels.existence_test(block_, lanes, hot, existence_);
    const LaneMask left = existence_.certain | existence_.single | existence_.undecided;
    if (left == 0) return 0;
    LaneMask in_front = 0;
    for_lanes(left & pending_.doubtful(), [&](std::size_t lane) {
        if (pending_.doubtful_until(lane) < existence_.nearest[lane]) in_front |= bit(lane);
    });
    if (in_front != 0) resolve(in_front, existence_.nearest);
    bool kept = false;
    for_lanes(left, [&](std::size_t lane) { kept = enqueue(lane, box) || kept; });
    if (kept) fetch_polynomial(hot);
    return lowered_;
}

/// Has the coefficients in the cache by the time the search is over.
void PacketIntersector::fetch_polynomial(const PackedSubPatch& hot) const {
    if (!hot.regular) return;
    const Component4* first = &scene_->model.sub_patches.polynomials[hot.polynomial];
    prefetch(std::span(first, hot.coefficients()));
}

PacketIntersector::Reach PacketIntersector::reach(std::size_t lane, std::uint32_t box) const {
    const PlacedSubPatch& placed = scene_->model.placed[box];
    const PartPlacement& at = scene_->model.placements[placed.instance];
    const SubPatch& sub_patch = scene_->model.sub_patches.sub_patches[placed.sub_patch];
    const Vec3 center = at.identity ? sub_patch.center : at.to_world.point(sub_patch.center);
    const TracedRay ray = block_.ray(lane);
    const double foot = (center - ray.start).dot(ray.direction);
    const double reach = 1.000001 * at.magnification * sub_patch.radius + block_.blur[lane];
    return {foot - reach, foot + reach};
}

bool PacketIntersector::enqueue(std::size_t lane, std::uint32_t box) {
    double nearest = existence_.nearest[lane], farthest = existence_.farthest[lane];
    if (!std::isfinite(nearest) || !std::isfinite(farthest)) {
        const Reach bounded = reach(lane, box);
        nearest = bounded.nearest, farthest = bounded.farthest;
    }
    if (!(nearest <= block_.high[lane])) return false;
    const bool single = ((existence_.certain | existence_.single) & bit(lane)) != 0;
    bool certain = (existence_.material & bit(lane)) != 0;
    if ((excluding_ & bit(lane)) != 0) {
        const TracedRay ray = block_.ray(lane);
        const HitFilter check(scene_->model, ray, scene_->model.placed[box]);
        if (single && check.meets_excluded_only(nearest, farthest)) return false;
        certain = certain && check.clear_of_excluded(nearest, farthest);
    }
    const double room = 2 * block_.slack[lane];
    certain = certain && nearest > block_.low[lane] + room && farthest < block_.high[lane] - room;
    if (certain && goal_ == Goal::any) {
        end(lane);
        return false;
    }
    if (certain && goal_ == Goal::nearest) lower(lane, farthest);
    pending_.add(lane, {box, single, !certain && goal_ != Goal::all, nearest, farthest});
    return true;
}

void PacketIntersector::resolve(LaneMask lanes, const RayPacket::Lanes<double>& until) {
    while ((lanes &= pending_.lanes()) != 0) {
        LaneMask single = 0, other = 0;
        for_lanes(lanes, [&](std::size_t lane) {
            const auto sub_patch = pending_.take(lane, block_.high[lane], until[lane]);
            if (!sub_patch) return;
            boxes_[lane] = sub_patch->box;
            (sub_patch->single ? single : other) |= bit(lane);
        });
        lanes = single | other;
        while (other != 0) {
            const LaneMask next = on_sub_patch_of_first(other);
            narrow(next);
            other &= ~next;
        }
        while (single != 0) {
            const LaneMask next = together(single);
            solve(next);
            single &= ~next;
        }
    }
}

LaneMask PacketIntersector::on_sub_patch_of_first(LaneMask lanes) const {
    const std::uint32_t box = boxes_[first_lane(lanes)];
    LaneMask same = 0;
    for_lanes(lanes, [&](std::size_t lane) {
        if (boxes_[lane] == box) same |= bit(lane);
    });
    return same;
}

LaneMask PacketIntersector::together(LaneMask lanes) const {
    // Lanes from which sharing a sub-patch's coefficients gains more than having all others beside
    // them; and lanes that fill a vector.
    constexpr int enough_on_a_sub_patch = 3, enough_apart = 4;
    LaneMask first = 0, alone = 0;
    for (LaneMask left = lanes; left != 0;) {
        const LaneMask same = on_sub_patch_of_first(left);
        if (has_lanes(same, enough_on_a_sub_patch)) return same;
        if (first == 0) first = same;
        alone |= same;
        left &= ~same;
    }
    return has_lanes(alone, enough_apart) ? alone : first;
}

void PacketIntersector::find_single_roots(LaneMask lanes) {
    const TracedModel& model = scene_->model;
    const Component4* polynomials = model.sub_patches.polynomials.data();
    RayPacket::Lanes<const PackedSubPatch*> sub_patches;
    bool one_sub_patch = true;
    const PackedSubPatch& first = model.hot[boxes_[first_lane(lanes)]];
    // Several hits are announced when their turn comes; that of a single ray comes at once.
    if (block_.count == 1) SurfaceInteraction::announce(model, boxes_[first_lane(lanes)]);
    for_lanes(lanes, [&](std::size_t lane) {
        sub_patches[lane] = &model.hot[boxes_[lane]];
        one_sub_patch = one_sub_patch && sub_patches[lane] == &first;
    });
    const SubPatchKernels& kernels = scene_->kernels;
    if (!one_sub_patch)
        kernels.solve_apart(block_, lanes, sub_patches, polynomials, roots_);
    else if (!has_lanes(lanes, 2))
        kernels.solve_single(block_, first_lane(lanes), first, polynomials + first.polynomial,
                             roots_);
    else
        kernels.solve(block_, lanes, first, polynomials + first.polynomial, roots_);
}

void PacketIntersector::solve(LaneMask lanes) {
    find_single_roots(lanes);
    accept_roots();
}

void PacketIntersector::narrow(LaneMask lanes) {
    const std::uint32_t box = boxes_[first_lane(lanes)];
    const TracedModel& model = scene_->model;
    const PackedSubPatch& hot = model.hot[box];
    if (!hot.regular) return for_lanes(lanes, [&](std::size_t lane) { clip(box, lane); });
    scene_->kernels.narrow(block_, lanes, hot, &model.sub_patches.polynomials[hot.polynomial],
                           roots_);
    accept_roots();
}

void PacketIntersector::accept_roots() {
    const LaneMask failed = roots_.failed;
    for_lanes(roots_.found, [&](std::size_t lane) {
        accept(lane, {.t = block_.t_at(lane, roots_.s[lane]),
                      .sub_patch = boxes_[lane],
                      .uv = Vec2(roots_.x[lane] + 1, roots_.y[lane] + 1) * 0.5,
                      .error = Vec2(roots_.error[lane] * 0.5)});
    });
    for_lanes(failed, [&](std::size_t lane) { clip(boxes_[lane], lane); });
}

void PacketIntersector::clip(std::uint32_t box, std::size_t lane) {
    clipped_.clear();
    const bool proved =
        scene_->model.hot[box].regular &&
        interval_newton(scene_->model, scene_->kernels, box, block_, lane, clipped_);
    if (!proved)
        bezier_clipping(scene_->model, box, block_.ray(lane), scene_->clipping_only, clipped_);
    for (const Crossing& c : clipped_) accept(lane, c);
}

/// Whether a root is a hit; marks seam hits.
bool PacketIntersector::counts(std::size_t lane, Crossing& crossing) const {
    const PackedSubPatch& hot = scene_->model.hot[crossing.sub_patch];
    const Vec2 at = crossing.uv * 2 - Vec2(1);
    bool plain = hot.material && hot.on_patch(at.x, at.y);
    if (!hot.material) {
        const TrimCells::Set cell = TrimCells::at(at);
        if ((cell & hot.cells.empty) != 0) return false;
        plain = (cell & hot.cells.material) != 0;
    }
    if (plain && (excluding_ & bit(lane)) == 0) return true;
    const TracedRay ray = block_.ray(lane);
    return HitFilter(scene_->model, ray, scene_->model.placed[crossing.sub_patch])
        .accepts(crossing);
}

void PacketIntersector::accept(std::size_t lane, Crossing crossing) {
    const Ray& ray = *block_.rays[lane];
    if (!(crossing.t >= ray.t_min && crossing.t <= ray.t_max)) return;
    if (goal_ == Goal::nearest && !crossing.before(nearest_[lane])) return;
    if (!counts(lane, crossing)) return;
    if (goal_ == Goal::any) return end(lane);
    if (goal_ == Goal::all) return all_[lane].push_back(crossing);
    nearest_[lane] = crossing;
    lower(lane, (crossing.t - block_.t_start[lane]) * block_.speed[lane] + block_.slack[lane]);
}

void PacketIntersector::lower(std::size_t lane, double high) {
    if (!(high < block_.high[lane])) return;
    block_.high[lane] = high;
    lowered_ |= bit(lane);
}

void PacketIntersector::end(std::size_t lane) {
    met_ |= bit(lane);
    lower(lane, -infinity);
    pending_.clear(lane);
}

} // namespace keiko
