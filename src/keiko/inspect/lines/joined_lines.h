#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/seam/seam.h"
#include "keiko/inspect/lines/line_crossing.h"
#include "keiko/inspect/lines/line_endpoint.h"
#include "keiko/inspect/lines/line_geometry.h"
#include "keiko/inspect/lines/surface_lines.h"

#include <vector>

namespace KEIKO_API keiko {

/// A line of one lamp over any number of patches.
struct JoinedLine {
    std::uint32_t plane = 0, lamp = 0; ///< indices of the C-plane and of the lamp on it
    LineEnd begin = LineEnd::hidden, end = LineEnd::hidden; ///< why the line ends there
    std::vector<std::uint32_t> pieces;  ///< into JoinedLines::pieces, in the order along the line
    double length = 0;                  ///< mm, of the chords
    std::vector<LineStatistics> shapes; ///< between the crossings, in order
    /// Inflections in the order of the shapes; at a border where the curvature jumps over 0, the
    /// place there.
    std::vector<LineInflection> inflections;
};

/// The lines of all lamps that are visible on a body from one viewpoint.
struct JoinedLines {
    std::vector<SurfaceLine> pieces;     ///< oriented so that the field rises to their left
    std::vector<JoinedLine> lines;       ///< by plane, lamp and first piece
    std::vector<LineCrossing> crossings; ///< worst first; those without a verdict last
};

/// The seams of a model, prepared for lines.
struct LineSeams {
    std::vector<Seam> seams;                        ///< of the body
    BoundaryCurves curves;                          ///< of the body
    std::vector<std::vector<std::uint32_t>> chains; ///< as returned by seam_chains
    double join_distance = 0;                       ///< mm

    /// `join` in mm.
    LineSeams(const SurfaceModel& model, double join, const Job& job);
};

/// Joins the pieces that surface_lines found for the same planes, camera and kind of lines across
/// the borders of patches and seams, measures each crossing and judges it by the preset. The same
/// for any thread count. Throws Cancelled.
JoinedLines join_lines(const SurfaceModel& model, const LineSeams& seams,
                       std::vector<SurfaceLine> pieces, std::span<const CPlane> planes,
                       const Camera& camera, LineLook look, const CriteriaPreset& preset,
                       const Job& job = {});

} // namespace keiko
