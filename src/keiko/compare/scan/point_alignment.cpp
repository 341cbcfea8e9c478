#include "keiko/compare/scan/point_alignment.h"

#include "keiko/base/error.h"
#include "keiko/base/parallel.h"
#include "keiko/compare/alignment/closest_point_walk.h"
#include "keiko/compare/alignment/coarse_alignment.h"
#include "keiko/compare/alignment/rigid_step.h"
#include "keiko/compare/scan/point_order.h"
#include "keiko/geometry/trim/material_bounds.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Two for each unknown of a rigid motion, so that the residual says something.
constexpr std::size_t least_points = 12;
/// Share of the trace of the normal matrix below which a motion is free. It changes distances by
/// about a thousandth of its length: a deviation of 0.03 mm could move the scan by 30 mm.
constexpr double free_share = 1e-6;
/// Share of the points that the search for a start is made by.
constexpr double trimmed_share = 0.7;

/// Points at equal steps through all of them, `most` of them at most, as neighbours follow.
std::vector<Vec3> sample_of(std::span<const Vec3> points, std::size_t most) {
    const std::size_t step =
        std::max<std::size_t>(1, (points.size() + most - 1) / std::max<std::size_t>(most, 1));
    std::vector<Vec3> some, ordered;
    for (std::size_t i = 0; i < points.size(); i += step) some.push_back(points[i]);
    for (const std::uint32_t i : neighbour_order(some)) ordered.push_back(some[i]);
    return ordered;
}

/// A point before the surface that it is pulled to.
struct Pull {
    double distance = 0; ///< mm, signed along the normal
    Vec3 normal{0};      ///< unit; 0 for a point that holds nothing

    bool holds() const { return normal != Vec3(0); }
};

Pull pull_of(const std::optional<ClosestSurfacePoint>& foot, const Vec3& place) {
    constexpr double rounding = 1e-6; // mm: nearer points have no direction
    if (!foot || foot->on_border || foot->is_beside(place, rounding)) return {};
    return {(place - foot->position).dot(foot->normal), foot->normal};
}

/// The scan before the surface at one motion.
struct Fit {
    Affine motion;
    RigidStep step;         ///< of the weighted distances
    double deviation = 0;   ///< mm, robust standard deviation of the distances
    double residual = 0;    ///< mm, root mean square distance of the points used
    std::size_t used = 0;   ///< points of a weight above 0
    bool converged = false; ///< the next step is rounding, or nothing beside the deviation
};

/// The standard deviation of a normal distribution whose median size this is.
double robust_deviation(std::span<const Pull> pulls) {
    constexpr double of_median = 1.4826;
    std::vector<double> sizes;
    for (const Pull& pull : pulls)
        if (pull.holds()) sizes.push_back(std::abs(pull.distance));
    if (sizes.empty()) return 0;
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return of_median * *middle;
}

/// Tukey's biweight of each point.
std::vector<double> weights_of(std::span<const Pull> pulls, double deviation) {
    constexpr double cut = 4.685;  // 95 % efficient for normal deviations
    constexpr double least = 1e-6; // mm: exact points have no deviation but rounding
    std::vector<double> weights;
    for (const Pull& pull : pulls) {
        const double x = pull.distance / (cut * std::max(deviation, least));
        weights.push_back(pull.holds() && std::abs(x) < 1 ? (1 - x * x) * (1 - x * x) : 0);
    }
    return weights;
}

/// A step about the centre of the points used, with their radius of gyration as the length of a
/// turn. Throws FieldError if they are too few.
RigidStep centred_step(std::span<const Vec3> places, std::span<const double> weights) {
    Vec3 centre(0);
    double square = 0, used = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (weights[i] > 0) centre += places[i], ++used;
    if (used < least_points)
        throw FieldError("points", "only " + std::to_string(static_cast<int>(used)) + " of " +
                                       std::to_string(places.size()) +
                                       " lie near the surface: too few to align by");
    centre /= used;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (weights[i] > 0) square += (places[i] - centre).length2();
    constexpr double least = 1e-9; // mm: points in one place turn about nothing
    return {centre, std::max(std::sqrt(square / used), least)};
}

/// Iterates from a start to the best motion of the points.
class PointFit {
public:
    PointFit(std::vector<Vec3> points, const ClosestPointQuery& nominal, int most_steps,
             const Job& job)
        : points_(std::move(points)),
          nominal_(nominal),
          size_(material_bounds(nominal.body().model, job).size()),
          left_(most_steps),
          job_(job) {}

