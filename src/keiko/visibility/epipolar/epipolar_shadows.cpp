#include "keiko/visibility/epipolar/epipolar_shadows.h"

#include "keiko/base/parallel.h"
#include "keiko/visibility/epipolar/epipolar_curve.h"
#include "keiko/visibility/query/event_intervals.h"
#include "keiko/visibility/query/occluder_scene.h"
#include "keiko/visibility/query/scan_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <unordered_map>
#include <utility>

namespace keiko {
namespace {

/// A line that the light sees edge-on.
struct EdgeLine {
    EpipolarCurve line;
    /// Outline or crease that decides where the line is on material; neither: all along.
    std::optional<ContourCurve> outline{};
    std::optional<std::uint32_t> crease{}; ///< number of a border
};

/// Outlines of some pieces, and those pieces whose outlines are no such curves.
struct Outlines {
    std::vector<ContourCurve> lines;
    std::vector<SilhouetteCandidate> pieces;
};

/// Planes of one quarter of a turn about the axis.
struct Quarter {
    ScanPlane screen;
    BucketGrid boxes; ///< of lines, then of pieces
};

Box2 face_box(const OccluderPatch& patch, std::span<const Vec2> places) {
    Box2 box;
    for (const Vec2& place : places) box.extend(patch.face_parameters(place));
    return box;
}

} // namespace

class EpipolarShadows::Planes {
public:
    Planes(const OccluderScene& scene, const Tracer& tracer, const Vec3& light, const Vec3& eye,
           const Job& job)
        : scene_(scene), tracer_(tracer), viewpoint_(Viewpoint::at(light)), axes_(light, eye) {
        std::vector<BoundaryPiece> curves;
        add_outlines(job, curves);
        add_borders(curves);
        for (int quarter = 0; quarter < 4; ++quarter)
            quarters_.push_back(quarter_at(quarter, curves));
    }

    std::vector<IntervalSet> intervals(std::span<const Segment> segments) const;

private:
    /// Pieces as the rays of one question share them: they are split where that is needed.
    using Pieces = std::unordered_map<std::size_t, SilhouetteCandidate>;

    void add_outlines(const Job& job, std::vector<BoundaryPiece>& curves);
    void add_outline(const ContourCurve& outline, std::vector<BoundaryPiece>& curves);
    void add_borders(std::vector<BoundaryPiece>& curves);
    Quarter quarter_at(int quarter, std::span<const BoundaryPiece> curves) const;
    const Quarter& quarter_of(const Vec2& off) const;
    bool sees(const Vec3& x) const { return !tracer_.any(viewpoint_.ray_to(x)); }
    void find_events(const SegmentPlane& plane, Pieces& pieces,
                     std::vector<VisibilityEvent>& events) const;
    /// Whether a line is on material there; mixed: nobody knows.
    TrimSide side_at(const EdgeLine& edge, double t) const;

