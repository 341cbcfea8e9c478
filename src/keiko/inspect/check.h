#pragma once

#include "keiko/inspect/curvature/face_measure.h"
#include "keiko/inspect/seams/seam_measure.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace keiko {

struct Opening;
struct Overlap;

/// What surfaces are held to, and its names.
struct Criterion {
    std::string_view code;        ///< [SASIG-PDQ], [VDA4955]: "G-SU-LG"; Keiko's own: "KEIKO-..."
    std::string_view rule;        ///< name in [ISO10303-59], or empty
    std::string_view quantity;    ///< "gap", "angle", "curvature", "curvature_slope", ...
    std::string_view description; ///< one sentence
};

/// The criterion of a code; throws std::out_of_range for one that there is not.
const Criterion& criterion_of(std::string_view code);

/// One criterion held against one seam or face, or against the lines that cross a seam. One that is
/// judged and does not pass is a finding, unless it is only worth a look.
struct Check {
    /// `judged` decides on the verdict with all others; `look` has no part in it.
    enum class Severity { judged, look };

    std::string code;     ///< as Criterion
    std::string rule;     ///< as Criterion
    std::string quantity; ///< as Criterion
    std::string unit;     ///< "mm", "deg", "deg/mm", "1" (a share of 1) or "1/mm"
    std::string formula;  ///< of a curvature mismatch, or empty
    MeasuredValue worst;  ///< value, bound, limit, place, verdict; none where not judged
    bool judged = true;   ///< else `message` says why not
    Severity severity = Severity::judged;
    std::uint32_t seam = no_index; ///< into Inspection::seams; no_index: of a face
    std::uint32_t face = no_index; ///< into Inspection::faces; no_index: of a seam
    std::string view;              ///< of lines: the view that shows them; else empty
    std::string faces;             ///< "face 12 (fender-outer) | face 13"
    std::string message;           ///< one sentence

    bool is_finding() const { return severity == Severity::judged && is_beyond_limit(); }
    bool is_worth_a_look() const { return severity == Severity::look && is_beyond_limit(); }

private:
    bool is_beyond_limit() const { return judged && worst.verdict != Verdict::pass; }
};

/// A criterion of reflection lines, "KEIKO-LINE-...", held against the worst of `lines` that cross
/// a seam in a view, of which `failing` do not pass. Without seam and face.
Check check_of_lines(std::string_view code, const MeasuredValue& worst, std::size_t lines,
                     std::size_t failing);

/// KEIKO-SYMMETRY held against how far a body is from its image at a plane, "y = 0", at its worst
/// place. Without face.
Check check_of_symmetry(const MeasuredValue& worst, const std::string& plane);

/// KEIKO-OPENING: an opening that is wider than the preset's gap is worth a look. `faces`: the
/// names of its sides. Without face.
Check check_of_opening(const Opening& opening, const CriteriaPreset& preset,
                       const std::string& faces);

/// KEIKO-OVERLAP, KEIKO-TEE or KEIKO-CROSSING: a run of a free edge on the inside of another face
/// that is longer than the preset's negligible length is worth a look, and so is each that passes
/// through it. `faces`: the names of its sides. Without face.
Check check_of_overlap(const Overlap& overlap, const CriteriaPreset& preset,
                       const std::string& faces);

/// Every criterion of the preset held against one measured face (number `index`), and what of it is
/// worth a look. What the preset has no limit for is left out.
std::vector<Check> checks_of(const MeasuredFace& face, const CriteriaPreset& preset,
                             std::uint32_t index);

/// "fail", "undecided" or "pass"; "look" of what is worth one.
std::string_view outcome_of(const Check& check);

/// Every criterion of the preset held against one measured seam (number `index`), in the order gap,
/// angle, curvature, its slope, fading. What the preset has no limit for is left out. `join` in mm.
std::vector<Check> checks_of(const MeasuredSeam& seam, const CriteriaPreset& preset, double join,
                             std::uint32_t index);

} // namespace keiko
