#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/raster/second_derivative_bounds.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace keiko {

/// Cells of the patches of a face. Those with the same range of a face parameter have as many along
/// it.
class FaceCells {
public:
    /// Cells within `deviation` mm, or more than `most` of them. Keeps a reference to the model.
    FaceCells(const SurfaceModel& model, const Face& face, double deviation, std::size_t most);

    /// Cells of one of the patches.
    SpanCells of(const Patch& patch) const;
    /// mm, bound of the distance of the face from triangles of the cells.
    double deviation() const { return deviation_; }
    /// Number of the cells of all patches.
    std::size_t count() const;
    /// Bounds of a patch, counted from the first of the face.
    const SecondDerivativeBounds& bounds(std::size_t patch) const { return bounds_[patch]; }

private:
    const Patch& patch(std::uint32_t of_face) const {
        return model_.patches[first_patch_ + of_face];
    }

    const SurfaceModel& model_;
    std::uint32_t first_patch_;
    std::map<std::pair<double, double>, int> along_u_, along_v_; ///< by ranges
    std::vector<SecondDerivativeBounds> bounds_;                 ///< by patch
    double deviation_ = 0;
};

} // namespace keiko
