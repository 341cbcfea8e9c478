#pragma once

#include "keiko/base/error.h"
#include "keiko/base/export.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/placement/hit_histogram.h"
#include "keiko/placement/lamp_field.h"
#include "keiko/placement/lamp_kind.h"
#include "keiko/placement/plane_search.h"
#include "keiko/scene/symmetry.h"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

/// Statistics of the stripes of lamps in the pictures, over all places that reflect them. Spacings
/// are from stripe to stripe, px.
struct StripeStatistics {
    /// Spacings below which a tenth, half and nine tenths of the weight lie; 0 if unknown.
    double narrow = 0, median = 0, wide = 0;
    double in_range = 0;   ///< share of the weight whose spacing is wanted, 0 to 1
    double uniformity = 0; ///< exp(-standard deviation of ln spacing), 1 for uniform stripes
};

/// Statistics of the stripes of lamps on these planes; a place that several planes reach counts for
/// the first.
StripeStatistics stripe_statistics(std::span<const ViewSample> samples,
                                   std::span<const CPlane> planes, const StripeSpacing& wanted);

/// Reason why a place reflects no lamp.
enum class UnreachedBecause {
    beyond_lamps, ///< its reflected ray passes beside all lamps
    blocked,      ///< it reflects the body itself
    hidden        ///< lamps stand between it and the camera
};

/// "beyond the lamps", "mirrors the body", "hidden by lamps"
std::string_view name_of(UnreachedBecause reason);

/// A connected part of a picture that reflects no lamp.
struct UnreachedRegion {
    std::uint32_t view = 0;                                    ///< which of the cameras
    UnreachedBecause because = UnreachedBecause::beyond_lamps; ///< why it reflects none
    double share = 0;                                          ///< of the weight of all pictures
    Vec3 place{0};                    ///< mm: the place on the surface nearest to its middle
    Box3 box;                         ///< mm, of its places on the surface
    std::vector<std::uint32_t> faces; ///< of the model, rising
    Box2 pixels;                      ///< its bounds in the picture
};

/// The regions of at least `least_share`, the largest first.
std::vector<UnreachedRegion> unreached_regions(const LampField& field, double least_share = 0.002);

/// Lamps on one plane, and their benefit for the picture.
struct PlacedPlane {
    CPlane lamps;         ///< in world coordinates
    PlacementScore score; ///< factors of the objective
    /// Histogram of the hits in the coordinates of the plane: mm from its origin along u and v. A
    /// little wider than the lamps.
    HitHistogram histogram;
};

/// Share of a face that the lamps reach.
struct FaceCoverage {
    std::uint32_t instance = 0, face = 0; ///< into the model's arrays
    double share = 0;                     ///< of the picture's weight that is this face
    double reached = 0;                   ///< share of that which reflects lamps, 0 to 1
};

/// A plane that was tested.
struct PlaneCandidate {
    Vec3 towards{0};      ///< unit, from the middle of the visible part to the plane
    double distance = 0;  ///< mm
    PlacementScore score; ///< factors of the objective
};

/// A rig for a picture, and its quality.
struct Placement {
    LightRig rig;                        ///< the lamps that were placed
    LampKind kind = LampKind::tube;      ///< of them; rows of other kinds have no diameter
    std::optional<MirrorPlane> mirror{}; ///< that the rig has been made symmetric about
    double coverage = 0;                 ///< share of the picture's weight that reflects lamps
    std::vector<PlacedPlane> planes;     ///< best first; the rig's lamps in the same order
    StripeStatistics stripes;            ///< over all pictures
    std::vector<FaceCoverage> faces;     ///< every visible face, the largest unreached part first
    std::vector<UnreachedRegion> unreached; ///< the largest first
    std::vector<PlaneCandidate> candidates; ///< for the first plane, in the order of the search
    double blocked = 0;                     ///< share of the weight that reflects the body itself
    Diagnostics diagnostics; ///< a warning for every face with a large unreached part
};

/// Computes the rest of a placement whose rig and planes are known: the coverage in the field, in
/// which all lamps are placed.
void tell_what_is_reached(Placement& placement, const LampField& field, const SurfaceModel& model,
                          const StripeSpacing& wanted);

/// Histogram of the intersections of the reflected rays of all samples with the plane of some
/// lamps.
HitHistogram hit_histogram(const LampField& field, const CPlane& plane);

} // namespace keiko
