#pragma once

#include "keiko/geometry/bvh/plane_tree.h"
#include "keiko/visibility/query/apex_screen.h"
#include "keiko/visibility/query/occluder_scene.h"
#include "keiko/visibility/query/outline_turns.h"
#include "keiko/visibility/query/segment_gaps.h"

#include <map>

namespace keiko {

/// All that may hide some of a region from one apex: what ApexView asks.
class ApexView::Candidates {
public:
    Candidates(const Occluders::Scene& scene, const Tracer& tracer, const Apex& apex,
               std::span<const Vec3> region, const std::optional<Vec3>& facing);

    SeenParts intervals(const SegmentEnds& ends) const;
    /// Nothing where the segments are no scan lines.
    std::optional<std::vector<SeenParts>> intervals_of_row(std::span<const SegmentEnds> row) const;

    std::vector<std::optional<bool>> seen_as_whole(std::span<const PrismEdges> prisms) const;
    std::vector<SeenTurn> turns(const PrismEdges& prism, double gap, double missed) const;

private:
    /// A segment under way.
    struct Line {
        SegmentPlane plane;
        ParameterInterval asked; ///< on the side that the apex faces
        SeenWedge wedge;         ///< to that
        bool searches_own;       ///< seen so low that the apex's own surroundings may hide it
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
        ApexScreen screen;
        std::vector<ScreenBox> pieces, borders;
        /// Of the pieces for which prisms asked, as fold_line() tells.
        std::map<std::size_t, std::optional<std::vector<BorderPiece>>> folds{};
    };

    void collect(std::span<const Vec3> region);
    bool nothing_happens_in(std::span<const Vec3> region) const;
    bool sees(const Vec3& x) const { return !tracer_->any(apex_.ray_to(x)); }
    /// Whether the outlines of all candidates are proved to lie beside the part of a prism that has
    /// these corners, as the apex sees it.
    bool nothing_crosses(const PrismEdges& prism, std::span<const Vec3> corners) const;
    /// Whether the apex's own surroundings may hide any of the part of a prism in `volume`.
    bool own_may_cross(const ViewVolume& volume, std::span<const Vec3> corners) const;
    /// Whether the lines along which a silhouette candidate is seen edge-on are proved to run
    /// across segments all along, at no more than a slope along by across.
    bool runs_across(std::size_t piece, double most_slope) const;
    void add_folds(std::size_t piece, OutlineTurns& turns) const;
    void add_outlines(const ScreenBox& prism, OutlineTurns& turns) const;
    /// The part of a segment on the side that the apex faces.
    ParameterInterval asked_of(const SegmentEnds& ends) const;
    std::optional<Line> line_through(const SegmentEnds& ends) const;
    SeenParts end_on(const SegmentEnds& ends) const;
    void add_piece_events(std::size_t piece, Line& line) const;
    void add_border_events(std::size_t border, Line& line) const;
    void add_events(Line& line) const;
    void add_all_events(Line& line) const;
    void add_events_of_cut(Line& line) const;
    std::vector<Box3> candidate_boxes() const;
    void add_own_events(Line& line) const;
    void add_piercings(Line& line) const;
    void add_horizon(Line& line) const;
    const Screen& screen_of(const Vec3& along) const;
    /// By rising `across`; nothing where a segment is no scan line.
    std::optional<std::vector<ScanLine>> scan_lines(const ApexScreen& screen,
                                                    std::span<const SegmentEnds> row) const;
    void scan(const Screen& screen, std::span<const ScanLine> scan_lines,
              std::vector<Line>& lines) const;
    void join_neighbours(const Screen& screen, std::span<const ScanLine> scan_lines,
                         std::span<const std::size_t> first_gap, GapGroups& groups) const;

    const Occluders::Scene* scene_;
    const Tracer* tracer_;
    Apex apex_;
    std::optional<Vec3> facing_;
    Vec3 middle_{0}; ///< of the region
    SilhouetteCandidates silhouettes_;
    std::vector<std::uint32_t> borders_;
    bool region_touched_ = false; ///< a surface may cross the region itself
    std::optional<Vec3> normal_;  ///< of the surface that the apex lies on
    /// The tangent plane there has to be looked at, since no side of it is faced.
    bool has_horizon_ = false;
    /// Whether all of the region is seen, or none of it, where nothing can come in between.
    std::optional<bool> all_seen_;
    mutable int asked_for_ = 0; ///< segments one by one
    mutable std::optional<PlaneTree> tree_;
    mutable std::optional<Screen> screen_; ///< of the direction asked for last
};

} // namespace keiko
