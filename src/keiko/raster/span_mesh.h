#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/bezier/bezier.h"
#include "keiko/geometry/model/model_mesh.h"
#include "keiko/geometry/model/surface_model.h"

namespace keiko {

/// Cells into which a patch is divided in each of its parameters.
struct SpanCells {
    int u = 1, v = 1; ///< at least 1
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
    /// The fewest cells, about, with at most this deviation, mm.
    SpanCells cells_within(double deviation) const;
};

/// Triangles of the material of each face: every patch, a knot span, in a grid of cells of two
/// triangles that no place of the surface leaves by more than `deviation` mm, which is proved.
/// Patches side by side have as many cells along their common side. Cells that trim curves cross
/// are cut along chords. On the surface, no trim curve within the cell is farther from its chord
/// than `deviation`, which is proved too; trims within a millionth of a patch of its border count
/// as on it. Islands and holes smaller than `deviation` may be lost. FaceMesh::deviation is the
/// larger of both bounds. The weights of the model must be positive. Throws Cancelled.
ModelMesh span_mesh(const SurfaceModel& model, double deviation, const Job& job = {});

} // namespace keiko
