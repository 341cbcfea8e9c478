#pragma once

#include "keiko/geometry/model/surface_model.h"

#include <optional>

namespace keiko {

/// A curvature where it is largest or smallest over a face.
struct CurvatureExtreme {
    double value = 0;       ///< 1/mm, or 1/mm2 of a Gaussian curvature
    double bound = 0;       ///< the true extreme lies at most this far beyond the value
    Vec3 place{0};          ///< world, mm
    bool undecided = false; ///< the bound stayed wider than curvature_tolerance asks for
};

/// Of an extreme, as a share of the larger of it and what a sphere as large as the face has.
constexpr double curvature_tolerance = 1e-3;

/// The extremes of the curvatures of a placed face over what its trims leave of it; positive where
/// the surface bends towards its outward normal.
struct FaceCurvature {
    CurvatureExtreme largest, smallest; ///< of both principal curvatures
    CurvatureExtreme largest_mean, smallest_mean;
    CurvatureExtreme largest_gaussian, smallest_gaussian;
    double size = 0; ///< mm, diagonal of the box around the face's control points
    /// mm: the face has places, such as a pole, within which nothing is known because its
    /// parametrisation is singular there; 0 where it has none.
    double singular = 0;
};

/// Finds the extremes by branch and bound with interval bounds of the curvatures
/// (docs/theory/inspection.md), to curvature_tolerance where `most_splits` cuts of
/// pieces, and one a patch, suffice; `bound` tells what was reached. Nothing for a face that trims
/// leave nothing of to look at.
std::optional<FaceCurvature> face_curvature(const SurfaceModel& model, std::uint32_t instance,
                                            std::uint32_t face, std::size_t most_splits = 5000);

} // namespace keiko