    PointAlignment from(const Affine& start) {
        Fit fit = improved(start);
        const auto free = fit.step.free_twists(free_share);
        if (!free.empty()) // what is only nearly free loses a little without the motion
            fit = improved(without(fit.motion, fit.step, free));
        const double sampled = static_cast<double>(points_.size());
        PointAlignment found{alignment_of(fit.motion, centre()),
                             static_cast<double>(fit.used) / sampled,
                             free_motions(fit.step.free_twists(free_share))};
        found.rigid.residual = fit.residual, found.rigid.steps = steps_;
        found.rigid.converged = fit.converged;
        return found;
    }

private:
    /// Steps until they are rounding, or a ten-thousandth of the points' own deviation.
    Fit improved(Affine motion) {
        constexpr double rounding = 1e-9, of_deviation = 1e-4;
        // Farther points would come before another part of the surface.
        const double longest = 0.02 * size_;
        while (true) {
            Fit fit = fit_at(motion);
            RigidTwist twist = fit.step.solution(free_share);
            const double length = length_of(twist);
            fit.converged = length <= std::max(rounding * size_, of_deviation * fit.deviation);
            if (fit.converged || left_ == 0) return fit;
            for (double& x : twist) x *= std::min(1.0, longest / length);
            motion = fit.step.motion(twist) * motion;
            --left_, ++steps_;
        }
    }

    Fit fit_at(const Affine& motion) const {
        constexpr std::size_t chunk = 256;
        std::vector<Vec3> places;
        for (const Vec3& point : points_) places.push_back(motion.point(point));
        std::vector<Pull> pulls(places.size());
        parallel_for((places.size() + chunk - 1) / chunk, job_, "align", [&](std::size_t c) {
            ClosestPointWalk walk(nominal_, size_ / 10);
            for (std::size_t i = c * chunk; i < std::min(places.size(), (c + 1) * chunk); ++i)
                pulls[i] = pull_of(walk.next(places[i]), places[i]);
        });
        const double deviation = robust_deviation(pulls);
        const std::vector<double> weights = weights_of(pulls, deviation);
        Fit fit{motion, centred_step(places, weights), deviation};
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (!(weights[i] > 0)) continue;
            fit.step.add(places[i], pulls[i].normal, pulls[i].distance, weights[i]);
            fit.residual += pulls[i].distance * pulls[i].distance, ++fit.used;
        }
        fit.residual = std::sqrt(fit.residual / static_cast<double>(fit.used));
        return fit;
    }

    /// The motion without what it moves along free twists about the pivot of `about`: the points
    /// stay as near to where they were as these let them.
    Affine without(Affine motion, const RigidStep& about,
                   const std::vector<RigidTwist>& twists) const {
        constexpr int most_steps = 50;
        constexpr double enough = 1e-12;
        for (int i = 0; i < most_steps; ++i) {
            RigidStep back(about.pivot(), about.size());
            for (const Vec3& point : points_) {
                const Vec3 place = motion.point(point), way = place - point;
                back.add(place, Vec3(1, 0, 0), way.x, 1);
                back.add(place, Vec3(0, 1, 0), way.y, 1);
                back.add(place, Vec3(0, 0, 1), way.z, 1);
            }
            const RigidTwist twist = back.solution_within(twists);
            motion = back.motion(twist) * motion;
            if (length_of(twist) <= enough * size_) break;
        }
        return motion;
    }

    Vec3 centre() const {
        Vec3 sum(0);
        for (const Vec3& point : points_) sum += point;
        return sum / static_cast<double>(points_.size());
    }

    std::vector<Vec3> points_;
    const ClosestPointQuery& nominal_;
    double size_; ///< mm, of the nominal
    int left_;    ///< steps
    int steps_ = 0;
    const Job& job_;
};

SampleCloud cloud_of(std::span<const Vec3> points) {
    SampleCloud cloud;
    for (const Vec3& point : points) {
        SurfaceSample& sample = cloud.emplace_back();
        sample.point.position = point, sample.area = 1;
    }
    return cloud;
}

} // namespace

PointAlignment align_points(std::span<const Vec3> points, const ClosestPointQuery& nominal,
                            const AlignmentOptions& options, const Job& job) {
    if (points.size() < least_points)
        throw FieldError("points", std::to_string(points.size()) + " are too few to align: " +
                                       std::to_string(least_points) + " are needed at least");
    constexpr std::size_t few = 400, others = 3000;
    const double size = material_bounds(nominal.body().model, job).size();
    const Affine start = coarse_alignment(cloud_of(sample_of(points, few)),
                                          surface_cloud(nominal, others), size, trimmed_share, job);
    return PointFit(sample_of(points, options.samples), nominal, options.most_steps, job)
        .from(start);
}

} // namespace keiko
