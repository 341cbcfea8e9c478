#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/seam/seam.h"
#include "keiko/inspect/basics/face_limits.h"
#include "keiko/inspect/basics/verdict.h"
#include "keiko/inspect/lines/line_endpoint.h"
#include "keiko/inspect/lines/line_geometry.h"
#include "keiko/inspect/lines/surface_lines.h"
#include "keiko/scene/criteria_preset.h"

#include <optional>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

// The lines of lamps joined over seams, and their crossings with these.

/// Two ends that are one line: the tail of a piece and the head of the next.
struct LinePair {
    std::uint32_t tail = 0, head = 0; ///< into the meetings
};

/// Pairs of tails and heads that continue each other. Both belong to one lamp and to the two sides
/// of one border, or to different seams of a place where several meet. Their distance along the
/// border is within what the gap and the jump of the field between the sides allow, and that jump
/// is about the same at both. The nearest are joined first, each end once. Borders with more than
/// `crease` degrees are not crossed. Apart from exact ties, the result does not depend on the order
/// of the meetings.
std::vector<LinePair> pair_meetings(std::span<const LineEndpoint> meetings, double crease);

/// A signed number, judged by its size.
struct LineValue {
    double value = 0;                ///< largest value found
    double bound = 0;                ///< the exact value lies within this of it
    std::optional<double> limit;     ///< nullopt: not judged
    Verdict verdict = Verdict::pass; ///< by value, bound and limit
};

/// Crossing of a line with a seam, or the break of a line inside a face. Values are those of the
/// side that the line goes to, less those of the side that it comes from; to the left is positive.
struct LineCrossing {
    std::uint32_t line = 0; ///< into JoinedLines::lines
    /// Index into JoinedLines::pieces; if the line is not continued, the piece that ends or begins
    /// here.
    std::uint32_t from = 0;
    /// The next piece; no_index if there is none, as the other side reflects the lamp elsewhere.
    std::uint32_t to = no_index;
    std::uint32_t plane = 0, lamp = 0; ///< indices of the C-plane and of the lamp on it
    LineBorder border;                 ///< that the line crosses
    std::string faces;                 ///< "face 12 (hood) | face 13"
    Vec3 place{0};                     ///< world, mm, on the side that the line comes from
    double gap = 0;                    ///< mm
    double angle = 0;                  ///< degrees between the normals
    /// Jump of the lamp's image, mm on the C-plane (the change of the cosine for isophotes).
    double plane_jump = 0;
    LineValue jump; ///< mm on the part, across the line
    LineValue turn; ///< degrees of a seam angle that moves the image as far as the jump
    LineValue kink; ///< degrees, on the surface: its fold counts for nothing
    LineValue bend; ///< 1/mm, of geodesic curvature
    /// True at a run-out of a crease, whose fading is judged with the crease and not here.
    bool run_out = false;
    /// Verdict on the crossing. nullopt at a run-out, and if no piece follows and the image's jump
    /// alone is within its limit.
    std::optional<Verdict> verdict;
    double severity = 0; ///< ratio of the worst judged value to its limit: 1 at the limit

    /// True if the line goes on behind the border.
    bool continued() const { return to != no_index; }
};

/// Measures the crossing at which the line of `tail` continues in that of `head`.
LineCrossing line_crossing(const LineEndpoint& tail, const LineEndpoint& head,
                           const LampLevels& lamps, const LineLimits& limits);

/// Measures an end of a line without continuation: only the jump of the image and the seam angle
/// that equals it.
LineCrossing line_break(const LineEndpoint& end, const LampLevels& lamps, const LineLimits& limits);

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
    std::size_t out_of_scope = 0; ///< crossings between faces that are not judged: not listed
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

/// Joins the pieces that surface_lines found for the same sources, camera and kind of lines across
/// the borders of patches and seams, measures each crossing and judges it by the limits there. The
/// same for any thread count. Throws Cancelled.
JoinedLines join_lines(const SurfaceModel& model, const LineSeams& seams,
                       std::vector<SurfaceLine> pieces, std::span<const LineSource> sources,
                       const Camera& camera, LineLook look, const FaceLimits& limits,
                       const Job& job = {});

} // namespace keiko
