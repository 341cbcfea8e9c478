#include "keiko/inspect/overlaps/overlap.h"

#include "keiko/base/parallel.h"
#include "keiko/base/units.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/inspect/overlaps/edge_samples.h"
#include "keiko/inspect/overlaps/face_approach.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <utility>

namespace keiko {
namespace {

/// The border curves of a model by their placed faces. Keeps a reference to `curves`.
class FaceBorders {
public:
    explicit FaceBorders(const BoundaryCurves& curves);

    /// The borders of a placed face, to `border_error`; empty if it has none.
    std::vector<CurvePolyline> polylines(const PlacedFace& face) const;

    static constexpr double border_error = 0.01; ///< mm

private:
    const BoundaryCurves& curves_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<BoundaryInterval>> borders_;
};

FaceBorders::FaceBorders(const BoundaryCurves& curves) : curves_(curves) {
    for (const BoundaryInterval& border : curves.all())
        borders_[{border.instance, border.face}].push_back(border);
}

std::vector<CurvePolyline> FaceBorders::polylines(const PlacedFace& face) const {
    std::vector<CurvePolyline> lines;
    const auto found = borders_.find({face.instance, face.face});
    if (found == borders_.end()) return lines;
    for (const BoundaryInterval& border : found->second)
        lines.push_back(make_polyline(curves_.curve(border), border_error));
    return lines;
}

/// mm from a place to the nearest of some lines; infinity if there are none.
double distance_to(const std::vector<CurvePolyline>& lines, const Vec3& place) {
    double least = std::numeric_limits<double>::infinity();
    for (const CurvePolyline& line : lines) least = std::min(least, line.distance(place));
    return least;
}

/// Least angle, degrees, between a face and one that it stands on.
constexpr double tee_angle = 30;
/// Largest break between parts of one run, in join distances.
constexpr double longest_break = 4;

using Approaches = std::span<const FaceApproach>;

double sample_step(const OverlapLimits& limits) {
    return std::min(limits.join / 4, limits.negligible);
}

/// Groups approaches to one face by run.
std::vector<Approaches> runs_of(Approaches all, const FreeEdgeSamples& samples, double join) {
    std::vector<Approaches> runs;
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= all.size(); ++i) {
        const bool goes_on =
            i < all.size() &&
            samples.edge_of(all[i].sample) == samples.edge_of(all[i - 1].sample) &&
            samples.way(all[i].sample) - samples.way(all[i - 1].sample) <= longest_break * join;
        if (goes_on) continue;
        runs.push_back(all.subspan(begin, i - begin));
        begin = i;
    }
    return runs;
}

/// Extent of one run along the face.
struct Extent {
    double length = 0, bound = 0, distance = 0; ///< mm
};

Extent extent_of(Approaches run, const FreeEdgeSamples& samples, double step) {
    Extent extent;
    for (std::size_t i = 0; i < run.size(); ++i) {
        if (!run[i].along) continue;
        extent.distance = std::max(extent.distance, std::abs(run[i].offset));
        const bool goes_on = i > 0 && run[i - 1].along && run[i - 1].sample + 1 == run[i].sample;
        if (goes_on)
            extent.length += samples.way(run[i].sample) - samples.way(run[i - 1].sample);
        else
            extent.bound += 2 * step;
    }
    return extent;
}

bool is_crossing(Approaches run, double join) {
    const auto [low, high] = std::minmax_element(
        run.begin(), run.end(),
        [](const FaceApproach& a, const FaceApproach& b) { return a.offset < b.offset; });
    return low->offset < -join / 2 && high->offset > join / 2;
}

class OverlapSearch {
public:
    OverlapSearch(const BoundaryCurves& curves, const FreeEdgeSamples& samples,
                  const OverlapLimits& limits)
        : curves_(curves), samples_(samples), limits_(limits), borders_(curves) {}

