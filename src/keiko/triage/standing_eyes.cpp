#include "keiko/triage/standing_eyes.h"

#include "keiko/base/units.h"
#include "keiko/scene/view.h"
#include "keiko/triage/reflection_break.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

/// How a reflection breaks at a place.
struct Break {
    double width = 0;  ///< arc minutes, of the tear or of the change
    double offset = 0; ///< arc minutes: width of the tear that an eye is as sure of
    bool torn = false; ///< it is a tear of a stripe, not a change of its width
};

/// Share of a change of width that is seen where the surface bends along the run: on a small fillet
/// an eye cannot resolve the stripes that cross the run.
double resolved_share(const SightPlace& at, double bulges, const LineOfSight& sight) {
    const double stripe = lamp_width * std::abs(image_size(bulges * at.curvature_along, sight));
    return std::min(stripe / eye_resolution, 1.0);
}

/// The break that an eye sees best. `length`: of the finding, as the eye sees it; a stripe that is
/// wider shows no change on it.
Break break_at(const SightPlace& at, const Vec3& eye, double length) {
    const LineOfSight sight = line_of_sight(at, eye);
    const double bulges = (eye - at.place).dot(at.normal) > 0 ? -1 : 1;
    const double a = bulges * at.curvature_a, b = bulges * at.curvature_b;
    const double tear =
        std::max({break_of_gap(at.gap, sight), break_of_gap_angle(at.gap_angle),
                  break_of_angle(at.angle, a, sight), break_of_angle(at.angle, b, sight)});
    const double change = std::min(break_of_curvatures(a, b, sight), length);
    const double seen = change / offsets_a_change * resolved_share(at, bulges, sight);
    return tear >= seen ? Break{tear, tear, true} : Break{change, seen, false};
}

/// Arc minutes under which the eye sees the length of a place.
double seen_length(const SightPlace& at, const Vec3& eye) {
    const Vec3 way = eye - at.place;
    const double square = way.dot(way), along = way.dot(at.along);
    const double across = std::sqrt(std::max(0.0, 1 - along * along / square));
    return 60 * radians_to_degrees(at.length * across / std::sqrt(square));
}

/// A place as one eye sees it; zeros where it does not.
struct SeenPlace {
    Break shown;
    double weight = 0; ///< as of Sight
};

/// Places as an eye sees those that it is shown.
std::vector<SeenPlace> seen_from(const Vec3& eye, std::span<const SightPlace> places,
                                 const std::vector<bool>& shows) {
    double length = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (shows[i]) length += seen_length(places[i], eye);
    std::vector<SeenPlace> seen(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!shows[i]) continue;
        seen[i].shown = break_at(places[i], eye, length);
        seen[i].weight = pooled(seen[i].shown.offset, seen_length(places[i], eye));
    }
    return seen;
}

/// The middle of the places whose breaks are seen nearly as well as the best.
Vec3 middle_of_worst(std::span<const SightPlace> places, const std::vector<SeenPlace>& seen) {
    constexpr double nearly = 0.9;
    if (places.empty()) return Vec3(0);
    double most = 0;
    for (const SeenPlace& one : seen) most = std::max(most, one.shown.offset);
    std::vector<std::size_t> worst;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (seen[i].shown.offset >= nearly * most) worst.push_back(i);
    return places[worst[worst.size() / 2]].place;
}

/// Sight::spread about a place.
double spread_about(const Vec3& middle, std::span<const SightPlace> places,
                    const std::vector<SeenPlace>& seen) {
    const bool has_weight =
        std::any_of(seen.begin(), seen.end(), [](const auto& one) { return one.weight > 0; });
    std::vector<std::pair<double, double>> by_distance;
    double all = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double part = has_weight ? seen[i].weight : places[i].length;
        const double end = (places[i].place - middle).length() + places[i].length / 2;
        by_distance.emplace_back(end, part), all += part;
    }
    std::sort(by_distance.begin(), by_distance.end());
    double within = 0;
    for (const auto& [distance, part] : by_distance)
        if ((within += part) >= spread_share * all) return distance;
    return 0;
}

