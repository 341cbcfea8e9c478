#include "keiko/workflow/visible_shares.h"

#include "keiko/base/parallel.h"
#include "keiko/compare/alignment/coarse_alignment.h"
#include "keiko/triage/standing_eyes.h"

namespace keiko {
namespace {

/// Places of the body, about, and of each side of a piece of a face at least.
constexpr std::size_t most_places = 30000;
constexpr int least_places = 4;

/// The visible area of a piece of a face.
struct SeenArea {
    std::uint32_t face = 0; ///< of the placed model
    double visible = 0;     ///< mm2
    double all = 0;         ///< mm2
};

SeenArea seen_area(const std::vector<SurfaceSample>& samples, const StandingEyes& eyes) {
    SeenArea area;
    std::vector<SightPlace> places(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) places[i].place = samples[i].point.position;
    const std::vector<bool> shown = eyes.shown(places);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        area.face = samples[i].point.face, area.all += samples[i].area;
        if (shown[i]) area.visible += samples[i].area;
    }
    return area;
}

} // namespace

std::vector<double> visible_shares(const SurfaceModel& model, const Tracer& tracer,
                                   std::optional<double> ground, const Job& job) {
    const ClosestPointQuery body(placed_model(model), job);
    const StandingEyes eyes(tracer, ground);
    const double spacing = sample_spacing(body, most_places);
    std::vector<SeenArea> pieces(body.piece_count());
    parallel_for(pieces.size(), job, "sights", [&](std::size_t i) {
        pieces[i] = seen_area(piece_samples(body, i, spacing, least_places), eyes);
    });
    std::vector<SeenArea> faces(body.body().origin.size());
    for (const SeenArea& piece : pieces) {
        faces[piece.face].visible += piece.visible, faces[piece.face].all += piece.all;
    }
    std::vector<double> shares;
    for (const SeenArea& face : faces) shares.push_back(face.all > 0 ? face.visible / face.all : 0);
    return shares;
}

} // namespace keiko
