#include "keiko/base/job.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/inspect/basics/face_box.h"
#include "keiko/inspect/basics/patch_box.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/curvature/curvature_range.h"
#include "keiko/inspect/curvature/face_measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Share of the face's size below which a piece is given up whose parametrisation may be singular.
constexpr double singular_share = 1e-2;
/// Number of goals that are maximised: the six extremes, the least ones with their sign turned.
constexpr std::size_t goal_count = 6;
using Goals = std::array<double, goal_count>;
constexpr Goals nothing_known{infinity, infinity, infinity, infinity, infinity, infinity};

Goals uppers(const CurvatureRange& r) {
    return {r.k1.range.high,   -r.k2.range.low,       r.mean.range.high,
            -r.mean.range.low, r.gaussian.range.high, -r.gaussian.range.low};
}

/// Places where a piece probably reaches the goals, in its own parameters.
std::array<Vec2, goal_count> places(const CurvatureRange& r) {
    return {r.k1.highest,  r.k2.lowest,        r.mean.highest,
            r.mean.lowest, r.gaussian.highest, r.gaussian.lowest};
}

Goals values(const PrincipalCurvatures& k) {
    return {k.k1, -k.k2, k.mean(), -k.mean(), k.gaussian(), -k.gaussian()};
}

/// A piece of a patch with its control points about the origin, so that its numbers are as small as
/// itself.
struct Cell {
    std::size_t patch = 0; ///< into the placed patches
    Box2 uv;
    std::vector<Vec4> points;
    Goals upper = nothing_known;
    bool cut_u = true; ///< direction of its next cut
};

bool bounded(const Cell& cell) {
    return std::none_of(cell.upper.begin(), cell.upper.end(),
                        [](double upper) { return upper == infinity; });
}

void centre(std::vector<Vec4>& points) {
    const Vec4 first = points.front(), last = points.back();
    const Vec3 middle = (euclidean(first) + euclidean(last)) / 2;
    for (Vec4& p : points) p -= Vec4(middle.x * p.w, middle.y * p.w, middle.z * p.w, 0);
}

Box2 part_of(const Box2& whole, const Box2& share) {
    return {whole.lower + share.lower * whole.extent(), whole.lower + share.upper * whole.extent()};
}

class CurvatureSearch {
public:
    /// `tolerated`: rounding error of curvatures that is allowed, times the size of the face.
    CurvatureSearch(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face,
                    double tolerated)
        : model_(model),
          tolerated_(tolerated),
          face_(model.faces[face]),
          trims_(model, face_),
          sign_(face_.reversed != model.instances[instance].transform.mirrored() ? -1 : 1) {
        best_.fill({-infinity, 0, Vec3(0), false});
        Box3 bounds;
        for (std::uint32_t i = 0; i < face_.patch_count; ++i) {
            patches_.emplace_back(model_, face_.first_patch + i,
                                  model.instances[instance].transform);
            bounds.extend(patches_.back().box);
        }
        size_ = bounds.extent().length();
        for (std::size_t i = 0; i < patches_.size(); ++i)
            add({i, unit_square, patches_[i].points, nothing_known, true});
    }

    std::optional<FaceCurvature> run(std::size_t most_splits) {
        // The principal curvatures come first: radii are judged by them.
        constexpr std::size_t principal = 2;
        const std::size_t left = refine(0, principal, most_splits + patches_.size());
        refine(principal, goal_count, left);
        if (!cells_.empty())
            for (std::size_t goal = 0; goal < goal_count; ++goal)
                judge(goal, cells_[most_promising(goal)]);
        if (!std::isfinite(best_[0].value)) return std::nullopt;
        const auto least = [](CurvatureExtreme extreme) {
            extreme.value = -extreme.value;
            return extreme;
        };
        return FaceCurvature{best_[0], least(best_[1]), best_[2], least(best_[3]),
                             best_[4], least(best_[5]), size_,    singular_};
    }

private:
    BezierPatchView view_of(const Cell& cell) const {
        const BezierPatchView patch = model_.patch(patches_[cell.patch].index);
        return {patch.degree_u, patch.degree_v, cell.points};
    }

    void add(Cell cell) {
        const TrimSide side =
            trims_.untrimmed()
                ? TrimSide::inside
                : trims_.classify(face_box(model_, patches_[cell.patch].index, cell.uv));
        if (side == TrimSide::outside) return;
        centre(cell.points);
        const BezierPatchView view = view_of(cell);
        CurvatureRange range = curvature_range(view, patches_[cell.patch].rounding);
        if (sign_ < 0) range = range.turned();
        const Goals own = uppers(range);
        for (std::size_t g = 0; g < goal_count; ++g)
            cell.upper[g] = std::min(own[g], cell.upper[g]); // its whole's hold too
        look(cell, {0.5, 0.5}, side);
        look_at_peaks(cell, places(range), side);
        const std::array<double, 2> size = net_extents(view);
        const bool known = std::isfinite(range.bend_u) && std::isfinite(range.bend_v);
        cell.cut_u = known ? range.bend_u >= range.bend_v : size[0] >= size[1];
        if (!bounded(cell) && std::max(size[0], size[1]) < singular_share * size_)
            singular_ = singular_share * size_;
        else
            cells_.push_back(std::move(cell));
    }

