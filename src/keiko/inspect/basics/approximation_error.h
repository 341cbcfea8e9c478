#pragma once

#include "keiko/geometry/model/surface_model.h"

namespace keiko {

/// How far a face may be off the file's in its points and in what derivatives tell. An
/// estimate, from the error of its points.
struct ApproximationError {
    double position = 0;        ///< mm
    double angle = 0;           ///< degrees, of the normal
    double curvature = 0;       ///< 1/mm
    double curvature_slope = 0; ///< 1/mm2, along the surface

    /// The error of a difference between two sides.
    ApproximationError operator+(const ApproximationError& other) const {
        return {position + other.position, angle + other.angle, curvature + other.curvature,
                curvature_slope + other.curvature_slope};
    }
};

/// The error of a face that approximates one of the file, placed with this scale. All 0 for an
/// exact face, and for one at an irregular point of a cage, which is judged by other rules
/// (docs/theory/inspection.md).
ApproximationError approximation_error(const SurfaceModel& model, std::uint32_t face,
                                       double scale = 1);

/// The factor by which an instance enlarges its part.
double scale_of(const Instance& instance);

/// True if a face has patches at irregular points of a cage.
bool has_irregular_patch(const SurfaceModel& model, std::uint32_t face);

} // namespace keiko
