#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/inspect/combs/comb_sample.h"

#include <array>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// A point of a curve, and how the curve bends there.
/// A curve on the surface with its curvature all along.
struct CombCurve {
    /// How a curve was requested.
    enum class Kind {
        section, ///< of a plane
        iso_u,   ///< of constant u
        iso_v    ///< of constant v
    };
    Kind kind = Kind::section; ///< of the curve
    std::string name;          ///< of the plane, "y=120", or of the iso-curve, "face 3: u at 0.25"
    std::uint32_t plane = 0;   ///< of sections: index of the requested plane
    bool closed = false;       ///< the last sample is the first one again
    double length = 0;         ///< mm
    std::vector<CombPiece> pieces; ///< from end to end
};

/// A remark on a plane that misses the body, touches it or lies in one of its faces.
struct SectionRemark {
    /// How a plane fails to give a section.
    enum class Kind {
        missed,  ///< it has no point of the body
        touches, ///< it touches a face without cutting it
        within   ///< a face lies in it
    };
    Kind kind = Kind::missed;             ///< of the remark
    std::uint32_t plane = 0;              ///< index of the requested plane
    std::uint32_t instance = 0, face = 0; ///< unless missed: the face that the plane touches or
                                          ///< that lies in it
    Vec3 place{0};                        ///< of touches: mm, world
    std::array<double, 2> reach{};        ///< of missed: the heights of the body, mm
};

/// Result of comb_curves.
struct FoundCombs {
    std::vector<CombCurve> curves;      ///< sections by plane, then iso-curves by face
    std::vector<SectionRemark> remarks; ///< in the order of the planes
};

/// Combs of the sections of planes with the trimmed faces, touching curves included, and of the
/// faces' iso-curves after them. Sections are followed over all seams; one along a border counts
/// once. Each curve is sampled until its comb is accurate to `tolerance`
/// (docs/theory/inspection.md). The result is the same for any thread count. Throws Cancelled.
FoundCombs comb_curves(const SurfaceModel& model, const CombOptions& options, const Job& job = {});

/// Inflections of a curve: changes of sign of its curvature between neighbouring samples,
/// interpolated linearly; not where the curvature jumps at a border.
std::vector<Vec3> inflections_of(const CombCurve& curve);
/// The sample with the largest absolute curvature; requires a curve of comb_curves.
const CombSample& most_bent(const CombCurve& curve);

} // namespace keiko
