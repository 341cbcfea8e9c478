#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_mesh.h"
#include "keiko/math/vec.h"

#include <cstddef>
#include <vector>

namespace keiko {

/// Half of a cube of edge 2 around a point of a surface, divided into square cells. What a cell
/// shows counts by the form factor of the cell: the second method beside exact visible parts
/// [CohenGreenberg1985] (docs/theory/radiosity.md#hemicube).
class Hemicube {
public:
    /// `cells` along an edge of the top: even, 2 to 4096. The sides are half as high. Throws
    /// FieldError for any other number.
    explicit Hemicube(int cells);

    /// Cells along an edge of the top.
    int cells() const { return cells_; }
    /// Form factor of the cell of the top at x from -1 + 2 i / n on, y by j likewise, exact.
    double top(int i, int j) const { return top_[index(i, j)]; }
    /// Form factor of the cell of a side at y from -1 + 2 i / n on, z from 2 j / n on, exact.
    double side(int i, int j) const { return side_[index(i, j)]; }

    /// Form factors from an element at `point` with the unit normal to the fronts of the triangles
    /// of a mesh, in their order, then to their backs. A front is where the corners run
    /// anticlockwise. They sum to 1 in a closed scene. Throws Cancelled.
    std::vector<double> form_factors(const SurfaceMesh& mesh, const Vec3& point, const Vec3& normal,
                                     const Job& job = {}) const;

private:
    std::size_t index(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(cells_) +
               static_cast<std::size_t>(i);
    }

    int cells_;
    std::vector<double> top_, side_;
};

} // namespace keiko
