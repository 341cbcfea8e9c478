#include "keiko/compare/shape/deviation.h"

#include "keiko/base/parallel.h"
#include "keiko/base/units.h"
#include "keiko/compare/alignment/coarse_alignment.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <span>

namespace keiko {
namespace {

/// A place of the body and its nearest point of the other.
struct DeviationSample : SurfaceSample {
    std::optional<ClosestSurfacePoint> foot; ///< nothing: beyond reach

    double distance() const {
        return foot ? foot->distance : std::numeric_limits<double>::infinity();
    }
    /// Positive outside the other.
    double deviation() const { return foot ? foot->signed_distance(point.position) : distance(); }
    /// Whether the nearest point lies aside rather than above or below.
    bool beside(double noise) const { return foot && foot->is_beside(point.position, noise); }
    bool turned() const { return foot && point.normal.dot(foot->normal) < 0; }
    /// Degrees between the tangent planes; 0 beyond a border, where they need not agree.
    double tilt() const {
        if (!foot || foot->on_border || point.normal == Vec3(0) || foot->normal == Vec3(0))
            return 0;
        const Vec3 normal = turned() ? -foot->normal : foot->normal;
        return radians_to_degrees(angle_between(point.normal, normal));
    }
};

/// Sums over the samples of a face.
struct FaceSums {
    FaceDeviation face;
    double turned = 0, beyond = 0, beside = 0, squares = 0;
    std::map<std::uint32_t, double> votes; ///< area by the other's face

    void add(const DeviationSample& sample, double noise) {
        face.area += sample.area;
        const double d = sample.deviation();
        if (std::abs(d) > std::abs(face.worst.value))
            face.worst = {d, sample.point.position, sample.point.face};
        if (!sample.foot) {
            beyond += sample.area;
            return;
        }
        if (sample.turned()) turned += sample.area;
        if (sample.beside(noise)) beside += sample.area;
        squares += d * d * sample.area;
        votes[sample.foot->face] += sample.area;
    }
    FaceDeviation result() const {
        FaceDeviation all = face;
        if (!(face.area > 0)) return all;
        all.turned = turned / face.area, all.beyond = beyond / face.area;
        all.beside = beside / face.area;
        if (votes.empty()) return all;
        all.root_mean_square = std::sqrt(squares / (face.area - beyond));
        all.partner =
            std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) {
                return a.second < b.second;
            })->first;
        return all;
    }
};

/// Deviation of each of `faces` faces from the other body, by its samples. The direction in which
/// the other lies is not computed nearer than `noise` mm.
std::vector<FaceDeviation> face_deviations(std::span<const DeviationSample> samples,
                                           std::size_t faces, double noise) {
    std::vector<FaceSums> sums(faces);
    for (const DeviationSample& sample : samples) sums[sample.point.face].add(sample, noise);
    std::vector<FaceDeviation> all;
    for (const FaceSums& face : sums) all.push_back(face.result());
    return all;
}

/// Places of the body until one of them is not `wanted`; all, where all are.
template <class Wanted>
std::vector<DeviationSample> measured_samples(const ClosestPointQuery& body,
                                              const ClosestPointQuery& other,
                                              const DeviationOptions& options, const Job& job,
                                              const Wanted& wanted) {
    constexpr int least = 4;
    const double spacing = sample_spacing(body, options.samples);
    std::vector<std::vector<DeviationSample>> pieces(body.piece_count());
    std::atomic<bool> go_on{true};
    parallel_for(pieces.size(), job, "deviation", [&](std::size_t i) {
        if (!go_on) return;
        for (const SurfaceSample& sample : piece_samples(body, i, spacing, least)) {
            pieces[i].push_back({sample, other.foot(sample.point.position, options.reach)});
            if (!wanted(pieces[i].back())) go_on = false;
            if (!go_on) return;
        }
    });
    std::vector<DeviationSample> all;
    for (std::vector<DeviationSample>& piece : pieces)
        std::move(piece.begin(), piece.end(), std::back_inserter(all));
    return all;
}

/// Climbs by steps that shrink, within the piece and its material.
template <class Quantity>
DeviationSample climbed(const ClosestPointQuery& body, const ClosestPointQuery& other, double reach,
                        DeviationSample best, const Quantity& quantity) {
    Vec2 step = best.cell * 0.5;
    for (int round = 0; round < 40 && step.x > best.cell.x * 1e-3; ++round) {
        bool higher = false;
        for (const Vec2& way : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
            const Vec2 uv = best.point.uv + way * step;
            if (!unit_square.contains(uv)) continue;
            const auto point = body.point(best.point.piece, uv);
            if (!point) continue;
            const DeviationSample there{{*point, best.area, best.cell},
                                        other.foot(point->position, reach)};
            if (quantity(there) > quantity(best)) best = there, higher = true;
        }
        if (!higher) step *= 0.5;
    }
    return best;
}

/// Places where a quantity is largest, climbed to from the samples that have most of it; the
/// largest first.
template <class Quantity>
std::vector<DeviationSample> peaks(const ClosestPointQuery& body, const ClosestPointQuery& other,
                                   double reach, const std::vector<DeviationSample>& samples,
                                   const Job& job, const Quantity& quantity) {
    constexpr std::size_t starts = 16;
    std::vector<std::size_t> order(samples.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const std::size_t count = std::min(starts, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count),
                      order.end(), [&](std::size_t a, std::size_t b) {
                          const double x = quantity(samples[a]), y = quantity(samples[b]);
                          return x != y ? x > y : a < b;
                      });
    std::vector<DeviationSample> tops(count);
    parallel_for(count, job, "", [&](std::size_t i) {
        tops[i] = climbed(body, other, reach, samples[order[i]], quantity);
    });
    std::stable_sort(tops.begin(), tops.end(),
                     [&](const DeviationSample& a, const DeviationSample& b) {
                         return quantity(a) > quantity(b);
                     });
    return tops;
}