    /// The overlaps that the samples near the face `on` form.
    std::vector<Overlap> overlaps(const PlacedFace& on, Approaches near) const {
        std::vector<Overlap> found;
        std::vector<CurvePolyline> borders;
        for (const Approaches run : runs_of(near, samples_, limits_.join)) {
            const Extent extent = extent_of(run, samples_, sample_step(limits_));
            const bool crossing = is_crossing(run, limits_.join);
            if (!crossing && extent.length <= limits_.negligible) continue;
            if (borders.empty()) borders = borders_.polylines(on);
            found.push_back(overlap(on, run, extent, borders, crossing));
        }
        return found;
    }

private:
    Overlap overlap(const PlacedFace& on, Approaches run, const Extent& extent,
                    const std::vector<CurvePolyline>& borders, bool crossing) const {
        Overlap found{.length = extent.length, .length_bound = extent.bound};
        constexpr double rounding = 1e-9; // mm
        found.distance = extent.distance > rounding ? extent.distance : 0;
        if (crossing)
            found.length = samples_.way(run.back().sample) - samples_.way(run.front().sample);
        const FaceApproach& deepest =
            crossing ? nearest_of(run) : deepest_of(run, borders, found.depth);
        const FreePlace place = samples_.place(deepest.sample);
        const FreeEdge& edge = samples_.edges().all[place.edge];
        found.sides = {edge.face(), on};
        found.place = place.position;
        if (const auto frame = curves_.curve(edge.pieces[place.piece]).frame(place.t)) {
            const double cosine = std::abs(frame->normal.dot(deepest.normal));
            const double sine = frame->normal.cross(deepest.normal).length();
            found.angle = radians_to_degrees(std::atan2(sine, cosine));
        }
        found.kind = crossing                   ? Overlap::Kind::crossing
                     : found.angle >= tee_angle ? Overlap::Kind::tee
                                                : Overlap::Kind::lap;
        return found;
    }

    static const FaceApproach& nearest_of(Approaches run) {
        return *std::min_element(run.begin(), run.end(),
                                 [](const FaceApproach& a, const FaceApproach& b) {
                                     return std::abs(a.offset) < std::abs(b.offset);
                                 });
    }

    /// The deepest approach of a run along the face; `depth`: its distance to the borders.
    static const FaceApproach& deepest_of(Approaches run, const std::vector<CurvePolyline>& borders,
                                          double& depth) {
        constexpr std::size_t most_tried = 64;
        const std::size_t stride = 1 + run.size() / most_tried;
        const FaceApproach* deepest = nullptr;
        const auto try_each = [&](std::size_t begin, std::size_t end, std::size_t step) {
            for (std::size_t i = begin; i < end; i += step) {
                if (!run[i].along) continue;
                const double here = distance_to(borders, run[i].foot);
                if (deepest == nullptr || here > depth) depth = here, deepest = &run[i];
            }
        };
        try_each(0, run.size(), stride);
        if (deepest == nullptr) try_each(0, run.size(), 1);
        const auto coarse = static_cast<std::size_t>(deepest - run.data());
        try_each(coarse - std::min(coarse, stride), std::min(coarse + stride, run.size()), 1);
        return *deepest;
    }

    const BoundaryCurves& curves_;
    const FreeEdgeSamples& samples_;
    const OverlapLimits& limits_;
    FaceBorders borders_;
};

} // namespace

std::vector<Overlap> find_overlaps(const SurfaceModel& model, const BoundaryCurves& curves,
                                   const FreeEdges& edges, const OverlapLimits& limits,
                                   const Job& job) {
    const FreeEdgeSamples samples(edges, sample_step(limits));
    const std::vector<PlacedFace> faces = placed_faces(model);
    const OverlapSearch search(curves, samples, limits);
    std::vector<std::vector<Overlap>> found(faces.size());
    parallel_for(faces.size(), job, "", [&](std::size_t i) {
        const PlacedFace& on = faces[i];
        found[i] = search.overlaps(on, approaches_to(model, on, samples, limits.join));
    });
    std::vector<Overlap> all;
    for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
    return all;
}

} // namespace keiko
