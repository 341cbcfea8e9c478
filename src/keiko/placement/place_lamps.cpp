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

/// Hangs rows of lamps one after the other, on a thinned field.
class RowSearch {
public:
    RowSearch(const LampField& field, const Box3& body, const LampDemand& demand,
              const PlacementOptions& options)
        : field_(field.thinned(search_samples)),
          body_(oriented(body)),
          demand_(demand),
          options_(&options) {}

    /// The best lamps for what still waits on each plane that is of use, the best first; of rows
    /// after the first only those that bring enough.
    std::vector<LampRectangle> next(const Job& job, std::vector<PlaneCandidate>& tried) const {
        const std::vector<PlaneFrame> planes = candidate_planes(field_, options_->where);
        std::vector<LampRectangle> found(planes.size());
        parallel_for(planes.size(), job, "place", [&](std::size_t i) {
            found[i] = admitted(PlaneSearch(field_, planes[i], demand_).best());
        });
        for (std::size_t i = 0; i < planes.size(); ++i) {
            const Vec3 offset = planes[i].origin - field_.centroid();
            tried.push_back({offset.normalized(), offset.length(), found[i].score});
        }
        const double least = rows_.empty() ? 0 : options_->least_gain;
        std::erase_if(found, [&](const LampRectangle& r) {
            return !(r.score.objective() > 0) || r.score.coverage < least;
        });
        std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
            return a.score.objective() > b.score.objective();
        });
        return found;
    }

    /// Hangs a row, and then the best ones as long as they are wanted.
    void run(const LampRectangle& first, const Job& job) {
        place(first);
        std::vector<PlaneCandidate> tried;
        while (wants_more()) {
            const std::vector<LampRectangle> found = next(job, tried);
            if (found.empty()) return;
            place(found.front());
        }
    }
    bool has_enough() const { return field_.coverage() >= options_->enough; }
    const std::vector<LampRectangle>& rows() const { return rows_; }
    CPlane lamps(const LampRectangle& r) const {
        return r.c_plane(lamp_diameter(r.pitch()), options_->luminance);
    }
    /// Of all rows: coverage, each part by what its stripes are worth.
    double worth() const {
        double sum = 0;
        for (const LampRectangle& row : rows_) sum += row.score.objective();
        return sum;
    }

private:
    bool wants_more() const {
        return static_cast<int>(rows_.size()) < options_->planes && !has_enough();
    }
    void place(const LampRectangle& row) {
        const CPlane plane = lamps(row);
        field_.place(plane);
        placed_.push_back(oriented(plane));
        rows_.push_back(row);
    }
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

    LampField field_;
    OrientedBox body_;
    LampDemand demand_;
    const PlacementOptions* options_;
    std::vector<OrientedBox> placed_;
    std::vector<LampRectangle> rows_;
};

/// The first ones that face different ways.
std::vector<LampRectangle> beginnings(const std::vector<LampRectangle>& found) {
    constexpr std::size_t most = 4;
    constexpr double same = 0.9; // cosine
    std::vector<LampRectangle> chosen;
    for (const LampRectangle& r : found) {
        const Vec3 normal = r.frame.u.cross(r.frame.v);
        const bool is_new =
            std::none_of(chosen.begin(), chosen.end(), [&](const LampRectangle& other) {
                return normal.dot(other.frame.u.cross(other.frame.v)) > same;
            });
        if (is_new && chosen.size() < most) chosen.push_back(r);
    }
    return chosen;
}

/// The best row and what goes with it; where that is not enough, other rows may be a better begin.
RowSearch best_rows(const RowSearch& start, std::vector<PlaneCandidate>& tried, const Job& job) {
    constexpr double worth_changing = 1.05;
    RowSearch best = start;
    for (const LampRectangle& first : beginnings(start.next(job, tried))) {
        if (best.has_enough()) break;
        RowSearch search = start;
        search.run(first, job);
        if (search.worth() > worth_changing * best.worth()) best = search;
    }
    return best;
}

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
    const RowSearch start(field, body, {options.lamps, wanted, options.direction}, options);
    Placement result;
    result.rig.name = "placed";
    const RowSearch found = best_rows(start, result.candidates, job);
    for (const LampRectangle& row : found.rows()) {
        const CPlane lamps = found.lamps(row);
        field.place(lamps);
        result.planes.push_back({lamps, row.score, hit_histogram(field, lamps)});
        result.rig.sources.emplace_back(lamps);
    }
    if (result.planes.empty())
        throw Error("", "placement", "no plane around the body mirrors to the cameras");
    tell_what_is_reached(result, field, model, wanted);
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
