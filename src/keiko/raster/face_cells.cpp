#include "keiko/raster/face_cells.h"

#include <algorithm>

namespace keiko {
namespace {

/// Range of a face parameter over a patch.
std::pair<double, double> range(const ParameterMap& map) {
    return {map.to_face(0), map.to_face(1)};
}

} // namespace

FaceCells::FaceCells(const SurfaceModel& model, const Face& face, double deviation,
                     std::size_t most)
    : model_(model), first_patch_(face.first_patch) {
    for (std::uint32_t p = 0; p < face.patch_count; ++p) {
        bounds_.push_back(SecondDerivativeBounds::of(model.patch(first_patch_ + p)));
        const SpanCells cells = bounds_.back().cells_within(deviation, most);
        int &u = along_u_[range(patch(p).map_u)], &v = along_v_[range(patch(p).map_v)];
        u = std::max(u, cells.u), v = std::max(v, cells.v);
    }
    for (std::uint32_t p = 0; p < face.patch_count; ++p)
        deviation_ = std::max(deviation_, bounds_[p].deviation(of(patch(p))));
}

SpanCells FaceCells::of(const Patch& patch) const {
    return {along_u_.at(range(patch.map_u)), along_v_.at(range(patch.map_v))};
}

std::size_t FaceCells::count() const {
    std::size_t sum = 0;
    for (std::uint32_t p = 0; p < bounds_.size(); ++p) sum += of(patch(p)).count();
    return sum;
}

} // namespace keiko
