#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/inspect/basics/line_field.h"
#include "keiko/inspect/basics/patch_lines.h"

#include <memory>
#include <vector>

namespace KEIKO_API keiko {

/// A curve on one face along which it turns away from a viewpoint: its contour generator
/// [CipollaGiblin2000].
struct ContourLine {
    std::uint32_t instance = 0; ///< into SurfaceModel::instances
    std::uint32_t face = 0;     ///< into SurfaceModel::faces
    bool closed = false;        ///< the last point is the first one again
    bool proved = true;         ///< false where the search could not decide a part of its course
    double length = 0;          ///< mm
    double deviation = 0;       ///< mm, about the largest distance between curve and chords
    std::vector<Vec3> points{}; ///< world, mm, on the exact surface
};

/// A piece of a contour generator on one patch, with its exact course between the points.
struct PatchContour {
    std::uint32_t instance = 0, face = 0, patch = 0; ///< into the model's arrays
    PatchLine line;                                  ///< its points lie on the exact curve
    /// The function on the patch whose zeros they are.
    std::shared_ptr<const ZeroFunction> function;
};

/// The contours of the trimmed faces of a model patch by patch, hidden ones too, not joined. A side
/// of a patch that is edge-on all along is one of them, once a face. `chord_error` in mm. Ordered
/// by instance, face and patch, the same for any number of threads. Reports stage "contours".
/// Throws Cancelled.
std::vector<PatchContour> patch_contours(const SurfaceModel& model, const LineEye& eye,
                                         double chord_error = 0.01, const Job& job = {});

/// Every contour curve of the trimmed faces of a model, hidden ones too: where the normal is square
/// to the line of sight. Faces end at their borders, so that edges at which two faces turn away
/// from each other are not among them. Curves shorter than 0.01 mm are left out. `chord_error` in
/// mm. Ordered by instance, face and falling length, the same for any number of threads. Reports
/// stage "contours". Throws Cancelled.
std::vector<ContourLine> contour_curves(const SurfaceModel& model, const LineEye& eye,
                                        double chord_error = 0.01, const Job& job = {});

} // namespace keiko
