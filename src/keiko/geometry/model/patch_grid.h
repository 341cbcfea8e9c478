#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/model/surface_model.h"

#include <cstdint>
#include <vector>

namespace KEIKO_API keiko {

/// The patches of one face as the grid that they form over the face's parameter plane. A patch may
/// cover several cells of it, as adaptive approximation produces them.
class PatchGrid {
public:
    /// Grid of the patches of one face; keeps references.
    PatchGrid(const SurfaceModel& model, const Face& face);

    /// Index into SurfaceModel::patches of the patch that holds a point of the parameter plane;
    /// outside of the grid the nearest patch. On a line between patches it is the one that the
    /// direction `toward` points into. A border along a knot line is thus read from the side of its
    /// material.
    std::uint32_t locate(const Vec2& point, const Vec2& toward) const;
    /// The rectangle of face parameters that the patches cover.
    Box2 domain() const;
    /// Number of lines between patches that pass through a box of the parameter plane.
    int lines_through(const Box2& box) const;

    /// Squared extent in mm2 of a patch of this face, to which its du x dv is compared.
    double square_size(std::uint32_t patch) const { return square_sizes_[patch - first_patch_]; }

private:
    std::uint32_t first_patch_ = 0;
    std::vector<double> square_sizes_; ///< a patch
    std::vector<double> breaks_u_, breaks_v_;
    std::vector<std::uint32_t> patches_; ///< u outer
};

/// A place of a patch.
struct PatchPlace {
    std::uint32_t patch = 0; ///< into SurfaceModel::patches
    Vec2 uv{0};              ///< its own parameters, 0 to 1
};

/// The place of a face at face parameters; of those outside of its grid, the nearest of the grid.
/// `grid`: of the face.
PatchPlace place_at(const SurfaceModel& model, const PatchGrid& grid, const Vec2& parameters);

} // namespace keiko
