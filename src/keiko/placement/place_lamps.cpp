#include "keiko/placement/place_lamps.h"

#include "keiko/base/error.h"
#include "keiko/base/parallel.h"
#include "keiko/placement/candidate_planes.h"
#include "keiko/placement/oriented_box.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace keiko {
namespace {

constexpr double t8_diameter = 26;                      ///< mm
constexpr double least_duty = 0.3, greatest_duty = 0.5; ///< diameter by pitch
constexpr std::size_t search_samples = 2000;

/// Searches the planes one after the other, on a thinned field.
class Search {
public:
    Search(const LampField& field, const Box3& body, const LampDemand& demand,
           const PlacementOptions& options)
        : field_(field.thinned(search_samples)),
          body_(oriented(body)),
          demand_(demand),
          options_(options) {}

    /// The best lamps for what still waits; nothing where no plane is of use.
    std::optional<LampRectangle> next(const Job& job) {
        const std::vector<PlaneFrame> planes = candidate_planes(field_, options_.where);
        std::vector<LampRectangle> found(planes.size());
        parallel_for(planes.size(), job, "place", [&](std::size_t i) {
            found[i] = admitted(PlaneSearch(field_, planes[i], demand_).best());
        });
        note_candidates(planes, found);
        const auto best = std::max_element(
            found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.score.objective() < b.score.objective(); });
        if (best == found.end() || !(best->score.objective() > 0)) return {};
        return *best;
    }

    void place(const CPlane& plane) {
        field_.place(plane);
        placed_.push_back(oriented(plane));
    }
    CPlane lamps(const LampRectangle& r) const {
        return r.c_plane(lamp_diameter(r.pitch()), options_.luminance);
    }
    double coverage() const { return field_.coverage(); }
    std::vector<PlaneCandidate> take_candidates() { return std::move(candidates_); }

private:
    /// The rectangle, its score struck out where it runs into the body or into other lamps.
    LampRectangle admitted(LampRectangle r) const {
        if (r.lamps == 0) return r;
        const OrientedBox room = oriented(lamps(r));
        const bool in_the_way =
            overlap(room, body_) || std::any_of(placed_.begin(), placed_.end(),
                                                [&](const auto& p) { return overlap(room, p); });
        if (in_the_way) r.score = {};
        return r;
    }

    void note_candidates(const std::vector<PlaneFrame>& planes,
                         const std::vector<LampRectangle>& found) {
        if (!candidates_.empty() || !placed_.empty()) return;
        for (std::size_t i = 0; i < planes.size(); ++i) {
            const Vec3 offset = planes[i].origin - field_.centroid();
            candidates_.push_back({offset.normalized(), offset.length(), found[i].score});
        }
    }

    LampField field_;
    OrientedBox body_;
    LampDemand demand_;
    const PlacementOptions& options_;
    std::vector<OrientedBox> placed_;
    std::vector<PlaneCandidate> candidates_;
};

} // namespace

double lamp_diameter(double pitch) {
    return std::clamp(t8_diameter, least_duty * pitch, greatest_duty * pitch);
}

Placement place_lamps(std::vector<ViewSample> seen, const SurfaceModel& model, const Box3& body,
                      int picture_height, const PlacementOptions& options, const Job& job) {
    LampField field(std::move(seen));
    if (!(field.total_weight() > 0))
        throw Error("", "placement", "no camera sees the surface that lamps are to be placed for");
    const StripeSpacing wanted = options.spacing.for_height(picture_height);
    Search search(field, body, {options.lamps, wanted, options.direction}, options);
    Placement result;
    result.rig.name = "placed";
    while (static_cast<int>(result.planes.size()) < options.planes &&
           search.coverage() < options.enough) {
        const std::optional<LampRectangle> next = search.next(job);
        const bool first = result.planes.empty();
        if (!next || (!first && next->score.coverage < options.least_gain)) break;
        const CPlane lamps = search.lamps(*next);
        search.place(lamps);
        field.place(lamps);
        result.planes.push_back({lamps, next->score, hit_histogram(field, lamps)});
        result.rig.sources.emplace_back(lamps);
    }
    if (result.planes.empty())
        throw Error("", "placement", "no plane around the body mirrors to the cameras");
    tell_what_is_reached(result, field, model, wanted);
    result.candidates = search.take_candidates();
    return result;
}

Placement place_lamps(const Tracer& tracer, const SurfaceModel& model,
                      std::span<const Camera> cameras, const PlacementOptions& options,
                      const Job& job) {
    return place_lamps(sample_views(tracer, model, cameras, options.sampling, job), model,
                       tracer.bounds(), cameras.front().height, options, job);
}

Placement place_lamps(const Tracer& tracer, const SurfaceModel& model, const Camera& camera,
                      const PlacementOptions& options, const Job& job) {
    return place_lamps(tracer, model, std::span(&camera, 1), options, job);
}

} // namespace keiko
