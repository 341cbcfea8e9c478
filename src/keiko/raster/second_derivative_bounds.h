#pragma once

#include "keiko/geometry/bezier/bezier.h"
#include "keiko/math/bounds.h"

#include <cstddef>

namespace keiko {

/// Cells into which a patch is divided in each of its parameters.
struct SpanCells {
    int u = 1, v = 1; ///< at least 1

    /// Patch parameters of a cell, counted from 0.
    Box2 box(int i, int j) const;
    /// Number of all.
    std::size_t count() const { return static_cast<std::size_t>(u) * static_cast<std::size_t>(v); }
};

/// Bounds of the sizes of the second derivatives of a patch by its parameters, mm.
struct SecondDerivativeBounds {
    double uu = 0; ///< by u
    double uv = 0; ///< mixed
    double vv = 0; ///< by v

    /// Bounds over all of a patch, by Bernstein coefficients of its parts. Weights must be
    /// positive.
    static SecondDerivativeBounds of(const BezierPatchView& patch);
    /// mm by which no place of the patch is farther from a triangle than this, if the triangle's
    /// corners lie on the patch within one cell and interpolate it there [Filip1986].
    double deviation(const SpanCells& cells) const;
    /// The fewest cells, about, with at most this deviation, mm; if those are more than `most`, at
    /// most 1e9, then others in number more than that.
    SpanCells cells_within(double deviation, std::size_t most) const;
};

} // namespace keiko
