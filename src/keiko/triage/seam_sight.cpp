#include "keiko/triage/seam_sight.h"

#include "keiko/base/parallel.h"
#include "keiko/base/units.h"
#include "keiko/inspect/seams/stretch_probes.h"
#include "keiko/scene/view.h"
#include "keiko/triage/reflection_break.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// mm: distance from a place at which rays to an eye begin, so that the surface does not hide its
/// own borders.
constexpr double clearance = 0.1;

/// mm: length that a finding at a single place counts as.
constexpr double place_length = 10;

LineOfSight line_of_sight(const SightPlace& at, const Vec3& eye) {
    const Vec3 way = eye - at.place;
    const double distance = way.length();
    return {distance, std::min(std::abs(way.dot(at.normal)) / distance, 1.0)};
}

/// Arc minutes: the widest break that the place shows to an eye.
double break_at(const SightPlace& at, const Vec3& eye) {
    const LineOfSight sight = line_of_sight(at, eye);
    const double bulges = (eye - at.place).dot(at.normal) > 0 ? -1 : 1;
    const double a = bulges * at.curvature_a, b = bulges * at.curvature_b;
    return std::max({break_of_gap(at.gap, sight), break_of_angle(at.angle, a, sight),
                     break_of_angle(at.angle, b, sight), break_of_curvatures(a, b, sight)});
}

/// Arc minutes under which the eye sees the length of a place.
double seen_length(const SightPlace& at, const Vec3& eye) {
    const Vec3 way = eye - at.place;
    const double square = way.dot(way), along = way.dot(at.along);
    const double across = std::sqrt(std::max(0.0, 1 - along * along / square));
    return 60 * radians_to_degrees(at.length * across / std::sqrt(square));
}

/// A place of a seam with what its class lets be a fault: the angle of a crease is its design.
SightPlace place_of(const SeamPoint& point, const BoundaryFrame& frame, double length,
                    const MeasuredSeam& seam) {
    // The side of the surface by which SeamProbe counts curvatures.
    const bool same_side = frame.tangent.cross(frame.inward).dot(frame.normal) > 0;
    const Vec3 normal = same_side ? frame.normal : -frame.normal;
    SightPlace at{point.place, normal, frame.tangent, length, point.gap, 0, 0, 0};
    if (seam.kind != SeamClass::smooth || !point.angle) return at;
    at.angle = *point.angle;
    at.curvature_a = point.curvature_a, at.curvature_b = point.curvature_b;
    return at;
}

/// Places along a stretch, evenly in the parameters of its pieces.
std::vector<SightPlace> places_of(const Inspection& inspection, std::uint32_t index,
                                  const ModelBorders& borders) {
    constexpr double step = 5; // mm
    constexpr int least = 8, most = 64;
    const MeasuredSeam& seam = inspection.seams[index];
    const StretchProbes probes(borders, inspection.seams, index, inspection.pieces);
    const double count = std::clamp(seam.length / step, double(least), double(most));
    std::vector<SightPlace> places;
    for (const PlacedProbe& placed : probes.probes()) {
        const SeamProbe& probe = placed.probe;
        const double share = seam.length > 0 ? probe.length() / seam.length : 1;
        const int cells = std::max(2, static_cast<int>(std::lround(count * share)));
        const double cell = (probe.end() - probe.begin()) / cells;
        for (int i = 0; i < cells; ++i) {
            const double t = probe.begin() + (i + 0.5) * cell;
            const auto frame = probe.frame(t);
            if (!frame) continue;
            places.push_back(place_of(probe.at(t), *frame, probe.run(t).length() * cell, seam));
        }
    }
    return places;
}

/// Degrees by which the normals of both flanks of a flaw differ, if it has the form of a cosine.
double flank_angle(const Flaw& flaw) {
    const double turns = flaw.kind == Flaw::Kind::waves ? 2 : 1;
    return flaw.width > 0 ? turns * 180 * flaw.depth.value / flaw.width : 0;
}

