#include "keiko/inspect/model_facts.h"

#include "keiko/base/parallel.h"
#include "keiko/base/units.h"
#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/math/interval_set.h"

#include <tuple>

namespace keiko {
namespace {

using BorderKey = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;

/// The parts of each border that meet another border.
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

Lengths border_lengths(const BoundaryCurves& curves, std::span<const Seam> seams, const Job& job) {
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

FaceFacts face_facts(const SurfaceModel& model, const Face& face) {
    FaceFacts facts{.id = face.id,
                    .part = face.part,
                    .name = face.name,
                    .layer = face.layer,
                    .surface_kind = face.surface_kind,
                    .color = face.color,
                    .patches = face.patch_count,
                    .loops = face.loop_count,
                    .approximated = face.approximated,
                    .line = face.line,
                    .file = face.file};
    for (std::uint32_t i = 0; i < face.patch_count; ++i) {
        const BezierPatchView patch = model.patch(face.first_patch + i);
        facts.degree = {std::max(facts.degree[0], patch.degree_u),
                        std::max(facts.degree[1], patch.degree_v)};
        facts.rational |= patch.rational();
    }
    return facts;
}

std::vector<PartFacts> part_list(const SurfaceModel& model) {
    std::vector<PartFacts> list;
    for (const Part& part : model.parts) {
        PartFacts facts{.name = part.name, .faces = part.face_count};
        for (std::uint32_t i = 0; i < part.face_count; ++i)
            facts.patches += model.faces[part.first_face + i].patch_count;
        list.push_back(std::move(facts));
    }
    for (const Instance& instance : model.instances) {
        ++list[instance.part].instances;
        list[instance.part].mirrored_instances += instance.transform.mirrored();
    }
    return list;
}

void count_edges(const SurfaceModel& model, ModelFacts& facts) {
    facts.edges = model.edges.size();
    for (const Edge& edge : model.edges) {
        facts.degenerate_edges += edge.degenerate;
        facts.largest_edge_tolerance = std::max(facts.largest_edge_tolerance, edge.tolerance);
    }
}

std::map<RepairKind, RepairTotal> total_repairs(const std::vector<Repair>& repairs) {
    std::map<RepairKind, RepairTotal> totals;
    for (const Repair& repair : repairs) {
        RepairTotal& total = totals[repair.kind];
        total.count += repair.count;
        ++total.faces;
        total.size = std::max(total.size, repair.size);
    }
    return totals;
}

RemarkCounts count_remarks(const SurfaceModel& model) {
    RemarkCounts counts{.errors = model.lost_faces.size()};
    for (const Diagnostic& remark : model.diagnostics) {
        counts.notes += remark.severity == Severity::note;
        counts.warnings += remark.severity == Severity::warning;
        counts.errors += remark.severity == Severity::error;
    }
    return counts;
}

} // namespace

TraceFacts trace_facts(const TracerStatistics& statistics) {
    return {.sub_patches = statistics.sub_patches,
            .mixed_sub_patches = statistics.sub_patches_mixed,
            .trimmed_away_sub_patches = statistics.sub_patches_trimmed_away,
            .bytes = statistics.bytes};
}

TraceFacts timed_trace_facts(const TracerStatistics& statistics) {
    TraceFacts facts = trace_facts(statistics);
    facts.build_milliseconds = 1e3 * statistics.build_seconds;
    return facts;
}

ModelFacts model_facts(const ModelBorders& borders, std::span<const Seam> seams, double join,
                       const Job& job) {
    const SurfaceModel& model = borders.model;
    ModelFacts facts;
    facts.files = files_of(model);
    facts.source = model.source, facts.format = model.format, facts.unit = model.unit;
    facts.millimetres_per_unit = model.unit.empty() ? 1 : millimetres_per(model.unit);
    facts.parts = model.parts.size(), facts.instances = model.instances.size();
    count_faces(model, facts);
    count_patches(model, facts);
    count_edges(model, facts);
    facts.part_list = part_list(model);
    for (const Face& face : model.faces) facts.face_list.push_back(face_facts(model, face));
    facts.bounds = material_bounds(model, job);
    facts.join = join;
    const Lengths lengths = border_lengths(borders.curves, seams, job);
    facts.border_length = lengths.whole, facts.free_length = lengths.free;
    facts.lost_faces = model.lost_faces;
    facts.repairs = model.repairs;
    facts.repair_totals = total_repairs(model.repairs);
    facts.diagnostics = model.diagnostics;
    facts.remarks = count_remarks(model);
    return facts;
}

} // namespace keiko