    void look_at_peaks(const Cell& cell, const std::array<Vec2, goal_count>& peaks, TrimSide side) {
        // Trims often run along sides of a patch, where material is undefined.
        constexpr double inwards = 1e-7;
        for (std::size_t goal = 0; goal < goal_count; ++goal) {
            if (!(cell.upper[goal] > best_[goal].value)) continue;
            const Vec2& p = peaks[goal];
            look(cell,
                 {std::clamp(p.x, inwards, 1 - inwards), std::clamp(p.y, inwards, 1 - inwards)},
                 side);
        }
    }

    /// Takes the curvatures at a place of the cell as the best ones if they are better.
    void look(const Cell& cell, const Vec2& local, TrimSide side) {
        const PlacedPatch& patch = patches_[cell.patch];
        const Box2& box = cell.uv;
        const Vec2 uv = box.lower + local * box.extent();
        if (side != TrimSide::inside && !trims_.contains(model_.face_parameters(patch.index, uv)))
            return;
        const BezierPatchView original = model_.patch(patch.index);
        const SurfaceDerivatives s =
            evaluate({original.degree_u, original.degree_v, patch.points}, uv, 2);
        const Vec3 cross = s.du().cross(s.dv());
        if (!(rounding_share(patch, original, s) < 1)) return;
        const Goals found = values(principal_curvatures(s, cross.normalized() * sign_));
        for (std::size_t g = 0; g < goal_count; ++g)
            if (std::isfinite(found[g]) && found[g] > best_[g].value)
                best_[g] = {found[g], 0, patch.middle + s.position(), false};
    }

    /// Rounding error of the curvatures at a place, as a share of the tolerated one. It is large
    /// where a tangent is short, as near poles.
    double rounding_share(const PlacedPatch& patch, const BezierPatchView& view,
                          const SurfaceDerivatives& s) const {
        const double u = s.du().length(), v = s.dv().length();
        const double width = s.du().cross(s.dv()).length() / std::max(u, v);
        const double growth =
            4.0 * std::max(view.degree_u, view.degree_v) * std::max(view.degree_u, view.degree_v);
        return patch.rounding * growth * size_ / (tolerated_ * width * width);
    }

    std::size_t most_promising(std::size_t goal) const {
        const auto most = std::max_element(
            cells_.begin(), cells_.end(),
            [goal](const Cell& a, const Cell& b) { return a.upper[goal] < b.upper[goal]; });
        return static_cast<std::size_t>(most - cells_.begin());
    }

    /// Sets the bound of the best value from the piece with the largest upper bound.
    void judge(std::size_t goal, const Cell& most) {
        // Gaussian curvature of a place whose smaller principal curvature is 1 / size.
        const double bent =
            std::max({std::abs(best_[0].value), std::abs(best_[1].value), 1 / size_});
        const double flat = (goal < 4 ? 1 : bent) / size_;
        CurvatureExtreme& best = best_[goal];
        best.bound = std::max(0.0, most.upper[goal] - best.value);
        best.undecided = !std::isfinite(best.value) ||
                         best.bound > curvature_tolerance * std::max(std::abs(best.value), flat);
    }

    /// Splits the pieces with the largest upper bounds, for each of the extremes [first, last) in
    /// turn, until none exceeds the best value. Returns how many of the allowed splits are left.
    std::size_t refine(std::size_t first, std::size_t last, std::size_t splits) {
        bool split_any = true;
        while (split_any) {
            split_any = false;
            for (std::size_t goal = first; goal < last; ++goal) {
                if (cells_.empty() || splits == 0) return splits;
                const std::size_t most = most_promising(goal);
                judge(goal, cells_[most]);
                if (!best_[goal].undecided) continue;
                split(most);
                split_any = true, --splits;
            }
        }
        return splits;
    }

    void split(std::size_t index) {
        check_stop();
        const Cell whole = std::move(cells_[index]);
        cells_[index] = std::move(cells_.back());
        cells_.pop_back();
        for (const PatchBox& half : PatchBox(view_of(whole)).halves(whole.cut_u))
            add({whole.patch,
                 part_of(whole.uv, half.uv()),
                 {half.view().points.begin(), half.view().points.end()},
                 whole.upper,
                 true});
    }

    const SurfaceModel& model_;
    double tolerated_;
    const Face& face_;
    TrimRegion trims_;
    double sign_; ///< of the outward normal against du x dv
    double size_ = 0;
    std::vector<PlacedPatch> patches_;
    std::vector<Cell> cells_;
    std::array<CurvatureExtreme, goal_count> best_{};
    double singular_ = 0;
};

} // namespace

std::optional<FaceCurvature> face_curvature(const SurfaceModel& model, std::uint32_t instance,
                                            std::uint32_t face, std::size_t most_splits) {
    // Rounding of long coordinates may be too large all over a face of short patches. If only a few
    // places have more of it than others, as those near poles, they are left out.
    for (const double tolerated : {1e-9, 1e-6})
        if (auto found = CurvatureSearch(model, instance, face, tolerated).run(most_splits))
            return found;
    return std::nullopt;
}

} // namespace keiko
