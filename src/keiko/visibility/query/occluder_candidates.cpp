#include "keiko/visibility/query/occluder_candidates.h"

#include "keiko/math/vec.h"
#include "keiko/visibility/boundaries/plane_cuts.h"
#include "keiko/visibility/silhouettes/chord_elevation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {

namespace {

bool same_plane(const Vec3& a, const Vec3& b) {
    constexpr double same = 1e-9; // rad
    return a.cross(b).length() < same;
}

} // namespace

OccluderCandidates::OccluderCandidates(const OccluderScene& scene, const Tracer& tracer,
                                       const Viewpoint& viewpoint, std::span<const Vec3> region,
                                       const std::optional<Vec3>& facing)
    : scene_(&scene), tracer_(&tracer), viewpoint_(viewpoint), facing_(facing) {
    if (viewpoint.excluded()) normal_ = scene.silhouettes.normal_at(*viewpoint.excluded());
    has_horizon_ = normal_ && !(facing && same_plane(*normal_, *facing));
    std::vector<Vec3> faced;
    if (facing) {
        faced = clip_to_half_space(viewpoint, *facing, region);
        region = faced;
    }
    if (region.empty()) {
        all_seen_ = false;
        return;
    }
    middle_ = middle_of(region);
    collect(region);
    if (nothing_happens_in(region)) all_seen_ = sees(middle_);
}

void OccluderCandidates::collect(std::span<const Vec3> region) {
    const ViewVolume volume(viewpoint_, region, facing_);
    std::optional<ViewpointHorizon> horizon;
    if (normal_) horizon = {*normal_, least_elevation(viewpoint_, *normal_, region)};
    using Sides = ViewVolume::Sides;
    scene_->silhouette_pieces.find(volume, viewpoint_, [&](std::uint32_t piece, Sides sides) {
        if (volume.may_hold(scene_->silhouettes.pieces[piece], sides))
            scene_->candidates.add(piece, viewpoint_, horizon, silhouettes_);
    });
    scene_->candidates.finish(viewpoint_, horizon, silhouettes_);
    scene_->boundary_pieces.find(volume, viewpoint_, [&](std::uint32_t border, Sides sides) {
        const BoundaryPiece& piece = scene_->borders[border];
        if (volume.may_hold(piece, sides) && piece.may_be_edge_on(viewpoint_))
            borders_.push_back(border);
    });
    region_touched_ = scene_->surface.touches(volume.region());
}

/// No event can lie on any segment of the region, not even the horizon of the viewpoint.
bool OccluderCandidates::nothing_happens_in(std::span<const Vec3> region) const {
    if (!silhouettes_.pieces.empty() || !silhouettes_.own.empty() || !borders_.empty() ||
        region_touched_)
        return false;
    const auto above = [&](const Vec3& x) { return normal_->dot(viewpoint_.way_to(x)) > 0; };
    return !has_horizon_ || std::all_of(region.begin(), region.end(), above) ||
           std::none_of(region.begin(), region.end(), above);
}

ParameterInterval OccluderCandidates::asked_of(const Segment& ends) const {
    if (!facing_) return {0, 1};
    const double at_a = facing_->dot(viewpoint_.way_to(ends.a));
    const double at_b = facing_->dot(viewpoint_.way_to(ends.b));
    if (at_a >= 0 && at_b >= 0) return {0, 1};
    if (!(at_a > 0) && !(at_b > 0)) return {0, 0};
    const double t = at_a / (at_a - at_b);
    return at_a > 0 ? ParameterInterval{0, t} : ParameterInterval{t, 1};
}

std::optional<OccluderCandidates::Line> OccluderCandidates::line_through(
    const Segment& ends) const {
    const auto plane = SegmentPlane::through(viewpoint_, ends.a, ends.b);
    if (!plane) return std::nullopt;
    const ParameterInterval part = asked_of(ends);
    Line line{*plane, part, ShadowWedge(*plane, part), !silhouettes_.own.empty()};
    if (line.searches_own && normal_) {
        const std::array asked{plane->at(line.asked.begin), plane->at(line.asked.end)};
        line.searches_own =
            least_elevation(viewpoint_, *normal_, asked) <= silhouettes_.own_steepest();
    }
    return line;
}

