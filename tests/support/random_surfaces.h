#pragma once

#include "keiko/geometry/bezier/nurbs.h"

#include "tests/support/random_patches.h"

#include <vector>

namespace keiko::test {

/// Properties of a random face.
struct SurfaceKind {
    int degree_u = 3, degree_v = 3;
    int spans_u = 1, spans_v = 1;
    double rough = 15;     ///< mm of noise on control points about 100 mm apart in all
    double weights = 1;    ///< ratio of the largest weight to the least
    Vec3 offset{0};        ///< mm, where the face is
    double length_u = 100; ///< mm; the other side is 100 mm
    bool trimmed = false;
    bool placed = false; ///< turned, mirrored every other time, stretched and sheared
    double shear = 0.5;  ///< of a placement, at most
};

/// A sheet about the square [-50, 50]^2 with inner knots at random places, of random multiplicity
/// up to the degree (where the surface may have a crease). Face parameters are [0, 1]^2.
NurbsSurface random_nurbs(Random& random, const SurfaceKind& kind);

/// The patches of a surface, for ShapeBuilder::face.
std::vector<PatchData> patches_of(const NurbsSurface& surface);

/// A border with a rounded corner, and holes in it, in [0, 1]^2.
std::vector<LoopData> random_loops(Random& random);

/// A placement in the world that is no rigid motion.
Affine random_placement(Random& random, double shear = 0.5);

/// One random face.
SurfaceModel random_face(Random& random, const SurfaceKind& kind);

} // namespace keiko::test
