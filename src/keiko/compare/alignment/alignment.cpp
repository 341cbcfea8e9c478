#include "keiko/compare/alignment/alignment.h"

#include "keiko/base/parallel.h"
#include "keiko/base/units.h"
#include "keiko/compare/alignment/coarse_alignment.h"
#include "keiko/geometry/trim/material_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

SampleCloud cloud_of(const ClosestPointQuery& body, std::size_t count) {
    const double spacing = sample_spacing(body, count);
    SampleCloud cloud;
    for (std::size_t i = 0; i < body.piece_count(); ++i)
        for (const SurfaceSample& sample : piece_samples(body, i, spacing, 1))
            cloud.push_back(sample);
    return cloud;
}

SampleCloud thinned(const SampleCloud& cloud, std::size_t most) {
    const std::size_t step = std::max<std::size_t>(1, cloud.size() / most);
    SampleCloud some;
    for (std::size_t i = 0; i < cloud.size(); i += step) some.push_back(cloud[i]);
    return some;
}

/// Constraint of a place of the body: to the nearest place of the other, to the nearest of its
/// borders, or to the nearest that is not beyond these.
enum class HeldBy { surface, border, inner_surface };

/// A place of the body, and how much it counts.
struct Held {
    Vec3 place;
    double weight;
    HeldBy by;
};

std::vector<Held> held_places(const ClosestPointQuery& body, const SampleCloud& cloud,
                              std::size_t most_borders) {
    constexpr double border_share = 1e-3;
    std::vector<Held> held;
    double area = 0;
    for (const SurfaceSample& sample : cloud) {
        held.push_back({sample.point.position, sample.area, HeldBy::surface});
        area += sample.area;
    }
    const std::vector<BorderPoint> borders = body.border_points();
    const std::size_t step = std::max<std::size_t>(1, borders.size() / most_borders);
    const std::size_t count = (borders.size() + step - 1) / step;
    for (std::size_t i = 0; i < borders.size(); i += step)
        held.push_back({borders[i].position, border_share * area / static_cast<double>(count),
                        HeldBy::border});
    return held;
}

/// Distance of a place from the other body, and the direction along which it grows.
struct Off {
    double distance = 0;
    Vec3 direction{0};
};

Off off(const ClosestPointQuery& other, const Held& held, const Vec3& p, double reach) {
    Vec3 to = p, normal(0);
    if (held.by == HeldBy::border) {
        const auto foot = other.border_foot(p, reach);
        if (!foot) return {};
        to = *foot;
    } else {
        const auto foot = other.foot(p, reach);
        constexpr double rounding = 1e-6; // mm: nearer points have no direction
        const bool beyond = foot && (foot->on_border || foot->is_beside(p, rounding));
        if (!foot || (beyond && held.by == HeldBy::inner_surface)) return {};
        to = foot->position;
        if (!foot->on_border) normal = foot->normal;
    }
    if (normal != Vec3(0)) return {(p - to).dot(normal), normal};
    const double distance = (p - to).length();
    return distance > 0 ? Off{distance, (p - to) / distance} : Off{};
}

/// One step of the iteration from a motion.
struct Turn {
    RigidStep step;
    double square = 0; ///< mean square distance of the places on surfaces, mm2
};

Turn turn_from(const ClosestPointQuery& other, const std::vector<Held>& held, const Affine& motion,
               const Vec3& pivot, double size, double reach, const Job& job) {
    std::vector<Off> offs(held.size());
    constexpr std::size_t chunk = 64;
    parallel_for((held.size() + chunk - 1) / chunk, job, "align", [&](std::size_t c) {
        for (std::size_t i = c * chunk; i < std::min(held.size(), (c + 1) * chunk); ++i)
            offs[i] = off(other, held[i], motion.point(held[i].place), reach);
    });
    Turn turn{RigidStep(pivot, size)};
    double area = 0;
    for (std::size_t i = 0; i < held.size(); ++i) {
        turn.step.add(motion.point(held[i].place), offs[i].direction, offs[i].distance,
                      held[i].weight);
        if (held[i].by == HeldBy::border || offs[i].direction == Vec3(0)) continue;
        turn.square += held[i].weight * offs[i].distance * offs[i].distance;
        area += held[i].weight;
    }
    if (area > 0) turn.square /= area;
    return turn;
}

