#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/inspect/combs/comb_sample.h"
#include "keiko/inspect/combs/section_plane.h"

#include <array>
#include <string>
#include <vector>

namespace keiko {

struct CombSample {
    Vec3 place{0};    ///< world, mm, on the exact surface
    double along = 0; ///< mm from the beginning of the curve, over its chords
    CurveBend bend;   ///< with respect to the face's outward normal
};

/// What of a curve runs over one patch; curvatures may jump from one such piece to the next.
struct CombPiece {
    std::uint32_t instance = 0, face = 0, patch = 0; ///< into the model's arrays
    bool on_border = false; ///< of the patch or the face: what is beyond it has the curve as well
    /// The plane is tangent to the surface all along: the curvature is that of the curve, positive
    /// to the left of the way that the samples run, seen from where the plane's normal points to.
    bool touching = false;
    std::vector<CombSample> samples{};
};

/// A curve on the surface with how it bends all along.
struct CombCurve {
    enum class Kind { section, iso_u, iso_v };
    Kind kind = Kind::section;
    std::string name;        ///< of the plane, "y=120", or of the iso-curve, "face 3: u at 0.25"
    std::uint32_t plane = 0; ///< of sections: into those asked for
    bool closed = false;
    double length = 0; ///< mm
    std::vector<CombPiece> pieces;
};

struct CombOptions {
    std::vector<SectionPlane> planes;
    int iso_curves = 0;        ///< of each face each way, evenly over its parameters
    double chord_error = 0.01; ///< mm
    /// Of a curve's largest curvature (of 1 / the body's size at least): how far a curvature may be
    /// off the straight line between two samples.
    double tolerance = 0.01;
    double join = 0.5; ///< mm, over which sections go on from face to face
};

/// What a plane does beside cutting the body in curves.
struct SectionRemark {
    enum class Kind { missed, touches, within };
    Kind kind = Kind::missed;
    std::uint32_t plane = 0;              ///< into those asked for
    std::uint32_t instance = 0, face = 0; ///< but for missed: that it touches or that lies in it
    Vec3 place{0};                        ///< of touches: mm, world
    std::array<double, 2> reach{};        ///< of missed: the heights of the body, mm
};

struct FoundCombs {
    std::vector<CombCurve> curves; ///< sections by plane, then iso-curves by face
    std::vector<SectionRemark> remarks;
};

/// The curves in which planes cut the trimmed faces or touch them, followed over all seams, each
/// once also where it runs along a border; then the iso-curves of the faces; each sampled until its
/// comb is true to `tolerance` (docs/theory/inspection.md). The same for any thread count. Throws
/// Cancelled.
FoundCombs comb_curves(const SurfaceModel& model, const CombOptions& options, const Job& job = {});

/// Where a curve turns to bend the other way: changes of sign between neighbouring samples, in a
/// straight line between them; not where it jumps at a border.
std::vector<Vec3> inflections_of(const CombCurve& curve);
/// The sample with the largest curvature either way; requires a curve of comb_curves.
const CombSample& most_bent(const CombCurve& curve);

} // namespace keiko
