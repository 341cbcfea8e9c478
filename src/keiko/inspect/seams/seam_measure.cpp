#include "keiko/inspect/seams/seam_measure.h"

#include "keiko/base/parallel.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/seams/knot_lines.h"
#include "keiko/inspect/seams/seam_chain.h"
#include "keiko/inspect/seams/seam_line.h"
#include "keiko/inspect/seams/seam_widening.h"

namespace keiko {
namespace {

SeamLine line_of(const BoundaryCurves& curves, std::span<const Seam> seams,
                 const std::vector<std::uint32_t>& pieces) {
    const Seam& first = seams[pieces.front()];
    SeamLine line{first.a.instance, first.a.face, first.b.instance, first.b.face, {}};
    for (const std::uint32_t piece : pieces) line.probes.emplace_back(curves, seams[piece]);
    return line;
}

/// The part of a paired seam that belongs to a stretch.
Seam cut_seam(Seam seam, const SeamPart& part) {
    seam.a.begin = part.begin.t, seam.a.end = part.end.t;
    seam.b.begin = part.begin.s, seam.b.end = part.end.s;
    return seam;
}

/// The seams between faces, with judged scraps.
MeasuredSeams with_judged_scraps(const ModelBorders& borders, std::span<const Seam> paired,
                                 const CriteriaPreset& preset, double join, const Job& job) {
    const SurfaceModel& model = borders.model;
    const BoundaryCurves& curves = borders.curves;
    const std::vector<Seam> seams = widened_seams(curves, paired, join);
    const std::vector<std::vector<std::uint32_t>> chains = seam_chains(curves, seams, join);
    std::vector<std::vector<MeasuredStretch>> lines(chains.size());
    parallel_for(chains.size(), job, "measure", [&](std::size_t i) {
        const SeamLine line = line_of(curves, seams, chains[i]);
        const StretchLimits limits =
            stretch_limits(borders.sizes.of(line.instance_a, line.face_a),
                           borders.sizes.of(line.instance_b, line.face_b), preset, join);
        lines[i] = measure_line(model, line, preset, limits);
    });
    MeasuredSeams result;
    for (std::uint32_t i = 0; i < lines.size(); ++i)
        for (MeasuredStretch& stretch : lines[i]) {
            MeasuredSeam& seam = stretch.seam;
            seam.line = i;
            seam.faces = placed_face_name(model, seam.instance_a, seam.face_a) + " | " +
                         placed_face_name(model, seam.instance_b, seam.face_b);
            for (const SeamPart& part : stretch.parts) {
                seam.pieces.push_back(static_cast<std::uint32_t>(result.pieces.size()));
                result.pieces.push_back(cut_seam(seams[chains[i][part.piece]], part));
            }
            result.seams.push_back(std::move(seam));
        }
    return result;
}

} // namespace

MeasuredSeams measure_seams(const ModelBorders& borders, std::span<const Seam> seams,
                            const CriteriaPreset& preset, double join, const Job& job) {
    MeasuredSeams measured = with_judged_scraps(borders, seams, preset, join, job);
    excuse_scraps(measured.seams);
    return measured;
}

MeasuredSeams measure_all_seams(const ModelBorders& borders, std::span<const Seam> seams,
                                const CriteriaPreset& preset, double join, const Job& job) {
    MeasuredSeams all = with_judged_scraps(borders, seams, preset, join, job);
    const auto lines = static_cast<std::uint32_t>(line_count(all.seams));
    for (MeasuredSeam& seam : measure_knot_lines(borders, preset, job)) {
        seam.line += lines;
        all.seams.push_back(std::move(seam));
    }
    excuse_scraps(all.seams);
    return all;
}

std::size_t line_count(std::span<const MeasuredSeam> seams) {
    return seams.empty() ? 0 : seams.back().line + 1;
}

} // namespace keiko
