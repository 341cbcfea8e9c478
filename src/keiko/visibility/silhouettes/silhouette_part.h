#pragma once

#include "keiko/math/interval_set.h"
#include "keiko/visibility/boundaries/plane_cuts.h"
#include "keiko/visibility/nets/affine_bounds.h"
#include "keiko/visibility/nets/degree_reduced_net.h"
#include "keiko/visibility/nets/scalar_net.h"
#include "keiko/visibility/silhouettes/view_volume.h"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace keiko {

/// The wedge between a viewpoint and a part of a segment: only what reaches into it hides anything
/// of that part. Of parallel light it is a strip.
class ShadowWedge {
public:
    /// Wedge to the part [begin, end] of the segment of a plane.
    ShadowWedge(const SegmentPlane& plane, const ParameterInterval& part) {
        const Viewpoint& viewpoint = plane.viewpoint();
        const std::array ends{plane.at(part.begin), plane.at(part.end)};
        for (unsigned k = 0; k < 2; ++k) {
            Vec3 inward = plane.normal().cross(viewpoint.way_to(ends[k])).normalized();
            if (inward.dot(ends[1 - k] - ends[k]) < 0) inward = -inward;
            sides_[k] = {inward, viewpoint.infinite() ? ends[k] : viewpoint.place()};
        }
    }

    /// Weights that turn homogeneous coordinates relative to `center`, of points at most `reach`
    /// from it, into their distances inside each side, mm.
    std::array<Vec4, 2> weights(const Vec3& center, double reach) const {
        std::array<Vec4, 2> of_sides{Vec4(0), Vec4(0)};
        for (unsigned k = 0; k < 2; ++k) {
            const Vec3 &n = sides_[k].inward, way = center - sides_[k].place;
            const double margin = 1e-12 * (reach + way.length()); // far beyond rounding
            of_sides[k] = Vec4(n.x, n.y, n.z, n.dot(way) + margin);
        }
        return of_sides;
    }

private:
    struct Side {
        Vec3 inward{0}; ///< unit
        Vec3 place{0};  ///< on it
    };
    std::array<Side, 2> sides_;
};

/// Search of parts in a frame: silhouettes in a plane through the viewpoint that hide some of a
/// segment. Weights of homogeneous coordinates.
struct Section {
    Vec4 plane;                ///< the distance to it
    std::array<Vec4, 2> sides; ///< how far inside of the wedge's

    /// `reach`: of the parts' points from the frame's centre, mm.
    Section(const NetFrame& frame, double reach, const SegmentPlane& of, const ShadowWedge& hidden)
        : plane(frame.local(of.weights(frame.center))), sides(hidden.weights(frame.center, reach)) {
        for (Vec4& side : sides) side = frame.local(side);
    }

    /// Whether all is proved to lie outside of the wedge.
    bool misses(const AffineBounds& points) const {
        return points.weighed(sides[0]).most() < 0 || points.weighed(sides[1]).most() < 0;
    }
};

/// A part of a patch that a viewpoint may see edge-on. It halves where a segment needs it smaller;
/// the halves are kept, so that all segments of the viewpoint share what does not depend on them.
class SilhouettePart {
public:
    /// `points`: over `uv` of the patch, in a frame; `edge_on`: over the same, zero where the
    /// viewpoint sees it edge-on; `shares`: sides of `uv` as shares of those of the box that it was
    /// lowered on.
    SilhouettePart(const Box2& uv, HomogeneousNet points, DegreeReducedScalar edge_on,
                   const Vec2& shares);

    /// Parameters of the patch that the part covers.
    const Box2& uv() const { return uv_; }
    /// Control points over uv(), in the frame that it was made with.
    const HomogeneousNet& points() const { return points_; }
    /// Function over uv() that is zero where the viewpoint sees the part edge-on.
    const DegreeReducedScalar& edge_on() const { return edge_on_; }

    /// Calls `solve(part, pair)` for each part that is proved, by `pair`, to hold at most one
    /// silhouette in the section, and may hold one. Where more may be, and where that returns
    /// false, it is halved, and after `most_halvings` given to `search(part)`.
    template <class Solve, class Search>
    void each_part(const Section& section, int most_halvings, const Solve& solve,
                   const Search& search) {
        if (section.misses(bounds_)) return;
        const AffineBounds::Weighed distance = bounds_.weighed(section.plane);
        if (distance.vanishes_nowhere()) return;
        const LinearizedSystem pair(distance, slopes_.all);
        if (pair.root_is_outside()) return;
        if (pair.variation() < LinearizedSystem::proved && solve(*this, pair)) return;
        if (most_halvings == 0) return search(*this);
        for (SilhouettePart& half : halves())
            half.each_part(section, most_halvings - 1, solve, search);
    }

    /// Whether a part of it, halved `most_halvings` times, may lie in `volume`, by some of its
    /// sides; `frame`: of the points.
    bool may_be_in(const ViewVolume& volume, ViewVolume::Sides sides, const NetFrame& frame,
                   int most_halvings);

private:
    std::vector<SilhouettePart>& halves();

    Box2 uv_;
    HomogeneousNet points_;
    AffineBounds bounds_;
    DegreeReducedScalar edge_on_;
    Vec2 shares_;
    GradientBounds slopes_;                               ///< with their errors
    std::optional<std::vector<SilhouettePart>> halves_{}; ///< those that may be seen edge-on
};

/// The search for common zeros of two functions on a piece where one look proves nothing: the
/// piece is split until on each part the functions are proved to have at most one, or none.
class SilhouetteSearch {
public:
    /// f and g over the searched box, [0, 1]^2 of its own parameters; `error`: bound of what g may
    /// be off by.
    SilhouetteSearch(ScalarNet f, ScalarNet g, double error = 0)
        : f_(std::move(f)), g_(std::move(g)), error_(error) {}

    /// Newton's method for the exact functions from a place in a box of this extent; nothing when
    /// it fails.
    using Solve = std::function<std::optional<Vec2>(const Vec2& start, const Vec2& extent)>;
    /// How far an event can be moved along the segment, in its parameter, by moving within a box.
    using Spread = std::function<double(const Box2&)>;
    /// Result of a search, in no order.
    struct Result {
        std::vector<Vec2> roots; ///< in [0, 1]^2 or its overlap
        /// Boxes' middles where one event cannot be separated from several.
        std::vector<Vec2> unclear;
        bool certain = true; ///< false when unclear boxes are wide
    };
    /// Runs the search; after `most_boxes` boxes those that are left count as unclear.
    Result run(const Solve& solve, const Spread& spread, int most_boxes) const;

private:
    ScalarNet f_, g_;
    double error_;
};

} // namespace keiko
