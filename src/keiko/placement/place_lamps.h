#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/placement/candidate_planes.h"
#include "keiko/placement/lamp_kind.h"
#include "keiko/placement/placement.h"
#include "keiko/placement/plane_search.h"
#include "keiko/placement/view_samples.h"

#include <optional>
#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// Rating of the lamps of a given rig for samples `seen` in pictures of `picture_height` pixels of
/// the model: the same figures as for a placed one, for the rows of rows_of. Other lights are
/// skipped. Throws Error for a rig without such rows, and if the pictures show no surface.
Placement rated_rig(std::vector<ViewSample> seen, const SurfaceModel& model, int picture_height,
                    const LightRig& rig, const StripeSpacing& spacing = {});

/// Options of place_lamps.
struct PlacementOptions {
    LampKind kind = LampKind::tube; ///< what hangs in each row
    int lamps = 12; ///< tubes or bars on each plane; 0: as many as give the wanted spacing
    int planes = 3; ///< at most; one more is added only if it serves enough
    double least_gain = 0.05; ///< share of the picture that another plane must add
    double enough = 0.9;      ///< coverage at which no further plane is searched
    LampDirection direction = LampDirection::best; ///< of the lamps in their plane
    PlaneChoice where;                             ///< planes that are searched
    StripeSpacing spacing;                         ///< px of a picture 540 high
    /// Plane of symmetry of the lamps: each row is its own image, or two rows are images of each
    /// other. It is for views and a body that are symmetric too, and without planes given as
    /// frames.
    std::optional<MirrorPlane> mirror{};
    Rgb luminance{9000};      ///< cd/m2 of the lamps
    SamplingOptions sampling; ///< of the pictures
};

/// Places parallel lamps so that their reflections cover the visible part of the body. The
/// histogram of reflected rays on candidate planes selects plane, rectangle and direction of the
/// lamps. Further planes serve the samples that the ones before leave uncovered. Lamps never cut
/// the body's box, stand between camera and body as little as possible, and scale with the body.
/// The same input gives the same rig for any thread count. Throws Error if the cameras see no
/// surface, or if no plane serves anything.
Placement place_lamps(const Tracer& tracer, const SurfaceModel& model,
                      std::span<const Camera> cameras, const PlacementOptions& options = {},
                      const Job& job = {});
/// Placement for a single camera.
Placement place_lamps(const Tracer& tracer, const SurfaceModel& model, const Camera& camera,
                      const PlacementOptions& options = {}, const Job& job = {});
/// Placement from samples `seen` in pictures of `picture_height` pixels of the model, whose faces
/// lie in `body`; uses all options except `sampling`.
Placement place_lamps(std::vector<ViewSample> seen, const SurfaceModel& model, const Box3& body,
                      int picture_height, const PlacementOptions& options = {},
                      const Job& job = {});

/// Diameter of lamps at a pitch, both mm: a T8 tube, but always 0.3 to 0.5 of the pitch, so that
/// stripes stay readable on bodies of any size.
double lamp_diameter(double pitch);

} // namespace keiko
