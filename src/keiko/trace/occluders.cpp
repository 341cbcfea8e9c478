#include "keiko/trace/occluders.h"

#include "keiko/trace/border_events.h"
#include "keiko/trace/piece_tree.h"
#include "keiko/trace/silhouette_events.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace keiko {
namespace {

/// Of a segment: parts and gaps shorter than this are dropped (physics 4.5).
constexpr double shortest = 1e-9;
/// Of a segment: events closer than this are taken as one, whose sides say nothing if they differ.
constexpr double same_event = 1e-11;

PieceTree silhouette_tree(const std::vector<SilhouettePiece>& pieces) {
    std::vector<PieceBound> bounds;
    for (const SilhouettePiece& p : pieces) bounds.push_back({p.box, p.rows[2], p.normal_angle});
    return PieceTree(std::move(bounds));
}

PieceTree border_tree(const std::vector<BorderPiece>& pieces) {
    std::vector<PieceBound> bounds;
    for (const BorderPiece& p : pieces) bounds.push_back({p.box});
    return PieceTree(std::move(bounds));
}

PieceTree surface_tree(std::span<const Box3> boxes) {
    std::vector<PieceBound> bounds;
    for (const Box3& box : boxes) bounds.push_back({box});
    return PieceTree(std::move(bounds));
}

} // namespace

struct Occluders::Scene {
    Silhouettes silhouettes;
    std::vector<BorderPiece> borders;
    PieceTree silhouette_pieces, border_pieces, surface;
    LeafKernels kernels = leaf_kernels();
    SilhouetteSolver solver{silhouettes, kernels};
    Statistics statistics;

    Scene(const SurfaceModel& model, const Tracer& t, const Job& job)
        : silhouettes(silhouettes_of(model, job)),
          borders(keiko::border_pieces(model, job)),
          silhouette_pieces(silhouette_tree(silhouettes.pieces)),
          border_pieces(border_tree(borders)),
          surface(surface_tree(t.boxes())) {}
};

Occluders::Occluders(const SurfaceModel& model, const Tracer& tracer, const Job& job) {
    const auto begin = std::chrono::steady_clock::now();
    scene_ = std::make_unique<Scene>(model, tracer, job);
    scene_->statistics = {
        scene_->silhouettes.pieces.size(), scene_->borders.size(),
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()};
}

Occluders::~Occluders() = default;
Occluders::Occluders(Occluders&&) noexcept = default;
Occluders& Occluders::operator=(Occluders&&) noexcept = default;

const Occluders::Statistics& Occluders::statistics() const {
    return scene_->statistics;
}

struct ApexView::Candidates {
    const Occluders::Scene* scene;
    const Tracer* tracer;
    Apex apex;
    SilhouetteCandidates silhouettes;
    std::vector<std::uint32_t> borders;
    bool region_touched = false; ///< a surface may cross the region itself
    std::optional<Vec3> normal;  ///< of the surface that the apex lies on
    /// Whether all of the region is seen, or none of it, where nothing can come in between.
    std::optional<bool> all_seen;

    bool nothing_happens_in(std::span<const Vec3> region) const;
    SeenParts intervals(const Vec3& a, const Vec3& b) const;
    SeenParts end_on(const Vec3& a, const Vec3& b) const;
    void add_piercings(const SegmentPlane& plane, std::vector<VisibilityEvent>& events) const;
    void add_horizon(const SegmentPlane& plane, std::vector<VisibilityEvent>& events) const;
    bool sees(const Vec3& x) const { return !tracer->any(apex.ray_to(x)); }
    IntervalSet classified(std::span<const VisibilityEvent> events,
                           const SegmentPlane& plane) const;
};

ApexView::ApexView(const Occluders& occluders, const Tracer& tracer, const Apex& apex,
                   std::span<const Vec3> region)
    : candidates_(std::make_unique<Candidates>(
          Candidates{occluders.scene_.get(), &tracer, apex, {}, {}, false, {}, {}})) {
    const Occluders::Scene& scene = *occluders.scene_;
    const ViewVolume volume(apex, region);
    std::vector<std::uint32_t> found;
    scene.silhouette_pieces.find(volume, apex, found);
    for (const std::uint32_t piece : found)
        if (volume.may_hold(scene.silhouettes.pieces[piece]))
            scene.solver.add_candidate(piece, apex, candidates_->silhouettes);
    scene.solver.finish(apex, candidates_->silhouettes);
    scene.border_pieces.find(volume, apex, candidates_->borders);
    if (apex.excluded()) candidates_->normal = scene.silhouettes.normal_at(*apex.excluded());
    candidates_->region_touched = scene.surface.touches(volume.region());
    if (!candidates_->nothing_happens_in(region)) return;
    Vec3 middle(0);
    for (const Vec3& corner : region) middle += corner / static_cast<double>(region.size());
    candidates_->all_seen = candidates_->sees(middle);
}