/// The place of a check of a face or of lines, without its normal.
SightPlace place_of(const Inspection& inspection, const Check& check) {
    SightPlace at;
    at.place = check.worst.place, at.length = place_length;
    if (check.code == "G-SU-NT" || check.code == "KEIKO-LINE-TURN") at.angle = check.worst.value;
    if (check.code == "KEIKO-LINE-JUMP") at.gap = check.worst.value;
    if (check.face == no_index) return at;
    for (const Flaw& flaw : inspection.faces[check.face].flaws)
        if (check.unit == "mm" && flaw.depth.place == check.worst.place)
            at.angle = flank_angle(flaw), at.length = flaw.width;
    return at;
}

} // namespace

void Sight::add(const Sight& other) {
    length += other.length, visible += other.visible;
    width = std::max(width, other.width);
    for (std::size_t i = 0; i < weight.size(); ++i) weight[i] += other.weight[i];
}

std::size_t Sight::best_view() const {
    return static_cast<std::size_t>(std::max_element(weight.begin(), weight.end()) -
                                    weight.begin());
}

StandingEyes::StandingEyes(const SurfaceModel& model, const Tracer& tracer,
                           std::optional<double> ground)
    : model_(model), tracer_(tracer) {
    constexpr double nearest = 3000; // mm, as the standing views have it
    for (std::size_t i = 0; i < eyes_.size(); ++i) {
        const Camera camera = frame_view(standing_views[i], tracer.bounds(), {.ground = ground});
        const Vec3 way = camera.eye - camera.target;
        eyes_[i] = camera.target + way * std::max(1.0, nearest / way.length());
    }
}

/// Whether each view shows each place, view after view.
std::vector<bool> StandingEyes::visibility(std::span<const Vec3> places) const {
    std::vector<Ray> rays;
    for (const Vec3& eye : eyes_)
        for (const Vec3& place : places) {
            Ray ray;
            ray.origin = place, ray.direction = (eye - place).normalized();
            ray.t_min = clearance, ray.t_max = (eye - place).length();
            rays.push_back(ray);
        }
    std::vector<bool> seen = tracer_.any(rays);
    seen.flip();
    return seen;
}

std::vector<bool> StandingEyes::shown(std::span<const Vec3> places) const {
    const std::vector<bool> shows = visibility(places);
    std::vector<bool> shown(places.size());
    for (std::size_t i = 0; i < shows.size(); ++i)
        if (shows[i]) shown[i % places.size()] = true;
    return shown;
}

Sight StandingEyes::sight(std::span<const SightPlace> places) const {
    std::vector<Vec3> points;
    for (const SightPlace& at : places) points.push_back(at.place);
    const std::vector<bool> shows = visibility(points);
    Sight sight;
    for (std::size_t i = 0; i < places.size(); ++i) {
        bool is_seen = false;
        for (std::size_t v = 0; v < eyes_.size(); ++v) {
            if (!shows[v * places.size() + i]) continue;
            const double width = break_at(places[i], eyes_[v]);
            sight.width = std::max(sight.width, width);
            sight.weight[v] += width * seen_length(places[i], eyes_[v]);
            is_seen = true;
        }
        sight.length += places[i].length;
        if (is_seen) sight.visible += places[i].length;
    }
    return sight;
}

std::vector<Sight> StandingEyes::sights(const Inspection& inspection,
                                        std::span<const std::uint32_t> stretches,
                                        const Job& job) const {
    std::vector<Sight> sights(inspection.seams.size());
    if (stretches.empty()) return sights;
    const ModelBorders borders(model_);
    parallel_for(stretches.size(), job, "sights", [&](std::size_t i) {
        sights[stretches[i]] = sight(places_of(inspection, stretches[i], borders));
    });
    return sights;
}

/// The normal is that of the surface where an eye sees the place; hidden places need none.
Sight StandingEyes::sight(const Inspection& inspection, const Check& check) const {
    SightPlace at = place_of(inspection, check);
    for (const Vec3& eye : eyes_) {
        Ray ray;
        ray.origin = eye, ray.direction = (at.place - eye).normalized();
        const auto hit = tracer_.nearest(ray);
        if (!hit || hit->t < (at.place - eye).length() - clearance) continue;
        at.normal = hit->normal;
        break;
    }
    return sight(std::span(&at, 1));
}

} // namespace keiko
