#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/model/patch_grid.h"
#include "keiko/inspect/seams/seam_probe.h"

#include <array>
#include <tuple>
#include <vector>

namespace KEIKO_API keiko {

/// A stretch of a line of constant u or v inside a face, in face parameters. It includes the
/// parameters at which its two sides are evaluated: its own, or others beside it if the line is a
/// bend.
struct KnotPiece {
    bool constant_u = true;            ///< else v is constant
    double at = 0, begin = 0, end = 0; ///< the constant parameter, and the range of the other
    double low = at, high = at;        ///< parameters of the two sides; low <= high
    bool has_limits = true;            ///< the curvatures of its sides are their limits at the line

    /// True if its sides are evaluated beside the line.
    bool is_bend() const { return low < high; }
    /// Key by which pieces are ordered.
    auto order() const { return std::tuple(!constant_u, at, begin, end); }
    /// The point at `x` of a line of the constant parameter `line`.
    Vec2 point(double line, double x) const { return constant_u ? Vec2(line, x) : Vec2(x, line); }
    /// Its left or right side, in its direction: a p-curve.
    std::array<Vec3, 2> side(bool left) const {
        const double line = left == constant_u ? low : high;
        const Vec2 a = point(line, begin), b = point(line, end);
        return {Vec3(a.x, a.y, 1), Vec3(b.x, b.y, 1)};
    }
    /// Its part between two shares of its length.
    KnotPiece part(double from, double to) const {
        KnotPiece result = *this;
        result.begin = begin + from * (end - begin), result.end = begin + to * (end - begin);
        return result;
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
    /// The face with this index of a model, to which a reference is kept.
    KnottedFace(const SurfaceModel& model, std::uint32_t index)
        : model_(model), index_(index), grid_(model, model.faces[index]) {}

    /// The model of the face.
    const SurfaceModel& model() const { return model_; }
    /// Index of the face in the model.
    std::uint32_t index() const { return index_; }
    /// The face itself.
    const Face& face() const { return model_.faces[index_]; }
    /// Range of the face parameters.
    Box2 domain() const { return grid_.domain(); }
    /// The point at face parameters, not placed; mm.
    Vec3 point(const Vec2& parameters) const;
    /// A tangent of the line of constant u or v through face parameters, not placed; of any length.
    Vec3 along(const Vec2& parameters, bool constant_u) const;
    /// A side of a piece, placed; its p-curve, to which a reference is kept.
    SurfaceCurve side(const std::array<Vec3, 2>& p_curve, const Affine& placed, bool left) const {
        return {model_, grid_, placed, {p_curve}, left};
    }
    /// The sides of a piece, placed. `left` and `right` are its sides as p-curves, to which
    /// references are kept.
    SeamProbe probe(const KnotPiece& piece, const Affine& placed, const std::array<Vec3, 2>& left,
                    const std::array<Vec3, 2>& right) const;

private:
    /// In the parameters of the patch that holds the place.
    SurfaceDerivatives derivatives(const Vec2& parameters, int order) const;
    const SurfaceModel& model_;
    std::uint32_t index_;
    PatchGrid grid_;
};

/// True if the sides of a line break by more than a file's digits explain: above 1e-4 mm, 1e-4
/// degrees or, for their curvatures, 0.1 % and 2e-7 /mm.
bool breaks_at(const SeamPoint& point);

/// Places of a stretch, in (0, 1), rising, at which a quantity is sampled that varies along it like
/// a polynomial of a degree below `count`: the Chebyshev nodes. Such a polynomial that is near 0 at
/// all of them is near 0 all along.
std::vector<double> isoline_places(int count);

/// The sides of a face's patches along which it breaks (breaks_at), regardless of its trims, and
/// those at which it is torn: open by more than 1e-4 mm.
struct BrokenKnots {
    std::vector<KnotPiece> pieces, torn; ///< broken sides, and those of them that are torn
};

/// Broken sides of a face. Each side is tested at 4 n places, n the degree along it. The tangents
/// on either side and the one along it span a volume of degree 4 n - 1: no kink is 0 at all of the
/// places and not in between. A break of the curvatures alone may be missed.
/// Of a face whose approximation may hide a break all inner sides count.
BrokenKnots broken_knots(const KnottedFace& face);

/// The lines that remain of pieces within the trims of a face: every stretch in the material,
/// however short, cut where the trim curves cross the piece. Both sides of a bend are in the
/// material. Stretches that touch on one line follow each other in a chain.
std::vector<std::vector<KnotPiece>> knot_chains(const SurfaceModel& model, const Face& face,
                                                const std::vector<KnotPiece>& pieces);

} // namespace keiko