ApexView::~ApexView() = default;
ApexView::ApexView(ApexView&&) noexcept = default;
ApexView& ApexView::operator=(ApexView&&) noexcept = default;

SeenParts ApexView::intervals(const Vec3& a, const Vec3& b) const {
    return candidates_->intervals(a, b);
}

/// No event can lie on any segment of the region, not even the horizon of the apex.
bool ApexView::Candidates::nothing_happens_in(std::span<const Vec3> region) const {
    if (!silhouettes.pieces.empty() || !silhouettes.own.empty() || !borders.empty() ||
        region_touched)
        return false;
    const auto above = [&](const Vec3& x) { return normal->dot(apex.way_to(x)) > 0; };
    return !normal || std::all_of(region.begin(), region.end(), above) ||
           std::none_of(region.begin(), region.end(), above);
}

SeenParts ApexView::Candidates::intervals(const Vec3& a, const Vec3& b) const {
    if (all_seen) return {*all_seen ? IntervalSet::whole() : IntervalSet()};
    if (a == b) return {sees(a) ? IntervalSet::whole() : IntervalSet()};
    const auto plane = SegmentPlane::through(apex, a, b);
    if (!plane) return end_on(a, b);
    std::vector<VisibilityEvent> events;
    const bool certain = scene->solver.find(silhouettes, *plane, events);
    for (const std::uint32_t border : borders)
        find_border_events(scene->borders[border], scene->silhouettes.regions, *plane, events);
    if (region_touched) add_piercings(*plane, events);
    add_horizon(*plane, events);
    std::sort(events.begin(), events.end(), [](const auto& x, const auto& y) { return x.t < y.t; });
    return {classified(events, *plane), certain};
}

/// From the line of the segment itself: it is seen up to the first surface on the line.
SeenParts ApexView::Candidates::end_on(const Vec3& a, const Vec3& b) const {
    std::vector<VisibilityEvent> events;
    Ray along;
    along.origin = a;
    along.direction = b - a;
    along.t_max = 1;
    std::vector<ParameterInterval> seen;
    double from = 0;
    const auto close = [&](double to) {
        if (to - from > shortest && sees(a + (b - a) * ((from + to) / 2)))
            seen.push_back({from, to});
        from = to;
    };
    for (const Hit& hit : tracer->all(along)) close(hit.t);
    close(1);
    return {IntervalSet(std::move(seen))};
}

void ApexView::Candidates::add_piercings(const SegmentPlane& plane,
                                         std::vector<VisibilityEvent>& events) const {
    Ray along;
    along.origin = plane.at(0);
    along.direction = plane.along();
    along.t_max = 1;
    for (const Hit& hit : tracer->all(along)) events.push_back({hit.t, 0});
}

/// Where the segment crosses the tangent plane of the surface that the apex lies on.
void ApexView::Candidates::add_horizon(const SegmentPlane& plane,
                                       std::vector<VisibilityEvent>& events) const {
    if (!normal) return;
    const double at_a = normal->dot(apex.way_to(plane.at(0)));
    const double at_b = normal->dot(apex.way_to(plane.at(1)));
    if ((at_a < 0) != (at_b < 0)) events.push_back({at_a / (at_a - at_b), 0});
}

IntervalSet ApexView::Candidates::classified(std::span<const VisibilityEvent> events,
                                             const SegmentPlane& plane) const {
    struct Gap {
        double begin, end;
        bool dark; ///< known to be hidden
    };
    std::vector<Gap> gaps;
    Gap open{0, 1, false};
    for (std::size_t i = 0; i < events.size();) {
        std::size_t next = i;
        bool below = false, above = false, all = true;
        for (; next < events.size() && events[next].t - events[i].t <= same_event; ++next) {
            below = below || events[next].dark < 0;
            above = above || events[next].dark > 0;
            all = all && events[next].dark != 0;
        }
        const bool sure = all && below != above;
        open.end = events[i].t;
        open.dark = open.dark || (sure && below);
        gaps.push_back(open);
        open = {events[next - 1].t, 1, sure && above};
        i = next;
    }
    gaps.push_back(open);
    std::erase_if(gaps, [](const Gap& g) { return !(g.end - g.begin > shortest); });

    std::vector<Ray> rays;
    for (const Gap& gap : gaps)
        if (!gap.dark) rays.push_back(apex.ray_to(plane.at((gap.begin + gap.end) / 2)));
    const std::vector<bool> hidden = tracer->any(std::span<const Ray>(rays));
    std::vector<ParameterInterval> seen;
    auto answer = hidden.begin();
    for (const Gap& gap : gaps)
        if (!gap.dark && !*answer++) {
            if (!seen.empty() && gap.begin - seen.back().end <= shortest)
                seen.back().end = gap.end;
            else
                seen.push_back({gap.begin, gap.end});
        }
    return IntervalSet(std::move(seen));
}

} // namespace keiko
