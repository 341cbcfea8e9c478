#include "keiko/visibility/query/contour_generator.h"

#include "keiko/intersect/hit/surface_jet.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

class FoldTrace {
public:
    FoldTrace(const Silhouettes& silhouettes, const SubPatchKernels& kernels,
              const SilhouetteCandidate& candidate, const Viewpoint& viewpoint)
        : piece_(silhouettes.pieces[candidate.piece]),
          patch_(silhouettes.patches[piece_.patch]),
          kernels_(kernels),
          edge_on_(candidate.edge_on),
          viewpoint_(viewpoint),
          bound_(std::abs(edge_on_.along_x) >= std::abs(edge_on_.along_y) ? 0 : 1) {}

    /// Places where the affine part of the function that is zero on the line leaves the piece.
    std::optional<std::array<Vec2, 2>> ends() const {
        std::array<Vec2, 2> ends{Vec2(0), Vec2(0)};
        const unsigned free = 1 - bound_;
        const double slope = slope_of(free) / slope_of(bound_);
        const double start = -edge_on_.value / slope_of(bound_);
        double low = -1, high = 1;
        if (std::abs(slope) > 1e-12) {
            const double a = (start - 1) / slope, b = (start + 1) / slope;
            low = std::max(low, std::min(a, b)), high = std::min(high, std::max(a, b));
        } else if (std::abs(start) > 1) {
            return std::nullopt;
        }
        if (!(low < high)) return std::nullopt;
        for (const unsigned k : {0u, 1u}) {
            ends[k][free] = k == 0 ? low : high;
            ends[k][bound_] = start - slope * ends[k][free];
        }
        return ends;
    }
    /// On the exact surface, at the same free coordinate.
    std::optional<SurfaceJet> place(Vec2 xy) const {
        constexpr int most_steps = 6;
        constexpr double astray = 1, settled = 1e-4; // the next step is about its square
        for (int i = 0; i < most_steps; ++i) {
            const SurfaceJet jet =
                jet_on(kernels_, patch_, piece_.uv.center() + piece_.uv.extent() * 0.5 * xy);
            const double step = step_at(jet);
            if (!(std::abs(step) < astray)) break;
            xy[bound_] += step;
            if (std::abs(step) <= settled)
                return jet_on(kernels_, patch_, piece_.uv.center() + piece_.uv.extent() * 0.5 * xy);
        }
        return std::nullopt;
    }
    BoundaryPiece stretch(const SurfaceJet& a, const SurfaceJet& b) const {
        BoundaryPiece line;
        line.instance = patch_.instance, line.face = patch_.face;
        line.center = patch_.center + a.position;
        for (std::size_t i = 0; i < line.curve.size(); ++i)
            line.curve[i] = (b.position - a.position) * (static_cast<double>(i) / 5);
        const auto at_a = dark_side(a), at_b = dark_side(b);
        line.inward_error = std::numbers::pi / 2;
        if (at_a && at_b && at_a->dot(*at_b) > 0) {
            line.inward = {*at_a, (*at_a + *at_b).normalized(), *at_b};
            line.inward_error = 0;
        }
        return line;
    }

private:
    double slope_of(unsigned axis) const { return axis == 0 ? edge_on_.along_x : edge_on_.along_y; }
    double step_at(const SurfaceJet& j) const {
        const Vec3 way = viewpoint_.way_to(patch_.center + j.position);
        const Vec3 change = bound_ == 0 ? j.duu.cross(j.dv) + j.du.cross(j.duv)
                                        : j.duv.cross(j.dv) + j.du.cross(j.dvv);
        return -j.du.cross(j.dv).dot(way) / (change.dot(way) * piece_.uv.extent()[bound_] * 0.5);
    }
    std::optional<Vec3> dark_side(const SurfaceJet& j) const {
        return bending_side(j, viewpoint_.way_to(patch_.center + j.position));
    }

    const SilhouettePiece& piece_;
    const OccluderPatch& patch_;
    const SubPatchKernels& kernels_;
    AffineBounds::Weighed edge_on_;
    const Viewpoint& viewpoint_;
    unsigned bound_; ///< coordinate of the piece
};

} // namespace

std::optional<std::vector<BoundaryPiece>> contour_generator(const Silhouettes& silhouettes,
                                                            const SubPatchKernels& kernels,
                                                            const SilhouetteCandidate& candidate,
                                                            const Viewpoint& viewpoint,
                                                            const Vec3& along) {
    const FoldTrace fold(silhouettes, kernels, candidate, viewpoint);
    std::vector<BoundaryPiece> lines;
    const auto ends = fold.ends();
    if (!ends) return lines;
    const auto a = fold.place((*ends)[0]), b = fold.place((*ends)[1]);
    if (!a || !b) return std::nullopt;
    const double at_a = a->du.cross(a->dv).dot(along), at_b = b->du.cross(b->dv).dot(along);
    if (at_a * at_b >= 0) {
        lines.push_back(fold.stretch(*a, *b));
        return lines;
    }
    const double t = at_a / (at_a - at_b);
    const auto turn = fold.place((*ends)[0] * (1 - t) + (*ends)[1] * t);
    if (!turn) return std::nullopt;
    lines.push_back(fold.stretch(*a, *turn));
    lines.push_back(fold.stretch(*turn, *b));
    return lines;
}

} // namespace keiko
