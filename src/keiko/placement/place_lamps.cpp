#include "keiko/placement/place_lamps.h"

#include "keiko/base/error.h"
#include "keiko/base/parallel.h"
#include "keiko/placement/bar_rows.h"
#include "keiko/placement/candidate_planes.h"
#include "keiko/placement/plane_frame.h"
#include "keiko/placement/plane_search.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace keiko {

Placement rated_rig(std::vector<ViewSample> seen, const SurfaceModel& model, int picture_height,
                    const LightRig& rig, const StripeSpacing& spacing) {
    LampField field(std::move(seen));
    if (!(field.total_weight() > 0))
        throw Error("", "placement", "no camera sees the surface that lamps are rated for");
    const StripeSpacing wanted = spacing.for_height(picture_height);
    Placement result;
    result.rig = rig;
    const std::vector<CPlane> rows = rows_of(rig, field.centroid());
    result.kind = kind_of(rig, rows);
    for (const CPlane& lamps : rows) {
        const PlaneSearch search(field, frame_of(lamps), {lamps.lamps, wanted});
        const Box2 extent{Vec2(0), Vec2(lamps.u.length(), lamps.v.length())};
        const PlacementScore score = search.rated(extent).score;
        field.place(lamps);
        result.planes.push_back({lamps, score, hit_histogram(field, lamps)});
    }
    if (result.planes.empty())
        throw Error("", "rig",
                    "it has neither tubes on a C-plane nor rectangular panels to be rated");
    tell_what_is_reached(result, field, model, wanted);
    return result;
}

namespace {

constexpr double t8_diameter = 26;                      ///< mm
constexpr double least_duty = 0.3, greatest_duty = 0.5; ///< diameter by pitch
constexpr std::size_t search_samples = 2000;

/// Rows that are placed together: one, or one and its mirror image.
struct RowGroup {
    LampRectangle first;
    std::optional<LampRectangle> image{};

    int count() const { return image ? 2 : 1; }
    double objective() const {
        return first.score.objective() + (image ? image->score.objective() : 0);
    }
    double coverage() const { return first.score.coverage + (image ? image->score.coverage : 0); }
};

/// Places rows of lamps one after the other, on a thinned field.
class RowSearch {
public:
    RowSearch(const LampField& field, const Box3& body, const LampDemand& demand,
              const PlacementOptions& options)
        : field_(field.thinned(search_samples)),
          body_(oriented(body)),
          demand_(demand),
          options_(&options) {}

    /// The best lamps for the uncovered samples on each useful plane, the best first; after the
    /// first row only those that contribute enough.
    std::vector<RowGroup> next(const Job& job, std::vector<PlaneCandidate>& tried) const {
        const std::vector<PlaneFrame> planes =
            demand_.mirror ? candidate_planes(field_, options_->where, *demand_.mirror)
                           : candidate_planes(field_, options_->where);
        std::vector<RowGroup> found(planes.size());
        parallel_for(planes.size(), job, "place", [&](std::size_t i) {
            found[i] = group_of(admitted(PlaneSearch(field_, planes[i], demand_).best()));
        });
        for (std::size_t i = 0; i < planes.size(); ++i) {
            const Vec3 offset = planes[i].origin - field_.centroid();
            tried.push_back({offset.normalized(), offset.length(), found[i].first.score});
        }
        const double least = rows_.empty() ? 0 : options_->least_gain;
        const auto left = static_cast<std::size_t>(options_->planes) - rows_.size();
        std::erase_if(found, [&](const RowGroup& group) {
            return !(group.objective() > 0) || group.coverage() < least * group.count() ||
                   static_cast<std::size_t>(group.count()) > left;
        });
        std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
            return a.objective() > b.objective();
        });
        return found;
    }

    /// Places rows, and then the best ones as long as they are wanted.
    void run(const RowGroup& first, const Job& job) {
        place(first);
        std::vector<PlaneCandidate> tried;
        while (wants_more()) {
            const std::vector<RowGroup> found = next(job, tried);
            if (found.empty()) return;
            place(found.front());
        }
    }
    bool has_enough() const { return field_.coverage() >= options_->enough; }
    const std::vector<LampRectangle>& rows() const { return rows_; }
    CPlane lamps(const LampRectangle& r) const {
        return r.c_plane(lamp_diameter(r.pitch()), options_->luminance);
    }
    /// Objective of all rows: coverage, with each part weighted by the quality of its stripes.
    double worth() const {
        double sum = 0;
        for (const LampRectangle& row : rows_) sum += row.score.objective();
        return sum;
    }

private:
    bool wants_more() const {
        return static_cast<int>(rows_.size()) < options_->planes && !has_enough();
    }
    void place(const RowGroup& group) {
        place(group.first);
        if (group.image) place(*group.image);
    }
    void place(const LampRectangle& row) {
        const CPlane plane = lamps(row);
        field_.place(plane);
        placed_.push_back(oriented(plane));
        rows_.push_back(row);
    }
    /// The row with its image, if symmetry is requested and the row is not its own image. The score
    /// of both is 0 if they intersect each other.
    RowGroup group_of(LampRectangle row) const {
        if (!demand_.mirror || row.lamps == 0 || !(row.score.objective() > 0) ||
            is_own_image(row.frame, *demand_.mirror))
            return {row};
        LampRectangle image = row;
        image.frame = image_of(row.frame, *demand_.mirror);
        if (overlap(oriented(lamps(row)), oriented(lamps(image)))) row.score = {}, image.score = {};
        if (!(row.score.objective() > 0)) return {row, image};
        LampField field = field_;
        field.place(lamps(row));
        const LampDemand demand{row.lamps, demand_.spacing, demand_.direction};
        image.score = PlaneSearch(field, image.frame, demand).rated(image.extent).score;
        return {row, image};
    }
    /// The rectangle, with a score of 0 if it intersects the body or other lamps.
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

/// The first ones that face different directions.
std::vector<RowGroup> beginnings(const std::vector<RowGroup>& found) {
    constexpr std::size_t most = 4;
    constexpr double same = 0.9; // cosine
    std::vector<RowGroup> chosen;
    for (const RowGroup& group : found) {
        const Vec3 normal = group.first.frame.normal();
        const bool is_new = std::none_of(chosen.begin(), chosen.end(), [&](const RowGroup& other) {
            return normal.dot(other.first.frame.normal()) > same;
        });
        if (is_new && chosen.size() < most) chosen.push_back(group);
    }
    return chosen;
}

/// The best row with the following ones; if they do not suffice, other rows may be a better begin.
RowSearch best_rows(const RowSearch& start, std::vector<PlaneCandidate>& tried, const Job& job) {
    constexpr double worth_changing = 1.05;
    RowSearch best = start;
    for (const RowGroup& first : beginnings(start.next(job, tried))) {
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
    const RowSearch start(field, body, {options.lamps, wanted, options.direction, options.mirror},
                          options);
    Placement result;
    result.rig.name = "placed", result.kind = options.kind, result.mirror = options.mirror;
    const RowSearch found = best_rows(start, result.candidates, job);
    for (const LampRectangle& row : found.rows()) {
        const CPlane lamps = found.lamps(row);
        field.place(lamps);
        result.planes.push_back({lamps, row.score, hit_histogram(field, lamps)});
        for (LightSource& light : lights_of(lamps, options.kind, body.center()))
            result.rig.sources.push_back(std::move(light));
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
