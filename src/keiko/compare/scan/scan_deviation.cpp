#include "keiko/compare/scan/scan_deviation.h"

#include "keiko/base/parallel.h"
#include "keiko/compare/alignment/closest_point_walk.h"
#include "keiko/compare/scan/point_order.h"
#include "keiko/film/signed_color_picture.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// mm: in what direction a point lies is not asked nearer than this.
constexpr double noise = 1e-4;

/// Whether the nearest point lies on a border of its face, and none of another face is near.
bool is_at_free_border(const ClosestPointQuery& nominal, const ClosestSurfacePoint& foot,
                       double join) {
    constexpr double there = 1e-3; // mm: a border is found from its curve, not from the surface
    const auto own = [&](std::uint32_t face) { return face == foot.face; };
    const auto other = [&](std::uint32_t face) { return face != foot.face; };
    return (foot.on_border || nominal.border_foot(foot.position, there, own)) &&
           !nominal.border_foot(foot.position, join, other);
}

PointDeviation deviation_of(const Vec3& place, const std::optional<ClosestSurfacePoint>& foot,
                            const ClosestPointQuery& nominal, const ScanOptions& options) {
    if (!foot) return {.distance = std::numeric_limits<double>::infinity()};
    return {
        .distance = foot->signed_distance(place),
        .closest = foot->position,
        .face = foot->face,
        .beside = foot->is_beside(place, noise) && is_at_free_border(nominal, *foot, options.join),
        .certain = foot->certain(options.certainty)};
}

/// The size that this share of ascending sizes does not exceed.
double percentile(const std::vector<double>& sizes, double share) {
    const auto rank =
        static_cast<std::size_t>(std::ceil(share * static_cast<double>(sizes.size())));
    return sizes[std::clamp<std::size_t>(rank, 1, sizes.size()) - 1];
}

/// Bins as wide as a fifth of the tolerance, so that it is an edge of two of them, or else as a
/// tenth of what most points do not exceed.
DeviationHistogram histogram_of(std::span<const PointDeviation> points, double most,
                                std::optional<double> tolerance) {
    constexpr double least = 1e-9; // mm
    constexpr double most_bins = 30;
    const double spread = std::max({most, tolerance.value_or(0), least});
    const double wide = round_scale(spread) / 10;
    const double fifth = tolerance.value_or(0) / 5;
    const double width = fifth > 0 && spread <= most_bins * fifth ? fifth : wide;
    const auto half = static_cast<std::size_t>(std::ceil(spread / width * (1 - 1e-9)));
    DeviationHistogram histogram{width, -width * static_cast<double>(half),
                                 std::vector<std::size_t>(2 * half)};
    for (const PointDeviation& point : points) {
        if (!point.is_measured()) continue;
        const double bin = std::floor((point.distance - histogram.lowest) / width);
        const double last = static_cast<double>(2 * half - 1);
        ++histogram.counts[static_cast<std::size_t>(std::clamp(bin, 0.0, last))];
    }
    return histogram;
}

/// Sums of signed distances.
struct Sums {
    std::size_t count = 0;
    double sum = 0, squares = 0;

    void add(double d) { ++count, sum += d, squares += d * d; }
    double mean() const { return count > 0 ? sum / static_cast<double>(count) : 0; }
    double mean_square() const { return count > 0 ? squares / static_cast<double>(count) : 0; }
};

std::vector<ScannedFace> scanned_faces(std::span<const PointDeviation> points, std::size_t count,
                                       std::optional<double> tolerance) {
    std::vector<ScannedFace> faces(count);
    std::vector<Sums> sums(count);
    for (const PointDeviation& point : points) {
        if (!point.is_measured()) continue;
        ScannedFace& face = faces[point.face];
        const double d = point.distance;
        face.lowest = face.points == 0 ? d : std::min(face.lowest, d);
        face.highest = face.points == 0 ? d : std::max(face.highest, d);
        ++face.points, face.within += tolerance && std::abs(d) <= *tolerance;
        sums[point.face].add(d);
    }
    for (std::size_t f = 0; f < count; ++f) {
        faces[f].mean = sums[f].mean();
        faces[f].root_mean_square = std::sqrt(sums[f].mean_square());
    }
    return faces;
}

/// Counts of the points, and the lowest and the highest of them.
void take_counts(std::span<const PointDeviation> points, std::optional<double> tolerance,
                 ScanDeviation& result) {
    std::size_t within = 0;
    for (const PointDeviation& point : points) {
        result.beside += point.beside;
        result.beyond += point.face == no_index;
        if (!point.is_measured()) continue;
        const DeviationPlace there{point.distance, point.closest, point.face};
        if (result.measured == 0 || there.value < result.lowest.value) result.lowest = there;
        if (result.measured == 0 || there.value > result.highest.value) result.highest = there;
        ++result.measured, result.uncertain += !point.certain;
        within += tolerance && std::abs(point.distance) <= *tolerance;
    }
    const std::size_t judged = result.measured + result.beyond;
    if (tolerance && judged > 0)
        result.within = static_cast<double>(within) / static_cast<double>(judged);
}

} // namespace

std::vector<PointDeviation> point_deviations(std::span<const Vec3> points, const Affine& motion,
                                             const ClosestPointQuery& nominal,
                                             const ScanOptions& options, const Job& job) {
    constexpr std::size_t chunk = 1024;
    const std::vector<std::uint32_t> order = neighbour_order(points);
    std::vector<PointDeviation> found(points.size());
    parallel_for((points.size() + chunk - 1) / chunk, job, "deviation", [&](std::size_t c) {
        ClosestPointWalk walk(nominal, options.reach);
        for (std::size_t k = c * chunk; k < std::min(points.size(), (c + 1) * chunk); ++k) {
            const Vec3 place = motion.point(points[order[k]]);
            found[order[k]] = deviation_of(place, walk.next(place), nominal, options);
        }
    });
    return found;
}

ScanDeviation scan_deviation(std::span<const PointDeviation> points, std::size_t faces,
                             std::optional<double> tolerance) {
    ScanDeviation result;
    result.points = points.size();
    take_counts(points, tolerance, result);
    result.faces = scanned_faces(points, faces, tolerance);
    if (result.measured == 0) return result;
    Sums sums, about_mean;
    std::vector<double> sizes;
    for (const PointDeviation& point : points)
        if (point.is_measured())
            sums.add(point.distance), sizes.push_back(std::abs(point.distance));
    for (const PointDeviation& point : points)
        if (point.is_measured()) about_mean.add(point.distance - sums.mean());
    result.mean = sums.mean(), result.root_mean_square = std::sqrt(sums.mean_square());
    result.standard_deviation = std::sqrt(about_mean.mean_square());
    std::sort(sizes.begin(), sizes.end());
    result.median = percentile(sizes, 0.5), result.percent_90 = percentile(sizes, 0.9);
    result.percent_99 = percentile(sizes, 0.99), result.percent_99_9 = percentile(sizes, 0.999);
    result.histogram = histogram_of(points, result.percent_99_9, tolerance);
    return result;
}

} // namespace keiko
