#pragma once

#include "keiko/base/export.h"
#include "keiko/base/output_folder.h"
#include "keiko/compare/alignment/alignment.h"
#include "keiko/compare/compare_inspections.h"
#include "keiko/compare/line_shift.h"
#include "keiko/compare/outlines/outline_difference.h"
#include "keiko/compare/shape/deviation.h"
#include "keiko/report/content/picture_outcome.h"

#include <optional>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Tolerances within which two bodies count as the same.
struct BodyTolerance {
    double deviation = 5e-4;      ///< mm
    double border = 1e-3;         ///< mm: p-curves that are recomputed differ by about as much
    double normal = 0.01;         ///< degrees between the normals
    double line = 0.1;            ///< mm that a reflection line may move on the part
    double outline = 0.01;        ///< mm that an outline may move on the part, or
    double outline_pixels = 0.05; ///< of the picture, whichever is more
};

/// The pictures and lines of both bodies in one view.
struct ComparedView {
    PictureOutcome picture;               ///< without the pixels that the outlines excuse
    OutlineDifference outlines{};         ///< of those in which the pictures differ
    std::string map{};                    ///< name of the PNG file of the signed distance map
    int map_width = 0, map_height = 0;    ///< pixels of the map
    std::vector<LineShift> lines{};       ///< of the former, each compared with the latter's
    std::vector<LineShift> after_lines{}; ///< of the latter, each compared with the former's
};

/// Comparison of two revisions of a part.
struct Comparison {
    std::string tool_version;             ///< version of Keiko that compared
    std::string before, after;            ///< files
    BodyTolerance tolerance{};            ///< by which the bodies are judged
    std::optional<Alignment> alignment{}; ///< motion of the latter, if alignment was requested
    Deviation deviation{};                ///< of the latter from the former
    Deviation missing{};                  ///< of the former from the latter: the missing parts
    std::vector<std::string> faces_before{}, faces_after{}; ///< names, as Deviation::faces
    Inspection inspection_before{}, inspection_after{};     ///< of the former and of the latter
    InspectionDifference seams{};                           ///< of both inspections
    std::string rig{};                 ///< that of the views: a file, or how the lamps were found
    std::vector<ComparedView> views{}; ///< one a view
    FolderContent pngs{};              ///< that the views name

    /// True if every check of comparison_checks is within its tolerance.
    bool same() const;
};

/// One criterion of the comparison of two revisions.
struct ComparisonCheck {
    std::string name;    ///< "deviation", "seams", "front: lines"
    bool within = true;  ///< the criterion holds
    std::string message; ///< one sentence, within or not
    bool judged = true;  ///< false: there was nothing to compare with; it is not within either
};

/// All judged criteria except the pictures, which report themselves.
std::vector<ComparisonCheck> comparison_checks(const Comparison& comparison);

/// Names of faces of one revision that the other does not have, and of those of the latter with
/// their inside outside.
std::vector<std::string> faces_gone(const Comparison& comparison);
/// Names of faces of the latter that the former does not have.
std::vector<std::string> faces_new(const Comparison& comparison);
/// Names of faces of the latter with their inside outside.
std::vector<std::string> faces_turned(const Comparison& comparison);

/// True if no line of a view has moved farther than the tolerance, appeared or disappeared.
bool lines_within(const ComparedView& view, const BodyTolerance& tolerance);
/// True if a line has no partner for more of its length than its ends may wander.
bool is_alone(const LineShift& line);

/// The comparison for people, in a few lines; the same text for any number of threads.
std::string comparison_text(const Comparison& comparison);
/// The comparison as "keiko-comparison/1"; see docs/file-formats.md. It holds no times: every run
/// gives the same bytes.
std::string comparison_json(const Comparison& comparison);
/// The comparison as a self-contained page, pictures included: verdict first.
std::string comparison_html(const Comparison& comparison);
/// The comparison for build servers: one suite; a case a check, new finding, view and layer.
std::string comparison_junit(const Comparison& comparison);

/// "0.012 mm", "< 1e-9 mm", or "further than 50 mm" for infinity.
std::string distance_words(double value, double reach);
/// "at most 0.012 mm", "< 1e-9 mm", or "further than 50 mm".
std::string at_most(double value, double reach);
/// Difference of the pictures of a view in words.
std::string picture_words(const PictureOutcome& picture);
/// "turned by 0.25 degrees about (0, 0, 1), its centre shifted by (3, -2, 1) mm; ..."
std::string alignment_words(const Alignment& alignment);
/// "(1.5, 0, -2)", each number with as many digits.
std::string triple(const Vec3& v, int digits);

} // namespace keiko
