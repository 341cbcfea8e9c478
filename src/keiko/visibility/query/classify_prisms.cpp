#include "keiko/geometry/bernstein/de_casteljau.h"
#include "keiko/intersect/hit/surface_interaction.h"
#include "keiko/math/vec.h"
#include "keiko/visibility/nets/affine_bounds.h"
#include "keiko/visibility/query/occluder_candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace keiko {
namespace {

/// Trace of the line along which a viewpoint sees a piece edge-on.
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
        const Vec3 way = way_to(j);
        const Vec3 change = bound_ == 0 ? j.duu.cross(j.dv) + j.du.cross(j.duv)
                                        : j.duv.cross(j.dv) + j.du.cross(j.dvv);
        return -j.du.cross(j.dv).dot(way) / (change.dot(way) * piece_.uv.extent()[bound_] * 0.5);
    }
    Vec3 way_to(const SurfaceJet& j) const { return viewpoint_.way_to(patch_.center + j.position); }
    std::optional<Vec3> dark_side(const SurfaceJet& j) const { return bending_side(j, way_to(j)); }

    const SilhouettePiece& piece_;
    const OccluderPatch& patch_;
    const SubPatchKernels& kernels_;
    AffineBounds::Weighed edge_on_;
    const Viewpoint& viewpoint_;
    unsigned bound_; ///< coordinate of the piece
};

/// The line along which a viewpoint sees a silhouette candidate edge-on, from one side of its piece
/// to another. It has one or two straight stretches between exact places: two where it may run back
/// along `along`. `inward`: to the side that the surface hides. None where the line of the
/// candidate's affine part does not cross the piece, nothing where Newton's method does not find
/// its ends.
std::optional<std::vector<BoundaryPiece>> contour_generator(const Silhouettes& silhouettes,
                                                            const SubPatchKernels& kernels,
                                                            const SilhouetteCandidate& candidate,
                                                            const Viewpoint& viewpoint,
                                                            const Vec3& along) {
    const FoldTrace fold(silhouettes, kernels, candidate, viewpoint);
    const auto ends = fold.ends();
    if (!ends) return std::vector<BoundaryPiece>();
    const auto a = fold.place((*ends)[0]), b = fold.place((*ends)[1]);
    if (!a || !b) return std::nullopt;
    const double at_a = a->du.cross(a->dv).dot(along), at_b = b->du.cross(b->dv).dot(along);
    if (at_a * at_b >= 0) return std::vector{fold.stretch(*a, *b)};
    const double t = at_a / (at_a - at_b);
    const auto turn = fold.place((*ends)[0] * (1 - t) + (*ends)[1] * t);
    if (!turn) return std::nullopt;
    return std::vector{fold.stretch(*a, *turn), fold.stretch(*turn, *b)};
}

std::vector<Vec3> corners_of(const Prism& prism) {
    std::vector<Vec3> corners;
    for (const Segment& edge : prism) corners.insert(corners.end(), {edge.a, edge.b});
    return corners;
}

/// Along the screen, in the mean of the edges.
ParameterInterval ends_of(const Prism& prism, const ScanPlane& screen) {
    ParameterInterval ends;
    for (const Segment& edge : prism) {
        ends.begin += screen.place(edge.a).along / static_cast<double>(prism.size());
        ends.end += screen.place(edge.b).along / static_cast<double>(prism.size());
    }
    return ends;
}

/// Whether a border may hide or show any of `volume` in some part of it, by some of its sides.
bool may_cross(const BoundaryPiece& border, const BoundaryPiece::Curve& part,
               const Viewpoint& viewpoint, const ViewVolume& volume, ViewVolume::Sides sides,
               int most_halvings) {
    if (!volume.may_hold(part, border.center, border.error, sides) ||
        !border.may_be_edge_on(viewpoint, part))
        return false;
    if (most_halvings == 0) return true;
    const std::array halves = bernstein_parts(part);
    return std::any_of(halves.begin(), halves.end(), [&](const BoundaryPiece::Curve& half) {
        return may_cross(border, half, viewpoint, volume, sides, most_halvings - 1);
    });
}

} // namespace

bool OccluderCandidates::own_may_cross(const ViewVolume& volume,
                                       std::span<const Vec3> corners) const {
    if (!normal_) return true;
    const ViewpointHorizon horizon{*normal_, least_elevation(viewpoint_, *normal_, corners)};
    return std::any_of(silhouettes_.own.begin(), silhouettes_.own.end(), [&](const auto& own) {
        return own.steepest >= horizon.elevation &&
               own.rings->may_be_in(volume, viewpoint_, horizon);
    });
}

bool OccluderCandidates::nothing_crosses(const Prism& prism, std::span<const Vec3> corners) const {
    const Screen& screen = screen_of((prism[0].b - prism[0].a).normalized());
    const auto along = [&](const Segment& edge) { return screen.screen.is_along(edge.b - edge.a); };
    if (!screen.screen.regular() || !std::all_of(prism.begin(), prism.end(), along)) return false;
    const auto hull = screen.screen.hull(corners);
    if (!hull) return false;
    std::optional<ViewVolume> volume;
    const auto inside = [&]() -> const ViewVolume& {
        if (!volume) volume.emplace(viewpoint_, corners, facing_);
        return *volume;
    };
    constexpr int most_halvings = 8;
    for (std::size_t i = 0; i < screen.borders.size(); ++i) {
        const BoundaryPiece& border = scene_->borders[borders_[i]];
        if (screen.borders[i].overlaps(*hull) &&
            may_cross(border, border.curve, viewpoint_, inside(), inside().all_sides(),
                      most_halvings))
            return false;
    }
    for (std::size_t i = 0; i < screen.pieces.size(); ++i)
        if (screen.pieces[i].overlaps(*hull) &&
            scene_->solver.may_be_in(inside(), silhouettes_.pieces[i], viewpoint_))
            return false;
    return silhouettes_.own.empty() || !own_may_cross(inside(), corners);
}