VisibleIntervals OccluderCandidates::intervals(const Segment& ends) const {
    const ParameterInterval asked = asked_of(ends);
    if (all_seen_) return {*all_seen_ ? IntervalSet::whole(asked.begin, asked.end) : IntervalSet()};
    if (ends.a == ends.b)
        return {asked.end > 0 && sees(ends.a) ? IntervalSet::whole() : IntervalSet()};
    auto line = line_through(ends);
    if (!line) return end_on(ends);
    add_events(*line);
    add_own_events(*line);
    IntervalClasses classes;
    classes.add(line->plane, event_intervals(line->events, line->asked));
    classes.classify(*tracer_);
    return {classes.seen(0, classes.size()), line->certain};
}

void OccluderCandidates::add_piece_events(std::size_t piece, Line& line) const {
    const SilhouetteCandidate& candidate = silhouettes_.pieces[piece];
    line.certain =
        scene_->solver.find(candidate, line.plane, line.wedge, line.events) && line.certain;
}

void OccluderCandidates::add_boundary_events(std::size_t border, Line& line) const {
    find_border_events(scene_->borders[borders_[border]], scene_->silhouettes.regions, line.plane,
                       line.events);
}

void OccluderCandidates::add_events(Line& line) const {
    constexpr int few = 16; // a tree pays off only for many segments
    if (asked_for_ < few)
        ++asked_for_, add_all_events(line);
    else
        add_events_of_cut(line);
}

void OccluderCandidates::add_all_events(Line& line) const {
    for (std::size_t i = 0; i < silhouettes_.pieces.size(); ++i) add_piece_events(i, line);
    for (std::size_t i = 0; i < borders_.size(); ++i) add_boundary_events(i, line);
}

/// Adds the events of the candidates that the segment's plane through the viewpoint cuts: no other
/// has any.
void OccluderCandidates::add_events_of_cut(Line& line) const {
    if (!tree_) tree_.emplace(candidate_boxes());
    const Vec3& normal = line.plane.normal();
    const std::size_t pieces = silhouettes_.pieces.size();
    for (const std::uint32_t i : tree_->cut_by(normal, normal.dot(line.plane.at(0))))
        i < pieces ? add_piece_events(i, line) : add_boundary_events(i - pieces, line);
}

/// Boxes of silhouette pieces, then of borders, widened by their overlap with their neighbours.
std::vector<Box3> OccluderCandidates::candidate_boxes() const {
    std::vector<Box3> boxes;
    const auto add = [&](Box3 box, double room) {
        room += 1e-5 * box.size();
        box.lower -= Vec3(room), box.upper += Vec3(room);
        boxes.push_back(box);
    };
    for (const SilhouetteCandidate& candidate : silhouettes_.pieces)
        add(scene_->silhouettes.pieces[candidate.piece].box, 0);
    for (const std::uint32_t border : borders_)
        add(scene_->borders[border].box, scene_->borders[border].error);
    return boxes;
}

/// From the line of the segment itself: it is seen up to the first surface on the line.
VisibleIntervals OccluderCandidates::end_on(const Segment& ends) const {
    const Vec3 &a = ends.a, &b = ends.b;
    Ray along;
    along.origin = a;
    along.direction = b - a;
    along.t_max = 1;
    std::vector<ParameterInterval> seen;
    double from = 0;
    const auto close = [&](double to) {
        constexpr double shortest = 1e-9;
        if (to - from > shortest && sees(a + (b - a) * ((from + to) / 2)))
            seen.push_back({from, to});
        from = to;
    };
    for (const Hit& hit : tracer_->all(along)) close(hit.t);
    close(1);
    return {IntervalSet(std::move(seen))};
}

/// Adds the events of the viewpoint's own surface and of surfaces that cross the segment itself.
void OccluderCandidates::add_own_events(Line& line) const {
    if (line.searches_own)
        for (const OwnCandidate& own : silhouettes_.own)
            line.certain =
                scene_->solver.find(own, line.plane, line.wedge, line.events) && line.certain;
    if (region_touched_) add_piercings(line);
    if (has_horizon_) add_horizon(line);
}

void OccluderCandidates::add_piercings(Line& line) const {
    Ray along;
    along.origin = line.plane.at(0);
    along.direction = line.plane.along();
    along.t_max = 1;
    for (const Hit& hit : tracer_->all(along)) line.events.push_back({hit.t, 0});
}

/// Adds the place where the segment crosses the tangent plane of the surface that the viewpoint
/// lies on.
void OccluderCandidates::add_horizon(Line& line) const {
    const double at_a = normal_->dot(viewpoint_.way_to(line.plane.at(0)));
    const double at_b = normal_->dot(viewpoint_.way_to(line.plane.at(1)));
    if ((at_a < 0) != (at_b < 0)) line.events.push_back({at_a / (at_a - at_b), 0});
}

} // namespace keiko
