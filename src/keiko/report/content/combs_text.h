#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/combs/comb_curves.h"

#include <span>
#include <string>

namespace KEIKO_API keiko {

/// keiko-combs/1: every curve with its length, its largest curvature, its inflections and its
/// samples, and the remarks on planes.
std::string combs_json(const FoundCombs& combs, std::span<const SectionPlane> planes,
                       const SurfaceModel& model, const std::string& tool_version);

/// Remarks for the user on planes that miss the body, touch it, or contain faces: a line a plane
/// and kind.
std::vector<std::string> comb_remarks(const FoundCombs& combs, std::span<const SectionPlane> planes,
                                      const SurfaceModel& model);

/// CSV with a header, then a row a sample.
std::string combs_csv(std::span<const CombCurve> curves, const SurfaceModel& model);

/// One SVG picture of curves with a tooth at each sample, on the side away from which the curve
/// bends. `normal`: the direction towards the viewer, unit. The scale is written in it: the tooth
/// of a round curvature near the largest usual one. Longer teeth, of 2 % of the samples at most,
/// are cut and red.
std::string combs_svg(std::span<const CombCurve> curves, const Vec3& normal,
                      const std::string& title);

/// Picture of combs as a file.
struct CombPicture {
    std::string name; ///< "y=120", or "iso-curves"
    std::string svg;  ///< bytes of the file

    /// Name of its file.
    std::string file_name() const { return "combs-" + name + ".svg"; }
};
/// A picture of each plane, then one of the iso-curves from three quarters; those that exist.
std::vector<CombPicture> comb_pictures(std::span<const CombCurve> curves,
                                       std::span<const SectionPlane> planes);

} // namespace keiko
