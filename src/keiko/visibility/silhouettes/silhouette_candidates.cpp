#include "keiko/visibility/silhouettes/silhouette_candidates.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

bool within(const Vec2& xy, double reach) {
    return std::abs(xy.x) <= reach && std::abs(xy.y) <= reach;
}

} // namespace

void CandidateMaker::add(std::uint32_t index, const Viewpoint& viewpoint,
                         const std::optional<ViewpointHorizon>& horizon,
                         SilhouetteCandidates& all) const {
    const SilhouettePiece& piece = silhouettes_.pieces[index];
    const AffineBounds::Weighed edge_on = piece.planes.weighed(piece.weights(viewpoint));
    if (edge_on.vanishes_nowhere()) return;
    const auto known = std::find_if(all.own.begin(), all.own.end(),
                                    [&](const OwnCandidate& o) { return o.patch == piece.patch; });
    const auto found = known != all.own.end() ? std::optional(known->foot) : foot(piece, viewpoint);
    if (!found || !piece.surroundings().contains(*found))
        return all.pieces.push_back({index, edge_on});
    const auto steepest = [&] {
        return steepest_chord(piece.chords,
                              piece.frame.local(viewpoint.place() - piece.frame.center),
                              piece.frame.local(horizon->normal));
    };
    if (horizon && horizon->elevation > 0 && steepest() < horizon->elevation) return;
    auto own = known;
    if (own == all.own.end()) {
        all.own.push_back({piece.patch, {*found, *found}, *found});
        own = all.own.end() - 1;
    }
    own->uv.extend(piece.uv);
}

std::optional<Vec2> CandidateMaker::foot(const SilhouettePiece& piece,
                                         const Viewpoint& viewpoint) const {
    const auto& root = viewpoint.excluded();
    if (!root) return std::nullopt;
    const OccluderPatch& patch = silhouettes_.patches[piece.patch];
    if (root->instance == patch.instance && root->patch == patch.patch)
        return (root->uv.center() - patch.uv.lower) / patch.uv.extent();
    if (!piece.box.padded(piece.box.size()).contains(viewpoint.place())) return std::nullopt;
    constexpr int most_steps = 8;
    constexpr double on_surface = 1e-11, beside = 2;
    const double size = piece.box.size() + patch.center.length();
    Vec2 uv = piece.uv.center();
    for (int i = 0; i < most_steps; ++i) {
        const SurfaceJet s = jet_on(kernels_, patch, uv);
        const Vec3 off = viewpoint.place() - patch.center - s.position;
        if (off.length() <= on_surface * size) return uv;
        const double a = s.du.dot(s.du), b = s.du.dot(s.dv), c = s.dv.dot(s.dv);
        const double u = s.du.dot(off), v = s.dv.dot(off), d = a * c - b * b;
        uv += Vec2(c * u - b * v, a * v - b * u) / d;
        if (!within((uv - piece.uv.center()) / (piece.uv.extent() * 0.5), beside))
            return std::nullopt;
    }
    return std::nullopt;
}

double SilhouetteCandidates::own_steepest() const {
    double steepest = 0;
    for (const OwnCandidate& o : own) steepest = std::max(steepest, o.steepest);
    return steepest;
}

void CandidateMaker::finish(const Viewpoint& viewpoint,
                            const std::optional<ViewpointHorizon>& horizon,
                            SilhouetteCandidates& all) const {
    std::erase_if(all.own, [&](OwnCandidate& own) {
        const OccluderPatch& patch = silhouettes_.patches[own.patch];
        own.trimmed = !silhouettes_.regions[patch.face].untrimmed();
        if (horizon) {
            own.steepest = steepest_chord(patch.points, own.uv, viewpoint.place() - patch.center,
                                          horizon->normal);
            if (own.steepest < horizon->elevation) return true;
        }
        own.rings.emplace(
            patch, own.uv, own.foot,
            restricted(weighed(patch.planes, viewpoint.seen_from(patch.center)), own.uv));
        return own.rings->find_nothing();
    });
}

} // namespace keiko
