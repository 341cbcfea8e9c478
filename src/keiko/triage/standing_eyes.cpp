#include "keiko/triage/standing_eyes.h"

#include "keiko/base/units.h"
#include "keiko/scene/view.h"
#include "keiko/triage/reflection_break.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// mm: distance from a place at which rays to an eye begin, so that the surface does not hide its
/// own borders.
constexpr double clearance = 0.1;

LineOfSight line_of_sight(const SightPlace& at, const Vec3& eye) {
    const Vec3 way = eye - at.place;
    const double distance = way.length();
    return {distance, std::min(std::abs(way.dot(at.normal)) / distance, 1.0)};
}

/// Arc minutes: the widest break that the place shows to an eye. `length`: of the finding, as the
/// eye sees it; a stripe that is wider shows no change on it.
double break_at(const SightPlace& at, const Vec3& eye, double length) {
    const LineOfSight sight = line_of_sight(at, eye);
    const double bulges = (eye - at.place).dot(at.normal) > 0 ? -1 : 1;
    const double a = bulges * at.curvature_a, b = bulges * at.curvature_b;
    return std::max({break_of_gap(at.gap, sight), break_of_gap_angle(at.gap_angle),
                     break_of_angle(at.angle, a, sight), break_of_angle(at.angle, b, sight),
                     std::min(break_of_curvatures(a, b, sight), length)});
}

/// Arc minutes under which the eye sees the length of a place.
double seen_length(const SightPlace& at, const Vec3& eye) {
    const Vec3 way = eye - at.place;
    const double square = way.dot(way), along = way.dot(at.along);
    const double across = std::sqrt(std::max(0.0, 1 - along * along / square));
    return 60 * radians_to_degrees(at.length * across / std::sqrt(square));
}

/// The middle of the places whose breaks are nearly as wide as the widest.
Vec3 middle_of_worst(std::span<const SightPlace> places, std::span<const double> widths) {
    constexpr double nearly = 0.9;
    if (places.empty()) return Vec3(0);
    const double widest = *std::max_element(widths.begin(), widths.end());
    std::vector<std::size_t> worst;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (widths[i] >= nearly * widest) worst.push_back(i);
    return places[worst[worst.size() / 2]].place;
}

bool looks_from_outside(const SightPlace& at, const Vec3& eye) {
    return at.outward == Vec3(0) || (eye - at.place).dot(at.outward) > 0;
}

} // namespace

void Sight::add(const Sight& other) {
    if (length == 0) place = other.place;
    length += other.length, visible += other.visible;
    width = std::max(width, other.width);
    for (std::size_t i = 0; i < weight.size(); ++i) weight[i] += other.weight[i];
}

std::size_t Sight::best_view() const {
    return static_cast<std::size_t>(std::max_element(weight.begin(), weight.end()) -
                                    weight.begin());
}

StandingEyes::StandingEyes(const Tracer& tracer, std::optional<double> ground) : tracer_(tracer) {
    constexpr double nearest = 3000; // mm, as the standing views have it
    for (std::size_t i = 0; i < eyes_.size(); ++i) {
        const Camera camera = frame_view(standing_views[i], tracer.bounds(), {.ground = ground});
        const Vec3 way = camera.eye - camera.target;
        eyes_[i] = camera.target + way * std::max(1.0, nearest / way.length());
    }
}

/// Whether each view shows each place from outside, view after view.
std::vector<bool> StandingEyes::visibility(std::span<const SightPlace> places) const {
    std::vector<Ray> rays;
    for (const Vec3& eye : eyes_)
        for (const SightPlace& at : places) {
            Ray ray;
            ray.origin = at.place, ray.direction = (eye - at.place).normalized();
            ray.t_min = clearance, ray.t_max = (eye - at.place).length();
            rays.push_back(ray);
        }
    std::vector<bool> seen = tracer_.any(rays);
    seen.flip();
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (!looks_from_outside(places[i % places.size()], eyes_[i / places.size()]))
            seen[i] = false;
    return seen;
}

std::vector<bool> StandingEyes::shown(std::span<const SightPlace> places) const {
    const std::vector<bool> shows = visibility(places);
    std::vector<bool> shown(places.size());
    for (std::size_t i = 0; i < shows.size(); ++i)
        if (shows[i]) shown[i % places.size()] = true;
    return shown;
}

Sight StandingEyes::sight(std::span<const SightPlace> places) const {
    const std::vector<bool> shows = visibility(places);
    std::vector<double> widths(shows.size());
    std::vector<bool> is_seen(places.size());
    Sight sight;
    for (std::size_t v = 0; v < eyes_.size(); ++v) {
        const auto each_seen = [&](const auto& look_at) {
            for (std::size_t i = 0; i < places.size(); ++i)
                if (shows[v * places.size() + i]) look_at(i);
        };
        double length = 0;
        each_seen([&](std::size_t i) { length += seen_length(places[i], eyes_[v]); });
        each_seen([&](std::size_t i) {
            const double width = break_at(places[i], eyes_[v], length);
            widths[v * places.size() + i] = width;
            sight.width = std::max(sight.width, width);
            sight.weight[v] += width * seen_length(places[i], eyes_[v]);
            is_seen[i] = true;
        });
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        sight.length += places[i].length;
        if (is_seen[i]) sight.visible += places[i].length;
    }
    sight.place = middle_of_worst(
        places, std::span(widths).subspan(sight.best_view() * places.size(), places.size()));
    return sight;
}

std::optional<Hit> StandingEyes::seen(const Vec3& place) const {
    for (const Vec3& eye : eyes_) {
        Ray ray;
        ray.origin = eye, ray.direction = (place - eye).normalized();
        auto hit = tracer_.nearest(ray);
        if (hit && hit->t >= (place - eye).length() - clearance) return hit;
    }
    return std::nullopt;
}

} // namespace keiko
