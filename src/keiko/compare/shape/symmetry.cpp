#include "keiko/compare/shape/symmetry.h"

#include "keiko/compare/shape/border_symmetry.h"
#include "keiko/compare/shape/deviation.h"
#include "keiko/geometry/trim/material_bounds.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

std::uint32_t index_of(const std::vector<MeasuredFace>& faces, const PlacedFace& placed) {
    const auto found = std::find_if(faces.begin(), faces.end(), [&](const MeasuredFace& face) {
        return face.instance == placed.instance && face.face == placed.face;
    });
    return static_cast<std::uint32_t>(found - faces.begin());
}

constexpr double same_border = 1e-9; // mm, rounding of the nearest places
constexpr double fiftieth = 0.02;    // of the size: what is farther has no image at all

struct SelfDeviation {
    PlacedModel body;
    Deviation found;
    double reach = 0;

    double distance() const { return std::min(std::abs(found.worst.value), reach); }
};

SelfDeviation self_deviation(const SurfaceModel& model, const MirrorPlane& plane,
                             const DeviationOptions& options, const Job& job) {
    const ClosestPointQuery body(placed_model(model), job);
    const ClosestPointQuery image(placed_model(model, plane.motion()), job);
    DeviationOptions within = options;
    within.reach = fiftieth * material_bounds(body.body().model, job).size();
    return {body.body(), measure_deviation(body, image, within, job), within.reach};
}

std::optional<MirrorPlane> nearest_plane(const SurfaceModel& model, const Job& job) {
    const Box3 box = material_bounds(model, job);
    const Vec3 middle = (box.lower + box.upper) / 2;
    for (const MirrorPlane& plane : {MirrorPlane{1, 0}, MirrorPlane{1, middle.y},
                                     MirrorPlane{0, middle.x}, MirrorPlane{2, middle.z}}) {
        if (!(std::abs(plane.distance(middle)) < fiftieth * box.size())) continue;
        if (is_own_image(model, plane, fiftieth * box.size(), {}, job)) return plane;
    }
    return std::nullopt;
}

/// Counts the borders in: the worse of both, and what either may hide.
void take_border(const BorderDeviation& border, MeasuredValue& worst, PlacedFace& face) {
    worst.verdict = std::max(
        worst.verdict, judge_maximum(border.distance, border.hidden, same_border, worst.limit));
    const double most = std::max(worst.value + worst.bound, border.distance + border.hidden);
    if (border.distance > worst.value)
        worst.value = border.distance, worst.place = border.place, face = border.face;
    worst.bound = most - worst.value;
}

void add_check_at(const SurfaceModel& model, const SymmetryLimit& limit, Check::Severity severity,
                  Inspection& inspection, const Job& job) {
    const DeviationOptions options;
    const SelfDeviation self = self_deviation(model, limit.plane, options, job);
    MeasuredValue worst;
    worst.value = self.distance();
    worst.bound = std::max(self.found.largest_uncertainty, options.certainty);
    worst.limit = limit.distance, worst.place = self.found.worst.place;
    worst.verdict = judge(worst.value, worst.bound, worst.limit);
    PlacedFace face = self.body.origin[self.found.worst.face];
    const BorderSearch search{limit.distance, self.reach, inspection.preset.negligible,
                              inspection.join};
    if (const auto border = border_asymmetry(model, inspection.pieces, limit.plane, search, job))
        take_border(*border, worst, face);
    Check check = check_of_symmetry(worst, limit.plane.text());
    check.severity = severity;
    check.face = index_of(inspection.faces, face);
    check.faces = inspection.faces.at(check.face).name;
    add_check(inspection, std::move(check));
}

} // namespace

bool is_own_image(const SurfaceModel& model, const MirrorPlane& plane, double distance,
                  std::span<const std::uint32_t> chosen, const Job& job) {
    const ClosestPointQuery body(placed_model(model, {}, chosen), job);
    const ClosestPointQuery image(placed_model(model, plane.motion(), chosen), job);
    DeviationOptions options;
    options.samples = 3000, options.reach = distance;
    return lies_within_reach(body, image, options, job);
}

void check_symmetry(const SurfaceModel& model, Inspection& inspection, const Job& job) {
    if (inspection.faces.empty()) return;
    const CriteriaPreset& preset = inspection.preset;
    if (const auto& limit = preset.surface.symmetry) {
        add_check_at(model, *limit, Check::Severity::judged, inspection, job);
        return;
    }
    if (!preset.look.symmetry) return;
    const auto plane = nearest_plane(model, job);
    const SymmetryLimit limit{plane.value_or(MirrorPlane{}), *preset.look.symmetry};
    if (plane) add_check_at(model, limit, Check::Severity::look, inspection, job);
}

} // namespace keiko
