#include "keiko/geometry/seam/seam_gap.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/math/quadrature.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace keiko {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Shares of the part's size. Smaller gaps than the first need no table; wider ones than the second
/// are not sealed against the file's claim. The others are the gap that approximation leaves open
/// between borders that meet, and the one that rounding leaves.
constexpr double smallest_gap = 1e-7, widest_surprise = 1e-5, least_width = 1e-8, rounding = 1e-10;
constexpr double spare_width = 1.5;
constexpr int fine_steps = 16;
/// Chord error of the curves on which the nearest place of a border is searched, as a share of the
/// part's size.
constexpr double chord_error = 1e-3;
/// First places at which a gap is measured. They are not at equal steps: p-curves are often
/// interpolated at such, and meet the neighbour there and only there.
const std::vector<double>& first_places() {
    static const std::vector<double> places = [] {
        std::vector<double> t{0, 1};
        for (const QuadratureNode& node : gauss_legendre(7)) t.push_back((1 + node.x) / 2);
        return t;
    }();
    return places;
}

std::vector<double> equal_steps(int steps) {
    std::vector<double> t;
    for (int i = 0; i <= steps; ++i) t.push_back(double(i) / steps);
    return t;
}

/// Measures the distance from one border to another.
class GapMeter {
public:
    GapMeter(const SurfaceModel& model, const std::vector<double>& sizes, const Job& job)
        : model_(model), grids_(model.faces.size()), coarse_(model.trim_curves.size()) {
        parallel_for(model.faces.size(), job, "",
                     [&](std::size_t f) { sample(f, chord_error * sizes[model_.faces[f].part]); });
    }

    std::vector<SeamGap::Sample> measure(const EdgeUse& from, std::uint32_t curve,
                                         const std::vector<double>& places,
                                         const EdgeUse& to) const {
        const SurfaceCurve border = surface_curve(from.face, curve);
        std::vector<SeamGap::Sample> samples;
        for (const double t : places) {
            const Vec3 p = border.at(t).position;
            samples.push_back({p, nearest(p, to) - p});
        }
        return samples;
    }

private:
    void sample(std::size_t f, double chord) {
        const Face& face = model_.faces[f];
        grids_[f].emplace(model_, face);
        for (const TrimLoop& loop : model_.loops_of(face))
            for (std::uint32_t c = loop.first_curve; c < loop.first_curve + loop.curve_count; ++c)
                coarse_[c] = make_polyline(surface_curve(static_cast<std::uint32_t>(f), c), chord);
    }

    SurfaceCurve surface_curve(std::uint32_t face, std::uint32_t curve) const {
        return {model_, *grids_[face], in_part_, model_.trim_curve(curve), true};
    }

    /// The nearest place by Newton's iteration on the curve whose polyline is nearest, and on the
    /// next, which may be nearer yet.
    Vec3 nearest(const Vec3& p, const EdgeUse& use) const {
        struct Candidate {
            double distance = infinity;
            std::uint32_t curve = no_index;
        } first, second;
        for (std::uint32_t c = use.first_curve; c < use.first_curve + use.curve_count; ++c) {
            const double distance = coarse_[c].distance(p);
            if (distance < first.distance)
                second = first, first = {distance, c};
            else if (distance < second.distance)
                second = {distance, c};
        }
        double least = infinity;
        Vec3 best = p;
        for (const Candidate& each : {first, second}) {
            if (each.curve == no_index) continue;
            const ClosestPoint foot = closest_point(surface_curve(use.face, each.curve), p,
                                                    coarse_[each.curve].nearest(p));
            if (foot.distance < least) least = foot.distance, best = foot.point.position;
        }
        return best;
    }

    const SurfaceModel& model_;
    const Affine in_part_{};
    std::vector<std::optional<PatchGrid>> grids_; ///< a face
    std::vector<CurvePolyline> coarse_;           ///< a trim curve
};

double widest(const std::vector<SeamGap::Sample>& samples) {
    double gap = 0;
    for (const SeamGap::Sample& s : samples) gap = std::max(gap, s.across.length());
    return gap;
}

