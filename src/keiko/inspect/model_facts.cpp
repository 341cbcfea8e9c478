#include "keiko/inspect/model_facts.h"

#include "keiko/base/parallel.h"
#include "keiko/math/interval_set.h"
#include "keiko/patch/boundary_curves.h"

#include <tuple>

namespace keiko {
namespace {

using BorderKey = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;

/// What of each border meets another one.
std::map<BorderKey, IntervalSet> covered_borders(std::span<const Seam> seams) {
    std::map<BorderKey, std::vector<ParameterInterval>> parts;
    for (const Seam& seam : seams)
        for (const BoundaryInterval* i : {&seam.a, &seam.b})
            parts[{i->instance, i->face, i->curve}].push_back(
                {std::min(i->begin, i->end), std::max(i->begin, i->end)});
    std::map<BorderKey, IntervalSet> covered;
    for (auto& [key, intervals] : parts) covered[key] = IntervalSet(std::move(intervals));
    return covered;
}

struct Lengths {
    double whole = 0, free = 0;
};

Lengths border_lengths(const SurfaceModel& model, std::span<const Seam> seams, const Job& job) {
    const BoundaryCurves curves(model);
    const std::vector<BoundaryInterval> borders = curves.all();
    const std::map<BorderKey, IntervalSet> covered = covered_borders(seams);
    std::vector<Lengths> each(borders.size());
    constexpr std::size_t chunk = 64;
    parallel_for((borders.size() + chunk - 1) / chunk, job, "", [&](std::size_t task) {
        for (std::size_t i = task * chunk; i < std::min(borders.size(), (task + 1) * chunk); ++i) {
            const BoundaryInterval& border = borders[i];
            const SurfaceCurve curve = curves.curve(border);
            each[i].whole = curve.length(0, 1);
            const auto found = covered.find({border.instance, border.face, border.curve});
            const IntervalSet free =
                found == covered.end() ? IntervalSet::whole() : found->second.complement();
            for (const ParameterInterval& part : free)
                each[i].free += curve.length(part.begin, part.end);
        }
    });
    Lengths sum;
    for (const Lengths& one : each) sum.whole += one.whole, sum.free += one.free;
    return sum;
}

void count_patches(const SurfaceModel& model, ModelFacts& facts) {
    facts.patches = model.patches.size();
    for (std::uint32_t i = 0; i < model.patches.size(); ++i) {
        const BezierPatchView patch = model.patch(i);
        ++facts.degrees[{patch.degree_u, patch.degree_v}];
        facts.rational_patches += patch.rational();
    }
}

void count_faces(const SurfaceModel& model, ModelFacts& facts) {
    facts.faces = model.faces.size();
    for (const Face& face : model.faces) {
        facts.trimmed_faces += face.loop_count > 0;
        facts.approximated_faces += face.approximated > 0;
        facts.largest_approximation = std::max(facts.largest_approximation, face.approximated);
        ++facts.kinds[face.surface_kind];
    }
    for (const Instance& instance : model.instances)
        facts.placed_faces += model.parts[instance.part].face_count;
}

} // namespace

ModelFacts model_facts(const SurfaceModel& model, std::span<const Seam> seams, const Job& job) {
    ModelFacts facts;
    facts.source = model.source, facts.format = model.format, facts.unit = model.unit;
    facts.parts = model.parts.size(), facts.instances = model.instances.size();
    count_faces(model, facts);
    count_patches(model, facts);
    facts.bounds = bounds(model);
    facts.seams = seams.size();
    const Lengths lengths = border_lengths(model, seams, job);
    facts.border_length = lengths.whole, facts.free_length = lengths.free;
    facts.lost_faces = model.lost_faces;
    facts.diagnostics = model.diagnostics;
    return facts;
}

} // namespace keiko
