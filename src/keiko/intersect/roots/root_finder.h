#pragma once

#include "keiko/intersect/roots/planar_net.h"

#include <span>
#include <vector>

namespace keiko {

/// A common zero of the two functions of a PlanarNet.
struct SubPatchRoot {
    Vec2 uv;         ///< in the net's own [0, 1]^2
    Vec2 error;      ///< half the size of the box that holds the exact root
    bool clipped;    ///< found by clipping down to rounding, not by a uniqueness proof
    bool tangential; ///< several roots may lie in that box
    Vec2 alone{0};   ///< half the size of a box around uv that holds no second root, if known
};

/// Roots that a search has found: each root once, pieces of one tangency put together.
class RootList {
public:
    /// For roots of `net`, which must stay; `slack` bounds the error of each coefficient.
    void start(const PlanarNet& net, double slack);
    /// Adds a root, put together with the known ones that are the same root or pieces of the same
    /// tangency. Of finds that are proved the one without clipping is kept.
    void add(SubPatchRoot root);
    /// A root whose box rounding may have stretched to where the ray leaves the surface.
    void add_stretch(const SubPatchRoot& root);
    /// All of them, in no order, until the next start().
    std::span<const SubPatchRoot> finish();

private:
    void split_stretches();
    /// The two ends, across an axis, of a root that reaches from one side to the other.
    std::vector<SubPatchRoot> ends_of(const SubPatchRoot& root) const;
    /// Whether two finds are one root, or pieces of one tangency.
    bool same(const SubPatchRoot& a, const SubPatchRoot& b) const;

    const PlanarNet* net_ = nullptr;
    double slack_ = 0;
    std::vector<SubPatchRoot> roots_;
    std::vector<SubPatchRoot> stretches_; ///< as they were before they were put together
};

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
