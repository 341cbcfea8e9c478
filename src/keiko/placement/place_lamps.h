#pragma once

#include "keiko/base/diagnostics.h"
#include "keiko/base/job.h"
#include "keiko/placement/hit_histogram.h"
#include "keiko/placement/placement_score.h"
#include "keiko/placement/plane_search.h"
#include "keiko/placement/view_samples.h"
#include "keiko/rig/light_rig.h"

#include <span>
#include <string>
#include <vector>

namespace keiko {

struct PlacementOptions {
    int lamps = 12;           ///< on each plane; 0: as many as give the wanted spacing
    int planes = 3;           ///< at most; one more is taken only where it serves enough
    double least_gain = 0.05; ///< share of the picture that another plane must add
    double enough = 0.9;      ///< coverage at which no further plane is looked for
    LampDirection direction = LampDirection::best;
    StripeSpacing spacing; ///< px of a picture 540 high
    Rgb luminance{9000};   ///< cd/m2 of the lamps
    SamplingOptions sampling;
};

/// Lamps on one plane, and what they do for the picture.
struct PlacedPlane {
    CPlane lamps;
    PlacementScore score;
    /// Of the hits in the coordinates of the plane: mm from its origin along u and v. A little
    /// wider than the lamps.
    HitHistogram histogram;
};

/// How much of a face the lamps reach.
struct FaceCoverage {
    std::uint32_t instance = 0, face = 0;
    double share = 0;   ///< of the picture's weight that is this face
    double reached = 0; ///< share of that which mirrors lamps, 0 to 1
};

/// A plane that was tried.
struct PlaneCandidate {
    Vec3 towards{0};     ///< unit, from the middle of what is seen to the plane
    double distance = 0; ///< mm
    PlacementScore score;
};

/// A rig for a picture, and how good it is.
struct Placement {
    LightRig rig;
    double coverage = 0;             ///< share of the picture's weight that mirrors lamps
    std::vector<PlacedPlane> planes; ///< best first; the rig's sources in the same order
    std::vector<FaceCoverage> faces; ///< every face that is seen, the largest unreached part first
    std::vector<PlaneCandidate> candidates; ///< for the first plane, in the order they were tried
    double blocked = 0;                     ///< share of the weight that mirrors the body itself
    Diagnostics diagnostics; ///< a warning for every face of which a large part is not reached
};

/// Hangs parallel lamps so that their mirror images cover what the cameras see of the body: the
/// histogram of mirrored rays on candidate planes chooses plane, rectangle and direction of the
/// lamps; further planes serve what the ones before leave. Lamps never cut the body's box, stand
/// between eye and body as little as possible, and scale with the body. The same input gives the
/// same rig for any thread count. Throws Error where the cameras see no surface, or where no plane
/// serves anything.
Placement place_lamps(const Tracer& tracer, const SurfaceModel& model,
                      std::span<const Camera> cameras, const PlacementOptions& options = {},
                      const Job& job = {});
Placement place_lamps(const Tracer& tracer, const SurfaceModel& model, const Camera& camera,
                      const PlacementOptions& options = {}, const Job& job = {});

/// Diameter of lamps at a pitch, both mm: a T8 tube, but always 0.3 to 0.5 of the pitch, so that
/// stripes stay readable on bodies of any size.
double lamp_diameter(double pitch);

} // namespace keiko
