#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/math/bounds.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace keiko {

/// Nodes on a placed face and above them along its outward normal, in rows and columns of equal
/// steps of its parameters.
struct ShellLattice {
    std::uint32_t instance = 0, face = 0; ///< into the model's arrays
    int cells_u = 1, cells_v = 1;         ///< of the lattice
    Box2 domain{};                        ///< face parameters of all of it
    bool limited = false;                 ///< its cells are longer or deviate more than they should
    std::vector<Vec3> foot{}, top{};      ///< mm, in the scene, v fastest

    /// Index of a node.
    std::size_t index(int i, int j) const {
        return static_cast<std::size_t>(i) * static_cast<std::size_t>(cells_v + 1) +
               static_cast<std::size_t>(j);
    }
    /// Face parameters of a place in cells from the first node.
    Vec2 parameters(double u, double v) const {
        return domain.lower + domain.extent() * Vec2(u / cells_u, v / cells_v);
    }
    /// mm, the mean length of the lines along u and along v at the foot.
    Vec2 lengths() const;
};

/// Limits of the cells of a shell.
struct ShellCells {
    double longest = 1000;  ///< mm, of an edge
    double deviation = 0.1; ///< mm, of cells from the surface, and from the surface above it
    int most_along = 256;   ///< cells along u or v: beyond them cells are longer, and deviate more
};

/// Lattice of a face of a model as an instance places it, for a shell of a thickness in mm.
ShellLattice shell_lattice(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face,
                           double thickness, const ShellCells& cells);

} // namespace keiko
