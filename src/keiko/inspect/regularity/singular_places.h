#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/inspect/basics/verdict.h"

#include <vector>

namespace KEIKO_API keiko {

/// A place of a face at which its surface is not regular.
struct SingularPlace {
    /// Kind of the singularity.
    enum class Kind {
        fold,       ///< the normal turns over: the face folds back on itself
        no_limit,   ///< the normals about it have no limit: a kink that ends, or a tip
        unresolved, ///< not proved regular within the bound on work
        uneven, ///< the weights of a patch differ by more than 1e4: what is measured at steps of
                ///< its parameters may miss parts of it
        uneven_border ///< those of a trim curve differ by more than 1e6: numbers do not tell its
                      ///< places apart finely enough, and its seams may not be found
    };
    Kind kind = Kind::no_limit; ///< what is singular there
    double angle = 0;           ///< degrees: between two normals at the place; 180 of a fold
    double extent = 0;          ///< mm: diagonal of the box of all such places of the face
    Vec3 place{0};              ///< world, mm: where the angle is largest
};

/// Verdict on a face with such a place. A fold fails. A face that is not proved regular or has very
/// unequal weights is undecided. A place without a limit is no part of it.
Verdict verdict_of(SingularPlace::Kind kind);

/// Thresholds from which places count.
struct SingularLimits {
    double negligible = 0.1; ///< mm: smaller features cannot be distinguished from a regular place
    double angle = 0.1;      ///< degrees: normals within this angle count as one
};

/// The places of a placed face, within its trims, at which it is not regular: one of each kind, the
/// largest angle first. Each of its patches is cut until each part is proved regular: the Bernstein
/// coefficients of S_u x S_v lie all on one side of a plane. Sides along which S_u x S_v is 0 are
/// divided out. An unproved part up to the negligible length is judged by the normals around it.
/// Sides of patches that are points, as at poles and the tips of cones, have no places without a
/// limit within three times that length. In patches with such a side a fold is one whose parts are
/// as wide as that length; narrower ones are places without a limit. `most_cuts` bounds the work:
/// where it does not do, the face has a place of the kind `unresolved`. Patches and
/// trim curves of very unequal weights are listed whatever their form.
std::vector<SingularPlace> singular_places(const SurfaceModel& model, std::uint32_t instance,
                                           std::uint32_t face, const SingularLimits& limits,
                                           std::size_t most_cuts = 20000);

} // namespace keiko
