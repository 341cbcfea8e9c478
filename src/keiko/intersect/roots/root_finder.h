#pragma once

#include "keiko/intersect/roots/root_list.h"

#include <span>
#include <vector>

namespace keiko {

/// Finds every common zero of f and g in [0, 1]^2: Bezier clipping with preconditioned fat lines,
/// cut short by Newton's method wherever a box is proved to hold at most one. Sub-boxes are always
/// cut from the net that was given, so that rounding does not pile up with depth.
/// Keeps its buffers between calls; not for two threads at once.
class RootFinder {
public:
    /// `clipping_only`: never proves, only clips, as [Nishita1990].
    explicit RootFinder(bool clipping_only = false) : clipping_only_(clipping_only) {}

    /// `slack` bounds the error of each coefficient. Valid until the next call; in no order.
    std::span<const SubPatchRoot> find(const PlanarNet& net, double slack);

private:
    /// `net` is the whole net over `box`.
    void examine(const PlanarNet& net, const Box2& box);
    /// Halves the box across the axis along which the functions vary most.
    void split(const Box2& box, const Vec2& variation);
    /// For want of time: the same unless the functions have no zero in the box.
    void accept_unless_clear(const Box2& box);
    /// The box is as narrow as rounding allows, and a zero cannot be ruled out in it.
    void accept_box(const Box2& box);
    /// The ray lies in the surface on the whole box: the places where it enters and leaves.
    void accept_line(const PlanarNet& net, const Box2& box, const Vec2& plane);

    bool clipping_only_;
    const PlanarNet* whole_ = nullptr; ///< of the call that runs
    double slack_ = 0;
    std::vector<Box2> open_;
    RootList roots_;
};

} // namespace keiko
