#pragma once

#include "keiko/geometry/model/patch_grid.h"
#include "keiko/inspect/seams/seam_probe.h"

#include <array>
#include <tuple>

namespace keiko {

/// A stretch of a line of constant u or v inside a face, in face parameters. It includes the
/// parameters at which its two sides are evaluated: its own, or others beside it if the line is a
/// bend.
struct KnotPiece {
    bool constant_u = true;
    double at = 0, begin = 0, end = 0;
    double low = at, high = at;
    bool has_limits = true; ///< the curvatures of its sides are their limits at the line

    bool is_bend() const { return low < high; }
    auto order() const { return std::tuple(!constant_u, at, begin, end); }
    /// The point at `x` of a line of the constant parameter `line`.
    Vec2 point(double line, double x) const { return constant_u ? Vec2(line, x) : Vec2(x, line); }
    /// Its left or right side, in its direction: a p-curve.
    std::array<Vec3, 2> side(bool left) const {
        const double line = left == constant_u ? low : high;
        const Vec2 a = point(line, begin), b = point(line, end);
        return {Vec3(a.x, a.y, 1), Vec3(b.x, b.y, 1)};
    }
    /// True if the areas between the sides of both overlap, on the same stretch.
    bool meets(const KnotPiece& other) const {
        return constant_u == other.constant_u && begin == other.begin && end == other.end &&
               low <= other.high && other.low <= high;
    }
};

/// A face whose lines are pieces, and the grid of its patches.
class KnottedFace {
public:
    KnottedFace(const SurfaceModel& model, std::uint32_t index)
        : model_(model), index_(index), grid_(model, model.faces[index]) {}

    const SurfaceModel& model() const { return model_; }
    std::uint32_t index() const { return index_; }
    const Face& face() const { return model_.faces[index_]; }
    Box2 domain() const { return grid_.domain(); }
    /// The point at face parameters, not placed; mm.
    Vec3 point(const Vec2& parameters) const;
    /// The sides of a piece, placed. `left` and `right` are its sides as p-curves, to which
    /// references are kept.
    SeamProbe probe(const KnotPiece& piece, const Affine& placed, const std::array<Vec3, 2>& left,
                    const std::array<Vec3, 2>& right) const;

private:
    const SurfaceModel& model_;
    std::uint32_t index_;
    PatchGrid grid_;
};

/// True if the sides of a line break by more than a file's digits explain: above 1e-4 mm, 1e-4
/// degrees or, for their curvatures, 0.1 % and 2e-7 /mm.
bool breaks_at(const SeamPoint& point);

} // namespace keiko
