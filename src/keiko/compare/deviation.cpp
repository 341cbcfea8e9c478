#include "keiko/compare/deviation.h"

#include "keiko/base/parallel.h"
#include "keiko/base/units.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace keiko {
namespace {

/// A place of the body, how much of it stands for, and its nearest point of the other.
struct Sample {
    SurfacePoint point;
    double area = 0; ///< mm2
    Vec2 cell{0};    ///< extent in parameters of the piece
    SurfaceFoot foot;

    /// Positive outside the other.
    double deviation() const {
        return (point.position - foot.position).dot(foot.normal) < 0 ? -foot.distance
                                                                     : foot.distance;
    }
    bool turned() const { return point.normal.dot(foot.normal) < 0; }
    /// Degrees between the tangent planes; 0 beyond a border, where they need not agree.
    double tilt() const {
        if (foot.on_border || point.normal == Vec3(0) || foot.normal == Vec3(0)) return 0;
        const Vec3 normal = turned() ? -foot.normal : foot.normal;
        return radians_to_degrees(angle_between(point.normal, normal));
    }
};

double area_of(const SurfaceFeet& body) {
    double area = 0;
    for (std::size_t i = 0; i < body.piece_count(); ++i)
        area += body.piece_size(i).x * body.piece_size(i).y;
    return area;
}

/// The middles of a piece's cells that are material.
std::vector<Sample> spread(const SurfaceFeet& body, std::size_t piece, double spacing) {
    constexpr int least = 4, most = 256;
    const auto cells = [&](double length) {
        return static_cast<int>(
            std::clamp(std::ceil(length / spacing), double{least}, double{most}));
    };
    const Vec2 size = body.piece_size(piece);
    const int nu = cells(size.x), nv = cells(size.y);
    std::vector<Sample> samples;
    for (int i = 0; i < nu; ++i)
        for (int j = 0; j < nv; ++j) {
            const auto point = body.point(piece, {(i + 0.5) / nu, (j + 0.5) / nv});
            if (!point) continue;
            const Vec2 cell(1.0 / nu, 1.0 / nv);
            samples.push_back({*point, point->stretch * cell.x * cell.y, cell, {}});
        }
    return samples;
}

std::vector<Sample> measured_samples(const SurfaceFeet& body, const SurfaceFeet& other,
                                     const DeviationOptions& options, const Job& job) {
    const double spacing = std::sqrt(area_of(body) / static_cast<double>(options.samples));
    std::vector<std::vector<Sample>> pieces(body.piece_count());
    parallel_for(pieces.size(), job, "deviation", [&](std::size_t i) {
        pieces[i] = spread(body, i, spacing);
        for (Sample& sample : pieces[i]) sample.foot = other.foot(sample.point.position);
    });
    std::vector<Sample> all;
    for (std::vector<Sample>& piece : pieces)
        std::move(piece.begin(), piece.end(), std::back_inserter(all));
    return all;
}

/// Climbs by steps that shrink, within the piece and its material.
template <class Quantity>
Sample climbed(const SurfaceFeet& body, const SurfaceFeet& other, Sample best,
               const Quantity& quantity) {
    Vec2 step = best.cell * 0.5;
    for (int round = 0; round < 40 && step.x > best.cell.x * 1e-3; ++round) {
        bool higher = false;
        for (const Vec2& way : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
            const Vec2 uv = best.point.uv + way * step;
            if (!unit_square.contains(uv)) continue;
            const auto point = body.point(best.point.piece, uv);
            if (!point) continue;
            const Sample there{*point, best.area, best.cell, other.foot(point->position)};
            if (quantity(there) > quantity(best)) best = there, higher = true;
        }
        if (!higher) step *= 0.5;
    }
    return best;
}

/// The largest of a quantity, climbed to from the samples that have most of it.
template <class Quantity>
Sample peak(const SurfaceFeet& body, const SurfaceFeet& other, const std::vector<Sample>& samples,
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
    std::vector<Sample> tops(count);
    parallel_for(count, job, "", [&](std::size_t i) {
        tops[i] = climbed(body, other, samples[order[i]], quantity);
    });
    return *std::max_element(tops.begin(), tops.end(), [&](const Sample& a, const Sample& b) {
        return quantity(a) < quantity(b);
    });
}

void take_percentiles(const std::vector<Sample>& samples, Deviation& result) {
    std::vector<std::pair<double, double>> sizes; // distance, area
    for (const Sample& sample : samples) sizes.emplace_back(sample.foot.distance, sample.area);
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

void take_sums(const std::vector<Sample>& samples, double certainty, Deviation& result) {
    double uncertain = 0, sum = 0, squares = 0;
    for (const Sample& sample : samples) {
        const double d = sample.deviation();
        result.area += sample.area;
        sum += d * sample.area;
        squares += d * d * sample.area;
        result.lowest = std::min(result.lowest, d);
        result.highest = std::max(result.highest, d);
        if (sample.foot.certain(certainty)) continue;
        uncertain += sample.area;
        result.largest_uncertainty =
            std::max(result.largest_uncertainty, sample.foot.distance - sample.foot.nearest);
    }
    if (!(result.area > 0)) return;
    result.mean = sum / result.area;
    result.root_mean_square = std::sqrt(squares / result.area);
    result.uncertain_share = uncertain / result.area;
}

void take_faces(const std::vector<Sample>& samples, std::size_t faces, Deviation& result) {
    result.turned.assign(faces, 0);
    result.partners.assign(faces, no_index);
    std::vector<double> area(faces);
    std::vector<std::map<std::uint32_t, double>> votes(faces);
    for (const Sample& sample : samples) {
        area[sample.point.face] += sample.area;
        if (sample.turned()) result.turned[sample.point.face] += sample.area;
        votes[sample.point.face][sample.foot.face] += sample.area;
    }
    for (std::size_t f = 0; f < faces; ++f) {
        if (!(area[f] > 0)) continue;
        result.turned[f] /= area[f];
        result.partners[f] =
            std::max_element(votes[f].begin(), votes[f].end(), [](const auto& a, const auto& b) {
                return a.second < b.second;
            })->first;
    }
}

/// Where the body's borders are farthest from those of the other.
DeviationPlace worst_border(const SurfaceFeet& body, const SurfaceFeet& other, const Job& job) {
    const std::vector<BorderPoint> points = body.border_points();
    std::vector<double> distances(points.size());
    constexpr std::size_t chunk = 256;
    parallel_for((points.size() + chunk - 1) / chunk, job, "borders", [&](std::size_t c) {
        for (std::size_t i = c * chunk; i < std::min(points.size(), (c + 1) * chunk); ++i)
            distances[i] = other.border_distance(points[i].position);
    });
    DeviationPlace worst;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (distances[i] > worst.value) worst = {distances[i], points[i].position, points[i].face};
    return worst;
}

} // namespace

Deviation measure_deviation(const SurfaceFeet& body, const SurfaceFeet& other,
                            const DeviationOptions& options, const Job& job) {
    const std::vector<Sample> samples = measured_samples(body, other, options, job);
    Deviation result;
    result.samples = samples.size();
    take_faces(samples, body.body().model.faces.size(), result);
    result.worst_border = worst_border(body, other, job);
    if (samples.empty()) return result;
    take_sums(samples, options.certainty, result);
    take_percentiles(samples, result);
    const Sample far =
        peak(body, other, samples, job, [](const Sample& sample) { return sample.foot.distance; });
    result.worst = {far.deviation(), far.point.position, far.point.face};
    result.lowest = std::min(result.lowest, far.deviation());
    result.highest = std::max(result.highest, far.deviation());
    const Sample tilted =
        peak(body, other, samples, job, [](const Sample& sample) { return sample.tilt(); });
    result.worst_normal = {tilted.tilt(), tilted.point.position, tilted.point.face};
    return result;
}

} // namespace keiko