/// Size of each part, mm.
std::vector<double> part_sizes(const SurfaceModel& model) {
    std::vector<double> sizes;
    for (const Part& part : model.parts) {
        Box3 box;
        for (std::uint32_t f = part.first_face; f < part.first_face + part.face_count; ++f)
            for (std::uint32_t p = 0; p < model.faces[f].patch_count; ++p)
                box.extend(hull_bounds(model.patch(model.faces[f].first_patch + p)));
        sizes.push_back(box.size());
    }
    return sizes;
}

/// The gap of one curve of the use `own` of an edge.
SeamGap seam_gap(const GapMeter& meter, const std::vector<EdgeUse>& uses, std::size_t own,
                 std::uint32_t curve, double claimed, double join, double size) {
    SeamGap gap{.width = claimed, .touch = rounding * size, .samples = {}};
    if (uses.size() != 2) return gap;
    const EdgeUse& other = uses[1 - own];
    const double found = widest(meter.measure(uses[own], curve, first_places(), other));
    if (found > smallest_gap * size && found <= join)
        gap.samples = meter.measure(uses[own], curve, equal_steps(fine_steps), other);
    // A table that misses a gap found at the first places is discarded.
    if (widest(gap.samples) < found / 2) gap.samples.clear();
    if (found <= std::max(claimed, widest_surprise * size))
        gap.width = spare_width * std::max(found, widest(gap.samples)) + least_width * size;
    return gap;
}

/// Error of a straight line between the samples at an interval's ends, times two, by the second
/// differences of the samples at either end.
double bend(const std::vector<SeamGap::Sample>& samples, std::size_t interval) {
    double most = 0;
    for (std::size_t i = std::max<std::size_t>(interval, 1);
         i <= std::min(interval + 1, samples.size() - 2); ++i) {
        const Vec3 second = samples[i - 1].across - samples[i].across * 2 + samples[i + 1].across;
        most = std::max(most, second.length());
    }
    return most / 4;
}

} // namespace

bool SeamGap::holds(double t, const Vec3& off, const Vec3& direction) const {
    const double seen = (off - direction * off.dot(direction)).length();
    if (seen <= touch) return true;
    if (seen > width) return false;
    if (samples.empty() || !(t > 0 && t < 1)) return true;
    const double place = t * static_cast<double>(samples.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(place), samples.size() - 2);
    const double share = place - static_cast<double>(i);
    const Vec3 run = samples[i + 1].border - samples[i].border;
    const Vec3 side = run.cross(direction);
    // Viewed end-on the border has no sides.
    constexpr double least_sine = 1e-3;
    if (!(side.length() > least_sine * run.length())) return true;
    const Vec3 outward = side.normalized() * (off.dot(side) < 0 ? -1 : 1);
    const Vec3 across = samples[i].across * (1 - share) + samples[i + 1].across * share;
    return off.dot(outward) <= across.dot(outward) + touch + bend(samples, i);
}

std::vector<SeamGap> seam_gaps(const SurfaceModel& model, double join, const Job& job) {
    const std::vector<double> sizes = part_sizes(model);
    const auto uses = edge_uses(model);
    const GapMeter meter(model, sizes, job);
    std::vector<SeamGap> gaps(model.trim_curves.size());
    parallel_for(uses.size(), job, "", [&](std::size_t e) {
        const double claimed = std::min(model.edges[e].tolerance, join);
        for (std::size_t u = 0; u < uses[e].size(); ++u)
            for (std::uint32_t i = 0; i < uses[e][u].curve_count; ++i) {
                const std::uint32_t curve = uses[e][u].first_curve + i;
                const double size = sizes[model.faces[uses[e][u].face].part];
                gaps[curve] = seam_gap(meter, uses[e], u, curve, claimed, join, size);
                gaps[curve].width = std::min(gaps[curve].width, join);
            }
    });
    return gaps;
}

} // namespace keiko
