#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/curvature/face_measure.h"
#include "keiko/inspect/seams/seam_measure.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

struct NarrowBend;
struct NarrowFace;
struct Groove;
struct Opening;
struct Overlap;

/// A criterion that surfaces are judged by, and its names.
struct Criterion {
    std::string_view code;        ///< [SASIG-PDQ], [VDA4955]: "G-SU-LG"; Keiko's own: "KEIKO-..."
    std::string_view rule;        ///< name in [ISO10303-59], or empty
    std::string_view quantity;    ///< "gap", "angle", "curvature", "curvature_slope", ...
    std::string_view description; ///< one sentence
};

/// The criterion of a code; throws std::out_of_range for an unknown code.
const Criterion& criterion_of(std::string_view code);

/// Who accepted a finding, why, and until when. Dates are "2026-11-27".
struct AcceptanceNote {
    std::string who, why; ///< a person and a reason
    std::string when;     ///< date of the acceptance
    std::string until;    ///< last day on which it holds; empty: no end
};

/// One criterion held against one seam or face, or against the lines that cross a seam. A judged
/// check that does not pass is a finding, unless its severity is `look` or it is accepted.
struct Check {
    /// `judged` counts in the verdict; `look` does not.
    enum class Severity {
        judged, ///< a part of the verdict
        look    ///< worth a look, no part of it
    };

    std::string code;     ///< as Criterion
    std::string rule;     ///< as Criterion
    std::string quantity; ///< as Criterion
    std::string unit;     ///< "mm", "deg", "deg/mm", "1" (a share of 1) or "1/mm"
    std::string formula;  ///< of a curvature mismatch, or empty
    MeasuredValue worst;  ///< value, bound, limit, place, verdict; empty if not judged
    bool judged = true;   ///< if false, `message` gives the reason
    Severity severity = Severity::judged;   ///< whether it has a part in the verdict
    std::uint32_t seam = no_index;          ///< into Inspection::seams; no_index: of a face
    std::uint32_t face = no_index;          ///< into Inspection::faces; no_index: of a seam
    double opening_length = 0;              ///< mm, along an opening between free edges; else 0
    std::string view;                       ///< of lines: the view that shows them; else empty
    std::string faces;                      ///< "face 12 (fender-outer) | face 13"
    std::string message;                    ///< one sentence
    std::optional<AcceptanceNote> accepted; ///< of what would be a finding, else nothing

    /// True if it is judged, does not pass and is not accepted.
    bool is_finding() const {
        return severity == Severity::judged && is_beyond_limit() && !accepted;
    }
    /// True if it is judged, does not pass and is accepted.
    bool is_accepted() const { return accepted.has_value(); }
    /// True if it is not judged, and beyond its limit.
    bool is_worth_a_look() const { return severity == Severity::look && is_beyond_limit(); }

private:
    bool is_beyond_limit() const { return judged && worst.verdict != Verdict::pass; }
};

/// A criterion of reflection lines, "KEIKO-LINE-...", held against the worst of `lines` that cross
/// a seam in a view; `failing` of them do not pass. Without seam and face.
Check check_of_lines(std::string_view code, const MeasuredValue& worst, std::size_t lines,
                     std::size_t failing);

/// KEIKO-SYMMETRY held against the largest distance of a body from its image at a plane, such as "y
/// = 0". Without face.
Check check_of_symmetry(const MeasuredValue& worst, const std::string& plane);

/// G-SU-NT: the normal turns by more than the preset's angle over a strip not wider than what is
/// negligible. `sides`: the names of the faces on either side of it. Without face.
Check check_of_bend(const NarrowBend& bend, const CriteriaPreset& preset, const std::string& sides);

/// G-SU-NA: a strip of a face that is narrower than the join distance, `join` mm, beside a crease
/// deserves a look. `neighbours`: the names of the faces on either side of it. Without face.
Check check_of_narrow(const NarrowFace& narrow, double join, const std::string& neighbours);

/// KEIKO-OPENING: an opening that is wider than the preset's gap deserves a look. `faces`: the
/// names of its sides. Without face.
Check check_of_opening(const Opening& opening, const CriteriaPreset& preset,
                       const std::string& faces);

/// KEIKO-OPENING: a groove that is wider than the preset's gap deserves a look. Else G-SU-NT: the
/// kink between its two faces does. `faces`: their names. Without face.
Check check_of_groove(const Groove& groove, const CriteriaPreset& preset, const std::string& faces);

/// KEIKO-OVERLAP, KEIKO-TEE or KEIKO-CROSSING: a run of a free edge on the inside of another face.
/// It deserves a look if it is longer than the preset's negligible length or passes through that
/// face. `faces`: the names of its sides. Without face.
Check check_of_overlap(const Overlap& overlap, const CriteriaPreset& preset,
                       const std::string& faces);

/// A criterion of StructureLimits, by its code, held against the worst value of a face; without it,
/// the check is not judged and `reason` states why. Without face.
Check check_of_structure(std::string_view code, const std::optional<MeasuredValue>& worst,
                         const char* reason);

/// Every criterion of the preset held against one measured face (number `index`), and the checks of
/// it that deserve a look. Criteria without a limit in the preset are left out.
std::vector<Check> checks_of(const MeasuredFace& face, const CriteriaPreset& preset,
                             std::uint32_t index);

/// "fail", "undecided" or "pass"; "look" for a check that deserves one, "accepted" for one that is.
std::string_view outcome_of(const Check& check);

/// Every criterion of the preset held against one measured seam (number `index`), in the order gap,
/// angle, curvature, its slope, fading. Criteria without a limit in the preset are left out. `join`
/// in mm.
std::vector<Check> checks_of(const MeasuredSeam& seam, const CriteriaPreset& preset, double join,
                             std::uint32_t index);

} // namespace keiko