void take_percentiles(const std::vector<DeviationSample>& samples, Deviation& result) {
    std::vector<std::pair<double, double>> sizes; // distance, area
    for (const DeviationSample& sample : samples)
        sizes.emplace_back(sample.distance(), sample.area);
    std::sort(sizes.begin(), sizes.end());
    double below = 0;
    const std::array<std::pair<double, double*>, 4> wanted{{{0.5, &result.median},
                                                            {0.9, &result.percent_90},
                                                            {0.99, &result.percent_99},
                                                            {0.999, &result.percent_99_9}}};
    auto next = wanted.begin();
    for (const auto& [distance, area] : sizes) {
        below += area;
        for (; next != wanted.end() && below >= next->first * result.area; ++next)
            *next->second = distance;
    }
}

void take_sums(const std::vector<DeviationSample>& samples, double certainty, Deviation& result) {
    double uncertain = 0, beyond = 0, sum = 0, squares = 0;
    for (const DeviationSample& sample : samples) {
        result.area += sample.area;
        if (!sample.foot) {
            beyond += sample.area;
            continue;
        }
        const double d = sample.deviation();
        sum += d * sample.area;
        squares += d * d * sample.area;
        result.lowest = std::min(result.lowest, d);
        result.highest = std::max(result.highest, d);
        if (sample.foot->certain(certainty)) continue;
        uncertain += sample.area;
        result.largest_uncertainty =
            std::max(result.largest_uncertainty, sample.foot->distance - sample.foot->nearest);
    }
    if (!(result.area > 0)) return;
    result.beyond = beyond / result.area;
    result.uncertain_share = uncertain / result.area;
    if (!(result.area > beyond)) return;
    result.mean = sum / (result.area - beyond);
    result.root_mean_square = std::sqrt(squares / (result.area - beyond));
}

double distance_of(const DeviationSample& sample) {
    return sample.distance();
}

DeviationPlace place_of(const DeviationSample& sample) {
    return {sample.deviation(), sample.point.position, sample.point.face};
}

/// The peaks of the distance, the largest first: of the whole and of their faces.
void take_peaks(const std::vector<DeviationSample>& peaks, Deviation& result) {
    result.worst = place_of(peaks.front());
    for (const DeviationSample& peak : peaks) {
        const DeviationPlace there = place_of(peak);
        DeviationPlace& of_face = result.faces[there.face].worst;
        if (std::abs(there.value) > std::abs(of_face.value)) of_face = there;
        if (!peak.foot) continue;
        result.lowest = std::min(result.lowest, there.value);
        result.highest = std::max(result.highest, there.value);
    }
}

/// Whether the nearest point may as well be that of a neighbouring face, with another normal.
bool at_border(const ClosestPointQuery& other, const DeviationSample& sample) {
    constexpr double there = 1e-3; // mm
    return sample.foot && sample.tilt() > 0 &&
           other.border_distance(sample.foot->position, there) < there;
}

/// Finds where the body's borders are farthest from those of the other.
void take_borders(const ClosestPointQuery& body, const ClosestPointQuery& other, const Job& job,
                  Deviation& result) {
    const std::vector<BorderPoint> points = body.border_points();
    std::vector<double> distances(points.size());
    constexpr std::size_t chunk = 256;
    parallel_for((points.size() + chunk - 1) / chunk, job, "borders", [&](std::size_t c) {
        for (std::size_t i = c * chunk; i < std::min(points.size(), (c + 1) * chunk); ++i)
            distances[i] = other.border_distance(points[i].position, result.reach);
    });
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (distances[i] <= result.worst_border.value) continue;
        result.worst_border = {distances[i], points[i].position, points[i].face};
        result.claimed_border = points[i].claimed;
    }
}

} // namespace

Deviation measure_deviation(const ClosestPointQuery& body, const ClosestPointQuery& other,
                            const DeviationOptions& options, const Job& job) {
    const std::vector<DeviationSample> samples =
        measured_samples(body, other, options, job, [](const DeviationSample&) { return true; });
    Deviation result;
    result.samples = samples.size(), result.reach = options.reach;
    result.faces = face_deviations(samples, body.body().model.faces.size(), options.noise);
    take_borders(body, other, job, result);
    if (samples.empty()) return result;
    take_sums(samples, options.certainty, result);
    take_percentiles(samples, result);
    take_peaks(peaks(body, other, options.reach, samples, job, distance_of), result);
    const auto tilt = [&](const DeviationSample& sample) {
        return at_border(other, sample) ? 0 : sample.tilt();
    };
    const DeviationSample tilted = peaks(body, other, options.reach, samples, job, tilt).front();
    result.worst_normal = {tilted.tilt(), tilted.point.position, tilted.point.face};
    return result;
}

bool lies_within_reach(const ClosestPointQuery& body, const ClosestPointQuery& other,
                       const DeviationOptions& options, const Job& job) {
    const auto within = [](const DeviationSample& sample) { return sample.foot.has_value(); };
    const std::vector<DeviationSample> samples =
        measured_samples(body, other, options, job, within);
    if (!std::all_of(samples.begin(), samples.end(), within)) return false;
    const auto tops = peaks(body, other, options.reach, samples, job, distance_of);
    return std::all_of(tops.begin(), tops.end(), within);
}

} // namespace keiko
