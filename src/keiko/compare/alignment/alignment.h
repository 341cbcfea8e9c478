#pragma once

#include "keiko/base/export.h"
#include "keiko/compare/alignment/closest_point_query.h"

namespace KEIKO_API keiko {

/// The rigid motion that brings a body onto another.
struct Alignment {
    Affine motion;    ///< to be applied to the body
    Vec3 axis{0};     ///< unit, of the rotation; 0 where there is none
    double angle = 0; ///< degrees about it
    Vec3 shift{0};    ///< mm, of the body's centre of area
    double residual =
        0;         ///< mm, root mean square distance that is left of the places it was found by
    int steps = 0; ///< of the iteration
    bool converged = false; ///< the last step was smaller than rounding
};

/// A motion by its rotation and the shift of `centre`, as found in no step.
Alignment alignment_of(const Affine& motion, const Vec3& centre);

/// Options of an alignment.
struct AlignmentOptions {
    std::size_t samples = 3000; ///< about as many places of the body, or points at most
    int most_steps = 200;       ///< of the iteration, at most
};

/// Least squares over places spread evenly on the body: Gauss and Newton's iteration on their exact
/// distances to the other (iterated closest points with tangent planes [ChenMedioni1992]). Borders
/// weigh a thousandth: they settle only what the surfaces leave free. It starts from the best of
/// where the body is, its centre on the other's, and the four turns that lay principal axes on each
/// other, each tried on samples first. The same for any number of threads. Reports stage "align".
/// Throws FieldError("align") for a body with too little material to find a place of it; Cancelled.
Alignment align_bodies(const ClosestPointQuery& body, const ClosestPointQuery& other,
                       const AlignmentOptions& options = {}, const Job& job = {});

} // namespace keiko
