#include "keiko/inspect/curvature/face_measure.h"

#include "keiko/base/parallel.h"
#include "keiko/inspect/basics/approximation_error.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/regularity/face_draft.h"
#include "keiko/inspect/regularity/narrow_turn.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// 1 / the largest absolute curvature; the true radius is smaller by the bound at most. `off`,
/// 1/mm: what the curvatures of an approximation may be off either way.
std::optional<MeasuredValue> smallest_radius(const FaceCurvature& c, double off,
                                             std::optional<double> limit) {
    const CurvatureExtreme& k =
        std::abs(c.largest.value) > std::abs(c.smallest.value) ? c.largest : c.smallest;
    const double curvature = std::abs(k.value);
    const double most =
        std::max(c.largest.value + c.largest.bound, c.smallest.bound - c.smallest.value);
    constexpr double flat = 1e-9; // of 1 / size: curvature of a plane by rounding
    if (!(std::max(curvature, most) * c.size > flat)) return std::nullopt;
    const double radius = 1 / std::max(curvature, flat / c.size);
    MeasuredValue worst{radius,
                        radius - 1 / (std::max(most, curvature) + off),
                        limit.value_or(0),
                        k.place,
                        Verdict::pass,
                        true};
    if (!limit) return worst;
    // A place of the found radius exists; only the bound may be too wide.
    if (radius < *limit && (!(off > 0) || (curvature - off) * *limit > 1))
        worst.verdict = Verdict::fail;
    else if (radius - worst.bound < *limit)
        worst.verdict = Verdict::undecided;
    return worst;
}

/// Takes the narrowest turn of the normals as the smallest radius where curvatures leave one open.
void take_narrow_turn(MeasuredFace& face, const SurfaceModel& model, const CriteriaPreset& preset) {
    MeasuredValue& radius = *face.radius;
    const bool is_open =
        face.curvature->singular > 0 || !(radius.value - radius.bound >= preset.negligible);
    if (!is_open) return;
    const auto turn = narrow_turn(model, face.instance, face.face, preset.negligible);
    if (!turn || turn->radius >= radius.value) return;
    radius.value = radius.bound = turn->radius, radius.place = turn->place;
    const auto& limit = preset.surface.minimum_radius;
    if (limit) radius.verdict = radius.value < *limit ? Verdict::fail : Verdict::undecided;
}

/// Counts what curvatures of an approximation may be off, 1/mm, in their bounds.
void widen(FaceCurvature& c, double off) {
    const double most = std::max(std::abs(c.largest.value), std::abs(c.smallest.value));
    for (CurvatureExtreme* k : {&c.largest, &c.smallest, &c.largest_mean, &c.smallest_mean})
        k->bound += off;
    for (CurvatureExtreme* k : {&c.largest_gaussian, &c.smallest_gaussian})
        k->bound += off * (2 * most + off);
}

MeasuredFace measured(const SurfaceModel& model, std::uint32_t instance, std::uint32_t index,
                      const CriteriaPreset& preset) {
    MeasuredFace face;
    face.instance = instance, face.face = index, face.id = model.faces[index].id;
    face.name = placed_face_name(model, instance, index);
    if (const auto& limit = preset.surface.draft) {
        face.draft = smallest_draft(model, instance, index, *limit);
        if (face.draft) face.verdict = face.draft->verdict;
    }
    if (has_irregular_patch(model, index)) return face;
    const double off =
        approximation_error(model, index, scale_of(model.instances[instance])).curvature;
    // What an approximation is off makes closer bounds worth little.
    constexpr std::size_t most_splits = 5000, most_approximated = 500;
    face.curvature =
        face_curvature(model, instance, index, off > 0 ? most_approximated : most_splits);
    if (!face.curvature) return face;
    face.radius = smallest_radius(*face.curvature, off, preset.surface.minimum_radius);
    if (face.radius) take_narrow_turn(face, model, preset);
    if (face.radius) face.verdict = std::max(face.verdict, face.radius->verdict);
    if (off > 0)
        widen(*face.curvature, off);
    else
        face.inflections = inflection_curves(model, instance, index);
    return face;
}

} // namespace

std::vector<MeasuredFace> measure_faces(const SurfaceModel& model, const FaceLimits& limits,
                                        const Job& job) {
    std::vector<PlacedFace> placed = placed_faces(model);
    std::erase_if(placed,
                  [&](const PlacedFace& f) { return model.faces[f.face].patch_count == 0; });
    std::vector<MeasuredFace> faces(placed.size());
    parallel_for(placed.size(), job, "faces", [&](std::size_t i) {
        faces[i] = measured(model, placed[i].instance, placed[i].face, limits.of(placed[i]));
        faces[i].in_scope = limits.in_scope(placed[i]);
    });
    return faces;
}

} // namespace keiko
