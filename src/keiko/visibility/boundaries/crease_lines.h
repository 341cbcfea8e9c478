#pragma once

#include "keiko/geometry/model/surface_curve.h"

#include <array>
#include <optional>
#include <vector>

namespace keiko {

/// A side of a placed patch inside its face, along which the face's normal jumps.
struct CreaseLine {
    std::uint32_t instance = 0, face = 0;
    std::array<Vec3, 2> p_curve; ///< homogeneous, face parameters, the patch on its left
};

/// The creases inside the faces of a model, each once from either side. A jump is one of more than
/// 1e-9 rad at any of nine places of a side. Looks into the model it was made from.
class CreaseLines {
public:
    explicit CreaseLines(const SurfaceModel& model);

    const std::vector<CreaseLine>& all() const { return lines_; }
    SurfaceCurve curve(const CreaseLine& line) const;
    /// Unit, tangent to the surface on the other side of the line, from its place at t into that.
    std::optional<Vec3> inward_beyond(const CreaseLine& line, double t) const;

private:
    bool normal_jumps(std::uint32_t patch, const CreaseLine& line) const;

    const SurfaceModel* model_;
    std::vector<PatchGrid> grids_; ///< a face
    std::vector<CreaseLine> lines_;
};

} // namespace keiko
