#pragma once

#include "keiko/geometry/model/surface_mesh.h"
#include "keiko/geometry/rays/ray.h"
#include "keiko/math/bounds.h"

#include <array>
#include <optional>
#include <vector>

namespace keiko::bench {

/// Triangles in the cells of a uniform grid, which rays cross one after the other
/// [AmanatidesWoo1987].
class UniformGrid {
public:
    /// About as many cells as triangles. Keeps a reference.
    explicit UniformGrid(const SurfaceMesh& mesh);

    /// Length along a ray of unit direction to the first triangle.
    std::optional<double> first(const Ray& ray) const;

private:
    using Cell = std::array<int, 3>;

    std::size_t number_of(const Cell& cell) const {
        return static_cast<std::size_t>((cell[2] * counts_[1] + cell[1]) * counts_[0] + cell[0]);
    }
    Cell cell_at(const Vec3& point) const;
    /// Side of a cell that a ray leaves by.
    struct Side {
        unsigned axis = 0; ///< across it
        double t = 0;      ///< along the ray
    };
    /// Length along a ray to the grid.
    std::optional<double> entry(const Ray& ray) const;
    Side exit(const Cell& cell, const Ray& ray) const;
    std::optional<double> first_in(const Cell& cell, const Ray& ray) const;

    const SurfaceMesh& mesh_;
    Box3 bounds_;
    Cell counts_{};
    Vec3 size_{0};                                     ///< of a cell
    std::vector<std::vector<std::uint32_t>> in_cells_; ///< triangles whose boxes meet it
};

} // namespace keiko::bench
