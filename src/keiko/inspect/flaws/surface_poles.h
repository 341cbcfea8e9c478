#pragma once

#include "keiko/inspect/flaws/face_surface.h"

#include <cstddef>
#include <span>
#include <vector>

namespace keiko {

/// A point around which a surface is smooth, and into which sides of its faces are collapsed.
struct SurfacePole {
    /// A way out of the pole, along a line of constant u or v.
    struct Spoke {
        SheetPoint begin; ///< at the pole
        Vec2 step{0};     ///< of the place, into the face
        Vec3 way{0};      ///< world, mm: what that step leads
    };
    Vec3 position{0}; ///< world, mm
    Vec3 normal{0};   ///< unit, outwards
    std::vector<Spoke> spokes;
};

/// The smooth poles of placed faces. Where normals around a pole differ by more than the angle of
/// a smooth seam, as around the tip of a cone, the surface ends there.
class SurfacePoles {
public:
    SurfacePoles() = default;
    /// `sheets`: the number of the connected surface of each face. Faces of one surface share their
    /// poles.
    SurfacePoles(std::span<const FaceSurface> faces, std::span<const std::size_t> sheets);

    /// The poles of a face, as indices of at().
    std::span<const std::size_t> of(std::size_t face) const { return of_face_[face]; }
    const SurfacePole& at(std::size_t index) const { return poles_[index]; }

private:
    std::vector<SurfacePole> poles_;
    std::vector<std::vector<std::size_t>> of_face_;
};

} // namespace keiko