void tell_motion(Alignment& found, const Vec3& centre) {
    const auto& r = found.motion.rows;
    const Vec3 twice(r[2].y - r[1].z, r[0].z - r[2].x, r[1].x - r[0].y); // 2 sin of the angle
    const double cosine = (r[0].x + r[1].y + r[2].z - 1) / 2;
    found.angle = radians_to_degrees(std::atan2(twice.length() / 2, cosine));
    // About half a turn the difference to the transposed matrix is next to nothing.
    const bool half_turn = found.angle > 179;
    for (unsigned i = 0; i < 3 && half_turn; ++i) {
        Vec3 column(r[0][i], r[1][i], r[2][i]);
        column[i] += 1;
        if (column.length() > found.axis.length()) found.axis = column;
    }
    if (!half_turn) found.axis = twice;
    if (found.axis.length() > 0) found.axis.normalize();
    found.shift = found.motion.point(centre) - centre;
}

/// Points at equal steps through all of them, `most` of them at most.
SampleCloud cloud_of(std::span<const Vec3> points, std::size_t most) {
    const std::size_t step =
        std::max<std::size_t>(1, (points.size() + most - 1) / std::max<std::size_t>(most, 1));
    SampleCloud cloud;
    for (std::size_t i = 0; i < points.size(); i += step) {
        SurfaceSample sample;
        sample.point.position = points[i], sample.area = 1;
        cloud.push_back(sample);
    }
    return cloud;
}

/// Lengths of steps, as shares of the size of the other.
struct StepLimits {
    double enough; ///< a shorter one ends the iteration
    double most;   ///< a longer one is not made, and ends it without convergence
};

/// Iterates from the coarse alignment of `cloud`.
Alignment aligned(const SampleCloud& cloud, const std::vector<Held>& held,
                  const ClosestPointQuery& other, const AlignmentOptions& options,
                  const StepLimits& limits, const Job& job) {
    constexpr std::size_t few = 400, others = 3000;
    const double size = material_bounds(other.body().model, job).size(), reach = size / 10;
    const Vec3 centre = centre_of(cloud);
    Alignment found;
    found.motion = coarse_alignment(thinned(cloud, few), cloud_of(other, others), size, job);
    double square = 0;
    while (found.steps < options.most_steps && !found.converged) {
        const Turn turn =
            turn_from(other, held, found.motion, found.motion.point(centre), size, reach, job);
        square = turn.square;
        if (turn.step.length() > limits.most * size) break;
        found.converged = turn.step.length() <= limits.enough * size;
        found.motion = turn.step.motion() * found.motion;
        ++found.steps;
    }
    found.residual = std::sqrt(square);
    tell_motion(found, centre);
    return found;
}

} // namespace

Alignment align_bodies(const ClosestPointQuery& body, const ClosestPointQuery& other,
                       const AlignmentOptions& options, const Job& job) {
    constexpr std::size_t most_borders = 1000;
    constexpr StepLimits limits{1e-11, std::numeric_limits<double>::infinity()};
    const SampleCloud cloud = cloud_of(body, options.samples);
    return aligned(cloud, held_places(body, cloud, most_borders), other, options, limits, job);
}

Alignment align_points(std::span<const Vec3> points, const ClosestPointQuery& other,
                       const AlignmentOptions& options, const Job& job) {
    // A point that changes between faces lets shorter steps linger. Points that come to lie beyond
    // borders hold nothing any more, so that a long step could lose them all.
    constexpr StepLimits limits{1e-9, 0.02};
    const SampleCloud cloud = cloud_of(points, options.samples);
    std::vector<Held> held;
    for (const SurfaceSample& sample : cloud)
        held.push_back({sample.point.position, 1, HeldBy::inner_surface});
    return aligned(cloud, held, other, options, limits, job);
}

} // namespace keiko