/// A fold's tangent plane holds its line and the way to it. On the screen that has the slope
/// -n_across / n_along of its normal n, which is at most `most_slope` where both mixtures of the
/// two have one sign.
bool OccluderCandidates::runs_across(std::size_t i, double most_slope) const {
    const SilhouetteCandidate& candidate = silhouettes_.pieces[i];
    const SilhouettePiece& piece = scene_->silhouettes.pieces[candidate.piece];
    const AffineBounds::Weighed& g = candidate.edge_on;
    const Vec2 steepest(g.along_x, g.along_y);
    const Vec2 on_fold = steepest * (-g.value / steepest.length2());
    double sign = 1;
    for (const double side : {-1.0, 1.0}) {
        const Vec3 mixed = screen_->screen.along() * most_slope + screen_->screen.across() * side;
        const AffineBounds::Weighed f =
            piece.planes.weighed(piece.frame.local(Vec4(mixed.x, mixed.y, mixed.z, 0)));
        if (!f.vanishes_nowhere() && !LinearizedSystem(f, g).root_is_outside()) return false;
        sign *= f.value + f.along_x * on_fold.x + f.along_y * on_fold.y;
    }
    return sign > 0;
}

void OccluderCandidates::add_folds(std::size_t i, ContourExtrema& turns) const {
    auto known = screen_->folds.find(i);
    if (known == screen_->folds.end())
        known = screen_->folds
                    .emplace(i, contour_generator(scene_->silhouettes, scene_->kernels,
                                                  silhouettes_.pieces[i], viewpoint_,
                                                  screen_->screen.along()))
                    .first;
    const auto& lines = known->second;
    if (!lines) return turns.add_unclear(screen_->pieces[i]);
    for (const BoundaryPiece& line : *lines) turns.add_fold(line);
}

std::vector<CriticalSlice> OccluderCandidates::turns(const Prism& prism,
                                                     const TurnRule& rule) const {
    if (all_seen_ || viewpoint_.infinite()) return {};
    std::vector<Vec3> corners = corners_of(prism);
    if (facing_) corners = clip_to_half_space(viewpoint_, *facing_, corners);
    if (corners.empty()) return {};
    const Screen& screen = screen_of((prism[0].b - prism[0].a).normalized());
    const auto hull = screen.screen.regular() ? screen.screen.hull(corners) : std::nullopt;
    if (!hull) return {};
    const ViewVolume volume(viewpoint_, corners, facing_);
    ContourExtrema turns(viewpoint_, screen.screen, *hull, volume, ends_of(prism, screen.screen),
                         rule);
    add_outlines(*hull, turns);
    std::vector<CriticalSlice> found;
    for (const ContourExtrema::Turn& turn : turns.found())
        found.push_back({screen.screen.way_at(turn.across), turn.missed, turn.dark, turn.jump});
    return found;
}

/// Adds the outlines on the last screen that was used.
void OccluderCandidates::add_outlines(const ScanBounds& prism, ContourExtrema& turns) const {
    for (std::size_t i = 0; i < screen_->borders.size(); ++i)
        if (screen_->borders[i].overlaps(prism) && !turns.leaves_out(screen_->borders[i]))
            turns.add_border(scene_->borders[borders_[i]]);
    const double most_slope = turns.most_slope();
    for (std::size_t i = 0; i < screen_->pieces.size(); ++i)
        if (screen_->pieces[i].overlaps(prism) && !runs_across(i, most_slope) &&
            !turns.leaves_out(screen_->pieces[i]))
            add_folds(i, turns);
}

std::vector<std::optional<bool>> OccluderCandidates::classify_prisms(
    std::span<const Prism> prisms) const {
    if (all_seen_) return std::vector<std::optional<bool>>(prisms.size(), all_seen_);
    std::vector<std::optional<bool>> seen(prisms.size());
    if (region_touched_ || has_horizon_) return seen;
    std::vector<Ray> rays;
    std::vector<std::size_t> proved;
    for (std::size_t i = 0; i < prisms.size(); ++i) {
        std::vector<Vec3> corners = corners_of(prisms[i]);
        if (facing_) corners = clip_to_half_space(viewpoint_, *facing_, corners);
        if (corners.empty())
            seen[i] = false;
        else if (nothing_crosses(prisms[i], corners)) {
            rays.push_back(viewpoint_.ray_to(middle_of(corners)));
            proved.push_back(i);
        }
    }
    const std::vector<bool> hidden = tracer_->any(std::span<const Ray>(rays));
    for (std::size_t k = 0; k < proved.size(); ++k) seen[proved[k]] = !hidden[k];
    return seen;
}

} // namespace keiko
