#include "keiko/compare/alignment/alignment.h"

#include "keiko/base/parallel.h"
#include "keiko/base/units.h"
#include "keiko/compare/alignment/coarse_alignment.h"
#include "keiko/compare/alignment/rigid_step.h"
#include "keiko/geometry/trim/material_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

SampleCloud thinned(const SampleCloud& cloud, std::size_t most) {
    const std::size_t step = std::max<std::size_t>(1, cloud.size() / most);
    SampleCloud some;
    for (std::size_t i = 0; i < cloud.size(); i += step) some.push_back(cloud[i]);
    return some;
}

/// Constraint of a place of the body: to the nearest place of the other, or of its borders.
enum class HeldBy { surface, border };

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
        if (!foot) return {};
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

} // namespace

Alignment alignment_of(const Affine& motion, const Vec3& centre) {
    Alignment found{.motion = motion};
    const auto& r = motion.rows;
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
    found.shift = motion.point(centre) - centre;
    return found;
}

Alignment align_bodies(const ClosestPointQuery& body, const ClosestPointQuery& other,
                       const AlignmentOptions& options, const Job& job) {
    constexpr std::size_t most_borders = 1000, few = 400, others = 3000;
    constexpr double enough = 1e-11; // of the size
    const double size = material_bounds(other.body().model, job).size(), reach = size / 10;
    const SampleCloud cloud = surface_cloud(body, options.samples);
    const std::vector<Held> held = held_places(body, cloud, most_borders);
    const Vec3 centre = centre_of(cloud);
    Affine motion =
        coarse_alignment(thinned(cloud, few), surface_cloud(other, others), size, 1, job);
    int steps = 0;
    bool converged = false;
    double square = 0;
    for (; steps < options.most_steps && !converged; ++steps) {
        const Turn turn = turn_from(other, held, motion, motion.point(centre), size, reach, job);
        const RigidTwist twist = turn.step.solution(rounding_share);
        square = turn.square, converged = length_of(twist) <= enough * size;
        motion = turn.step.motion(twist) * motion;
    }
    Alignment found = alignment_of(motion, centre);
    found.residual = std::sqrt(square), found.steps = steps, found.converged = converged;
    return found;
}

} // namespace keiko