bool looks_from_outside(const SightPlace& at, const Vec3& eye) {
    return at.outward == Vec3(0) || (eye - at.place).dot(at.outward) > 0;
}

} // namespace

void Sight::add(const Sight& other) {
    if (length == 0)
        place = other.place, spread = other.spread;
    else
        spread = std::max(spread, (other.place - place).length() + other.spread);
    length += other.length, visible += other.visible;
    tear = std::max(tear, other.tear);
    for (std::size_t i = 0; i < weight.size(); ++i) {
        if (other.width[i] > width[i]) width[i] = other.width[i], torn[i] = other.torn[i];
        weight[i] += other.weight[i];
    }
}

std::size_t Sight::best_view() const {
    const auto* most = std::max_element(weight.begin(), weight.end() - 1);
    if (*most == 0 && weight.back() > 0) most = weight.end() - 1;
    return static_cast<std::size_t>(most - weight.begin());
}

bool Sight::is_resolved() const {
    for (std::size_t i = 0; i + 1 < width.size(); ++i)
        if (width[i] >= eye_resolution || (torn[i] && width[i] > 0)) return true;
    return false;
}

bool Sight::is_worse_than(const Sight& other) const {
    const auto rank = [](const Sight& sight) {
        const std::size_t view = sight.best_view();
        const double most = sight.weight[view];
        return std::pair(most > 0 && view + 1 < sight.weight.size(), most);
    };
    return rank(*this) > rank(other);
}

StandingEyes::StandingEyes(const Tracer& tracer, std::optional<double> ground) : tracer_(tracer) {
    constexpr double nearest = 3000; // mm, as the standing views have it
    for (std::size_t i = 0; i < eyes_.size(); ++i) {
        const Camera camera = frame_view(standing_views[i], tracer.bounds(), {.ground = ground});
        const Vec3 way = camera.eye - camera.target;
        eyes_[i] = camera.target + way * std::max(1.0, nearest / way.length());
    }
}

/// View by view, whether it shows each place from outside.
std::vector<std::vector<bool>> StandingEyes::visibility(std::span<const SightPlace> places) const {
    std::vector<Ray> rays;
    for (const Vec3& eye : eyes_)
        for (const SightPlace& at : places) {
            Ray ray;
            ray.origin = at.place, ray.direction = (eye - at.place).normalized();
            ray.t_min = clearance, ray.t_max = (eye - at.place).length();
            rays.push_back(ray);
        }
    const std::vector<bool> hidden = tracer_.any(rays);
    std::vector<std::vector<bool>> shows(eyes_.size(), std::vector<bool>(places.size()));
    for (std::size_t v = 0, ray = 0; v < eyes_.size(); ++v)
        for (std::size_t i = 0; i < places.size(); ++i, ++ray)
            shows[v][i] = !hidden[ray] && looks_from_outside(places[i], eyes_[v]);
    return shows;
}

std::vector<bool> StandingEyes::shown(std::span<const SightPlace> places) const {
    std::vector<bool> shown(places.size());
    for (const std::vector<bool>& shows : visibility(places))
        for (std::size_t i = 0; i < places.size(); ++i)
            if (shows[i]) shown[i] = true;
    return shown;
}

Sight StandingEyes::sight(std::span<const SightPlace> places) const {
    const std::vector<std::vector<bool>> shows = visibility(places);
    std::vector<std::vector<SeenPlace>> seen;
    Sight sight;
    for (std::size_t v = 0; v < eyes_.size(); ++v) {
        seen.push_back(seen_from(eyes_[v], places, shows[v]));
        for (const SeenPlace& one : seen[v]) {
            if (one.shown.width > sight.width[v])
                sight.width[v] = one.shown.width, sight.torn[v] = one.shown.torn;
            sight.weight[v] += one.weight;
            if (v + 1 < eyes_.size()) sight.tear = std::max(sight.tear, one.shown.offset);
        }
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        sight.length += places[i].length;
        if (std::any_of(shows.begin(), shows.end(), [i](const auto& view) { return view[i]; }))
            sight.visible += places[i].length;
    }
    const std::vector<SeenPlace>& best = seen[sight.best_view()];
    sight.place = middle_of_worst(places, best);
    sight.spread = spread_about(sight.place, places, best);
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
