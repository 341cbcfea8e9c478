#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/model/surface_model.h"

#include <optional>

namespace KEIKO_API keiko {

/// The largest or smallest curvature over a face.
struct CurvatureExtreme {
    double value = 0;       ///< 1/mm, or 1/mm2 of a Gaussian curvature
    double bound = 0;       ///< the true extreme lies at most this far beyond the value
    Vec3 place{0};          ///< world, mm
    bool undecided = false; ///< the bound stayed wider than curvature_tolerance requires
};

/// Tolerance of an extreme, as a share of the larger of it and the curvature of a sphere as large
/// as the face.
constexpr double curvature_tolerance = 1e-3;

/// The extremes of the curvatures of a placed face within its trims; positive where the surface
/// bends towards its outward normal.
struct FaceCurvature {
    CurvatureExtreme largest, smallest;                   ///< of both principal curvatures
    CurvatureExtreme largest_mean, smallest_mean;         ///< of the mean curvature
    CurvatureExtreme largest_gaussian, smallest_gaussian; ///< of the Gaussian curvature
    double size = 0; ///< mm, diagonal of the box around the face's control points
    /// Extent in mm of the surroundings of places such as a pole in which curvatures are unknown,
    /// because the parametrisation is singular there; 0 if the face has none.
    double singular = 0;
};

/// Finds the extremes by branch and bound with interval bounds of the curvatures
/// (docs/theory/inspection.md). They are accurate to curvature_tolerance if `most_splits` cuts of
/// pieces, and one a patch, suffice; `bound` states the accuracy reached. nullopt for a face that
/// its trims leave no material of.
std::optional<FaceCurvature> face_curvature(const SurfaceModel& model, std::uint32_t instance,
                                            std::uint32_t face, std::size_t most_splits = 5000);

} // namespace keiko
