#pragma once

#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/geometry/rays/ray.h"
#include "keiko/geometry/rays/visibility.h"
#include "keiko/visibility/boundaries/boundary_piece.h"
#include "keiko/visibility/query/contour_extrema.h"
#include "keiko/visibility/query/event_intervals.h"
#include "keiko/visibility/query/occluder_scene.h"
#include "keiko/visibility/query/scan_plane.h"
#include "keiko/visibility/query/visible_intervals.h"
#include "keiko/visibility/silhouettes/bounds_tree.h"
#include "keiko/visibility/silhouettes/silhouette_events.h"

#include <map>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// All that may hide some of a region from one viewpoint: what VisibilityQuery asks.
class OccluderCandidates {
public:
    /// Collects the candidates; arguments as of VisibilityQuery. Keeps pointers to scene and
    /// tracer.
    OccluderCandidates(const OccluderScene& scene, const Tracer& tracer, const Viewpoint& viewpoint,
                       std::span<const Vec3> region, const std::optional<Vec3>& facing);

    /// Visible parts of a segment.
    VisibleIntervals intervals(const Segment& ends) const;
    /// Visible parts of a row; nullopt where the segments are no scan lines.
    std::optional<std::vector<VisibleIntervals>> intervals_of_row(
        std::span<const Segment> row) const;

    /// Visibility of whole prisms; see VisibilityQuery::classify_prisms().
    std::vector<std::optional<bool>> classify_prisms(std::span<const Prism> prisms) const;
    /// Turns of a prism; none for parallel light, and where its screen is seen end-on.
    std::vector<CriticalSlice> turns(const Prism& prism, const TurnRule& rule) const;

private:
    /// A segment under way.
    struct Line {
        SegmentPlane plane;
        ParameterInterval asked; ///< on the side that the viewpoint faces
        ShadowWedge wedge;       ///< to that
        bool searches_own;       ///< seen so low that the viewpoint's own surroundings may hide it
        std::vector<VisibilityEvent> events{};
        bool certain = true;
    };
    /// A segment on the screen.
    struct ScanLine {
        std::size_t line; ///< in the order of the row
        double across = 0, begin = 0, end = 0;
    };
    /// The candidates on the screen of one direction of segments.
    struct Screen {
        ScanPlane screen;
        std::vector<ScanBounds> pieces, borders;
        /// Folds of the pieces that prisms have needed, as contour_generator() returns them.
        std::map<std::size_t, std::optional<std::vector<BoundaryPiece>>> folds{};
    };

    void collect(std::span<const Vec3> region);
    bool nothing_happens_in(std::span<const Vec3> region) const;
    bool sees(const Vec3& x) const { return !tracer_->any(viewpoint_.ray_to(x)); }
    /// Whether the outlines of all candidates are proved to lie beside the part of a prism that has
    /// these corners, as the viewpoint sees it.
    bool nothing_crosses(const Prism& prism, std::span<const Vec3> corners) const;
    /// Whether the viewpoint's own surroundings may hide any of the part of a prism in `volume`.
    bool own_may_cross(const ViewVolume& volume, std::span<const Vec3> corners) const;
    /// Whether the lines along which a silhouette candidate is seen edge-on are proved to run
    /// across segments all along, at no more than a slope along by across.
    bool runs_across(std::size_t piece, double most_slope) const;
    void add_folds(std::size_t piece, ContourExtrema& turns) const;
    void add_outlines(const ScanBounds& prism, ContourExtrema& turns) const;
    /// The part of a segment on the side that the viewpoint faces.
    ParameterInterval asked_of(const Segment& ends) const;
    std::optional<Line> line_through(const Segment& ends) const;
    VisibleIntervals end_on(const Segment& ends) const;
    void add_piece_events(std::size_t piece, Line& line) const;
    void add_boundary_events(std::size_t border, Line& line) const;
    void add_events(Line& line) const;
    void add_all_events(Line& line) const;
    void add_events_of_cut(Line& line) const;
    std::vector<Box3> candidate_boxes() const;
    void add_own_events(Line& line) const;
    void add_piercings(Line& line) const;
    void add_horizon(Line& line) const;
    const Screen& screen_of(const Vec3& along) const;
    /// By rising `across`; nothing where a segment is no scan line.
    std::optional<std::vector<ScanLine>> scan_lines(const ScanPlane& screen,
                                                    std::span<const Segment> row) const;
    void scan(const Screen& screen, std::span<const ScanLine> scan_lines,
              std::vector<Line>& lines) const;
    void join_neighbours(const Screen& screen, std::span<const ScanLine> scan_lines,
                         std::span<const std::size_t> first_interval,
                         IntervalClasses& groups) const;

    const OccluderScene* scene_;
    const Tracer* tracer_;
    Viewpoint viewpoint_;
    std::optional<Vec3> facing_;
    Vec3 middle_{0}; ///< of the region
    SilhouetteCandidates silhouettes_;
    std::vector<std::uint32_t> borders_;
    bool region_touched_ = false; ///< a surface may cross the region itself
    std::optional<Vec3> normal_;  ///< of the surface that the viewpoint lies on
    /// The tangent plane at the viewpoint matters, since no side of it is faced.
    bool has_horizon_ = false;
    /// Whether all of the region is seen, or none of it, where nothing can come in between.
    std::optional<bool> all_seen_;
    mutable int asked_for_ = 0; ///< segments one by one
    mutable std::optional<PlaneTree> tree_;
    mutable std::optional<Screen> screen_; ///< of the last direction
};

/// Corners of the part of a convex body on the side of the plane through a viewpoint that the unit
/// normal `facing` points to, and maybe places between them.
inline std::vector<Vec3> clip_to_half_space(const Viewpoint& viewpoint, const Vec3& facing,
                                            std::span<const Vec3> corners) {
    std::vector<Vec3> part;
    part.reserve(2 * corners.size());
    for (const Vec3& p : corners) {
        const double at_p = facing.dot(viewpoint.way_to(p));
        if (at_p >= 0) part.push_back(p);
        for (const Vec3& q : corners) {
            const double at_q = facing.dot(viewpoint.way_to(q));
            if (at_p > 0 && at_q < 0) part.push_back(p + (q - p) * (at_p / (at_p - at_q)));
        }
    }
    return part;
}

} // namespace keiko