    const OccluderScene& scene_;
    const Tracer& tracer_;
    Viewpoint viewpoint_;
    EpipolarAxes axes_;
    std::vector<EdgeLine> lines_;
    std::vector<SilhouetteCandidate> pieces_; ///< of whose outlines there are no lines
    std::vector<Quarter> quarters_;
};

void EpipolarShadows::Planes::add_outlines(const Job& job, std::vector<BoundaryPiece>& curves) {
    constexpr std::size_t chunk = 256;
    const std::size_t count = scene_.silhouettes.pieces.size();
    std::vector<Outlines> found((count + chunk - 1) / chunk);
    parallel_for(found.size(), job, "", [&](std::size_t c) {
        SilhouetteCandidates candidates;
        for (std::size_t i = c * chunk; i < std::min(count, (c + 1) * chunk); ++i)
            scene_.candidates.add(static_cast<std::uint32_t>(i), viewpoint_, {}, candidates);
        for (SilhouetteCandidate& candidate : candidates.pieces)
            if (!append_contour(scene_.silhouettes, scene_.kernels, candidate, viewpoint_,
                                found[c].lines))
                found[c].pieces.push_back(std::move(candidate));
    });
    for (Outlines& outlines : found) {
        for (const ContourCurve& line : outlines.lines) add_outline(line, curves);
        std::move(outlines.pieces.begin(), outlines.pieces.end(), std::back_inserter(pieces_));
    }
}

void EpipolarShadows::Planes::add_outline(const ContourCurve& outline,
                                          std::vector<BoundaryPiece>& curves) {
    EdgeLine edge{EpipolarCurve(axes_, outline.line)};
    if (outline.trimmed) {
        const OccluderPatch& patch = scene_.silhouettes.patches[outline.patch];
        const TrimSide side =
            scene_.silhouettes.regions[patch.face].classify(face_box(patch, outline.places));
        if (side == TrimSide::outside) return;
        if (side == TrimSide::mixed) edge.outline = outline;
    }
    lines_.push_back(std::move(edge));
    curves.push_back(outline.line);
}

void EpipolarShadows::Planes::add_borders(std::vector<BoundaryPiece>& curves) {
    for (std::uint32_t i = 0; i < scene_.borders.size(); ++i) {
        const BoundaryPiece& border = scene_.borders[i];
        if (!border.may_be_edge_on(viewpoint_)) continue;
        EdgeLine edge{EpipolarCurve(axes_, border)};
        if (border.trimmed) edge.crease = i;
        lines_.push_back(std::move(edge));
        curves.push_back(border);
    }
}

Quarter EpipolarShadows::Planes::quarter_at(int quarter,
                                            std::span<const BoundaryPiece> curves) const {
    const double angle = quarter * std::numbers::pi / 2;
    const Vec3 way = axes_.x * std::cos(angle) + axes_.y * std::sin(angle);
    ScanPlane screen(viewpoint_, axes_.z, viewpoint_.place() + way);
    std::vector<ScanBounds> boxes;
    const auto add = [&](const ScanBounds& box) {
        constexpr double widest = 1 + 1e-6;
        const bool met = box.across_low <= widest && box.across_high >= -widest;
        boxes.push_back(met ? box : ScanBounds());
    };
    for (const BoundaryPiece& curve : curves) add(screen.box(curve));
    for (const SilhouetteCandidate& c : pieces_)
        add(screen.box(scene_.silhouettes.pieces[c.piece], c.edge_on));
    return {std::move(screen), BucketGrid(std::move(boxes), -1, 1)};
}

const Quarter& EpipolarShadows::Planes::quarter_of(const Vec2& off) const {
    if (std::abs(off.x) >= std::abs(off.y)) return quarters_[off.x > 0 ? 0 : 2];
    return quarters_[off.y > 0 ? 1 : 3];
}

void EpipolarShadows::Planes::find_events(const SegmentPlane& plane, Pieces& pieces,
                                          std::vector<VisibilityEvent>& events) const {
    const EpipolarRay ray(axes_, plane);
    const Quarter& quarter = quarter_of(ray.off);
    const bool rising = ray.end.x >= ray.begin.x;
    const ScreenPlace near = quarter.screen.place(plane.at(rising ? 0 : 1));
    const ScreenPlace far = quarter.screen.place(plane.at(rising ? 1 : 0));
    // The eye itself lies on the axis, where every line ends.
    constexpr double on_axis = 1e-9, infinity = std::numeric_limits<double>::infinity();
    const bool from_axis = near.depth <= on_axis * far.depth;
    const double low = from_axis ? -infinity : std::min(near.along, far.along);
    const double high = from_axis ? infinity : std::max(near.along, far.along);
    std::optional<ShadowWedge> wedge;
    quarter.boxes.each_met(far.across, low, high, [&](std::size_t i) {
        if (i < lines_.size())
            return lines_[i].line.each_event(ray, [&](double t, VisibilityEvent event) {
                const TrimSide side = side_at(lines_[i], t);
                if (side == TrimSide::mixed) event.dark = 0;
                if (side != TrimSide::outside) events.push_back(event);
            });
        const SilhouetteCandidate& known = pieces_[i - lines_.size()];
        const auto own = pieces.try_emplace(i, SilhouetteCandidate{known.piece, known.edge_on});
        if (!wedge) wedge.emplace(plane, ParameterInterval{0, 1});
        scene_.solver.find(own.first->second, plane, *wedge, events);
    });
}

TrimSide EpipolarShadows::Planes::side_at(const EdgeLine& edge, double t) const {
    if (edge.crease) {
        const BoundaryPiece& border = scene_.borders[*edge.crease];
        const Vec2 at = border.first + (border.last - border.first) * t;
        const bool material = scene_.silhouettes.regions[border.face].contains(at);
        return material ? TrimSide::inside : TrimSide::outside;
    }
    if (!edge.outline) return TrimSide::inside;
    const OccluderPatch& patch = scene_.silhouettes.patches[edge.outline->patch];
    constexpr double known = 1e-6;
    const Vec2 uv = edge.outline->place_at(t);
    const std::array corners{uv - Vec2(known), uv + Vec2(known)};
    return scene_.silhouettes.regions[patch.face].classify(face_box(patch, corners));
}

std::vector<IntervalSet> EpipolarShadows::Planes::intervals(
    std::span<const Segment> segments) const {
    std::vector<std::optional<SegmentPlane>> planes;
    for (const Segment& ends : segments)
        planes.push_back(ends.a == ends.b ? std::nullopt
                                          : SegmentPlane::through(viewpoint_, ends.a, ends.b));
    Pieces pieces;
    IntervalClasses groups;
    std::vector<std::size_t> first_interval;
    std::vector<VisibilityEvent> events;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        first_interval.push_back(groups.size());
        if (!planes[i]) continue;
        events.clear();
        find_events(*planes[i], pieces, events);
        groups.add(*planes[i], event_intervals(events, {0, 1}));
    }
    first_interval.push_back(groups.size());
    groups.classify(tracer_);
    std::vector<IntervalSet> seen;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const std::size_t first = first_interval[i], count = first_interval[i + 1] - first;
        // Towards the light, with nothing across it, a segment is seen as its middle is.
        const auto whole = [&] { return sees((segments[i].a + segments[i].b) / 2); };
        seen.push_back(planes[i] ? groups.seen(first, count)
                       : whole() ? IntervalSet::whole()
                                 : IntervalSet());
    }
    return seen;
}

EpipolarShadows::EpipolarShadows(const Occluders& occluders, const Tracer& tracer,
                                 const Vec3& light, const Vec3& eye, const Job& job)
    : planes_(std::make_unique<Planes>(*occluders.scene_, tracer, light, eye, job)) {}

EpipolarShadows::~EpipolarShadows() = default;
EpipolarShadows::EpipolarShadows(EpipolarShadows&&) noexcept = default;
EpipolarShadows& EpipolarShadows::operator=(EpipolarShadows&&) noexcept = default;

std::vector<IntervalSet> EpipolarShadows::intervals(std::span<const Segment> segments) const {
    return planes_->intervals(segments);
}

} // namespace keiko
