#include "keiko/compare/symmetry.h"

#include "keiko/compare/deviation.h"
#include "keiko/patch/material_bounds.h"

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

} // namespace

void check_symmetry(const SurfaceModel& model, Inspection& inspection, const Job& job) {
    const std::optional<SymmetryLimit>& limit = inspection.preset.surface.symmetry;
    if (!limit || inspection.faces.empty()) return;
    const SurfaceFeet body(placed_model(model), job);
    const SurfaceFeet image(placed_model(model, limit->plane.motion()), job);
    DeviationOptions options;
    constexpr double fiftieth = 0.02; // of the size: what is farther has no image at all
    options.reach = fiftieth * material_bounds(body.body().model, job).size();
    const Deviation found = measure_deviation(body, image, options, job);
    Worst worst;
    worst.value = std::min(std::abs(found.worst.value), options.reach);
    worst.bound = std::max(found.largest_uncertainty, options.certainty);
    worst.limit = limit->distance, worst.place = found.worst.place;
    worst.verdict = judge(worst.value, worst.bound, worst.limit);
    Check check = check_of_symmetry(worst, limit->plane.text());
    check.face = index_of(inspection.faces, body.body().origin[found.worst.face]);
    check.faces = inspection.faces.at(check.face).name;
    add_check(inspection, std::move(check));
}

} // namespace keiko
