#include "keiko/inspect/seam_measure.h"

#include "keiko/base/parallel.h"
#include "keiko/inspect/face_names.h"
#include "keiko/inspect/seam_chain.h"
#include "keiko/inspect/seam_line.h"

namespace keiko {
namespace {

SeamLine line_of(const BoundaryCurves& curves, std::span<const Seam> seams,
                 const std::vector<std::uint32_t>& pieces) {
    const Seam& first = seams[pieces.front()];
    SeamLine line{first.a.instance, first.a.face, first.b.instance, first.b.face, {}};
    for (const std::uint32_t piece : pieces) line.probes.emplace_back(curves, seams[piece]);
    return line;
}

} // namespace

std::vector<MeasuredSeam> measure_seams(const SurfaceModel& model, std::span<const Seam> seams,
                                        const CriteriaPreset& preset, double join, const Job& job) {
    const BoundaryCurves curves(model);
    std::vector<std::vector<std::uint32_t>> chains = seam_chains(curves, seams, join);
    std::vector<MeasuredSeam> measured(chains.size());
    parallel_for(chains.size(), job, "measure", [&](std::size_t i) {
        MeasuredSeam& seam = measured[i];
        seam = measure_line(model, line_of(curves, seams, chains[i]), preset);
        seam.faces = placed_face_name(model, seam.instance_a, seam.face_a) + " | " +
                     placed_face_name(model, seam.instance_b, seam.face_b);
        seam.pieces = std::move(chains[i]);
    });
    return measured;
}

} // namespace keiko
