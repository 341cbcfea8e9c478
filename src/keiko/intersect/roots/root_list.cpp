#include "keiko/intersect/roots/root_finder.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Whether all of b lies where a has no second root beside it.
bool has_no_other(const SubPatchRoot& a, const SubPatchRoot& b) {
    const Vec2 apart = b.uv - a.uv;
    return std::abs(apart.x) + b.error.x <= a.alone.x && std::abs(apart.y) + b.error.y <= a.alone.y;
}

SubPatchRoot united(const SubPatchRoot& a, const SubPatchRoot& b) {
    Box2 box{a.uv - a.error, a.uv + a.error};
    box.extend(Box2{b.uv - b.error, b.uv + b.error});
    const Vec2 middle = box.center();
    const SubPatchRoot& wider = a.alone.length2() > b.alone.length2() ? a : b;
    const Vec2 moved(std::abs(middle.x - wider.uv.x), std::abs(middle.y - wider.uv.y));
    const Vec2 alone(std::max(0.0, wider.alone.x - moved.x),
                     std::max(0.0, wider.alone.y - moved.y));
    return {middle, box.extent() * 0.5, a.clipped || b.clipped, a.tangential || b.tangential,
            alone};
}

} // namespace

void RootList::start(const PlanarNet& net, double slack) {
    net_ = &net;
    slack_ = slack;
    roots_.clear();
    stretches_.clear();
}

void RootList::add(SubPatchRoot root) {
    for (std::size_t i = 0; i < roots_.size();) {
        const SubPatchRoot& known = roots_[i];
        if (!same(known, root)) {
            ++i;
            continue;
        }
        // A root found by clipping alone lies in any of the boxes that rounding left over.
        const bool proved =
            !known.tangential && !root.tangential && !(known.clipped && root.clipped);
        if (!proved)
            root = united(known, root);
        else if (!known.clipped)
            root = known;
        // What has grown may touch others that were apart before.
        roots_.erase(roots_.begin() + static_cast<std::ptrdiff_t>(i));
        i = 0;
    }
    roots_.push_back(root);
}

void RootList::add_stretch(const SubPatchRoot& root) {
    stretches_.push_back(root);
    add(root);
}

std::span<const SubPatchRoot> RootList::finish() {
    split_stretches();
    // A tangency reaches on where rounding has just let go of it.
    for (SubPatchRoot& root : roots_)
        if (root.tangential) root.error *= 4;
    return roots_;
}

/// Splits each stretch that crosses the whole domain into its entry and its exit. Any other stretch
/// is one tangency, however long rounding makes it.
void RootList::split_stretches() {
    if (stretches_.empty()) return;
    std::vector<SubPatchRoot> ends;
    std::erase_if(roots_, [&](const SubPatchRoot& root) {
        const std::vector<SubPatchRoot> own = ends_of(root);
        ends.insert(ends.end(), own.begin(), own.end());
        return !own.empty();
    });
    for (const SubPatchRoot& end : ends) add(end);
}

std::vector<SubPatchRoot> RootList::ends_of(const SubPatchRoot& root) const {
    constexpr double rounding = 1e-12;
    std::vector<SubPatchRoot> ends;
    for (unsigned axis = 0; axis < 2; ++axis) {
        if (!(root.uv[axis] - root.error[axis] <= rounding &&
              root.uv[axis] + root.error[axis] >= 1 - rounding))
            continue;
        for (const SubPatchRoot& s : stretches_)
            for (const double at : {0.0, 1.0}) {
                if (!(std::abs(s.uv[axis] - at) <= s.error[axis] + rounding)) continue;
                ends.push_back(s);
                ends.back().uv[axis] = at;
                ends.back().error[axis] = 4e-16;
                ends.back().tangential = true;
            }
        break;
    }
    return ends;
}

bool RootList::same(const SubPatchRoot& a, const SubPatchRoot& b) const {
    const Vec2 apart = a.uv - b.uv, reach = a.error + b.error + Vec2(1e-13);
    if (std::abs(apart.x) <= reach.x && std::abs(apart.y) <= reach.y) return true;
    if (has_no_other(a, b) || has_no_other(b, a)) return true;
    if (!a.tangential && !b.tangential) return false;
    // Rounding scatters one tangency along the ray. The pieces are one as long as between them the
    // surface stays within rounding of the ray, measured across the surface: a box's middle may
    // well lie to the side. Both ends of a line in the surface remain two.
    constexpr double widest_tangency = 1e-3;
    if (!(apart.length() < widest_tangency)) return false;
    const PlanarPoint between = evaluate(*net_, (a.uv + b.uv) / 2);
    const Vec2 along = between.du.length2() > between.dv.length2() ? between.du : between.dv;
    return std::abs(along.x * between.value.y - along.y * between.value.x) <=
           8 * slack_ * along.length();
}

} // namespace keiko
