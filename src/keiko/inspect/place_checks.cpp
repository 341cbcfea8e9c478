#include "keiko/inspect/check_sentence.h"
#include "keiko/inspect/flaws/narrow_bends.h"
#include "keiko/inspect/openings/grooves.h"
#include "keiko/inspect/overlaps/overlap.h"
#include "keiko/inspect/seams/narrow_faces.h"

#include <algorithm>
#include <span>
#include <stdexcept>

namespace keiko {
namespace {

/// How messages word the measure of a code.
struct CodeWording {
    std::string_view code;
    const char* unit;
    Wording wording;
};

/// A judged check in the wording of its code, which must be one of `wordings`; `of` names these.
Check judged_by(std::span<const CodeWording> wordings, const char* of, std::string_view code,
                const MeasuredValue& worst) {
    const auto found = std::find_if(wordings.begin(), wordings.end(),
                                    [&](const CodeWording& w) { return w.code == code; });
    if (found == wordings.end())
        throw std::out_of_range("no criterion of " + std::string(of) + " " + std::string(code));
    return judged_check(code, found->unit, worst, found->wording);
}

} // namespace

Check check_of_lines(std::string_view code, const MeasuredValue& worst, std::size_t lines,
                     std::size_t failing) {
    static constexpr CodeWording wordings[] = {
        {"KEIKO-LINE-JUMP", "mm", {"the jump of a line", " mm"}},
        {"KEIKO-LINE-TURN", "deg", {"the turn of a line", " degrees"}},
        {"KEIKO-LINE-KINK", "deg", {"the kink of a line", " degrees"}},
        {"KEIKO-LINE-BEND", "1/mm", {"the change of a line's curvature", " /mm"}}};
    Check check = judged_by(wordings, "lines", code, worst);
    check.message += "; of " + std::to_string(lines) + (lines == 1 ? " line " : " lines ") +
                     std::to_string(failing) + " not within it";
    return check;
}

Check check_of_structure(std::string_view code, const std::optional<MeasuredValue>& worst,
                         const char* reason) {
    static constexpr CodeWording wordings[] = {
        {"G-SU-HD", "1", {"the degree", ""}},
        {"KEIKO-SPANS", "1", {"the number of spans", ""}},
        {"G-SU-IK", "mm", {"the narrowest knot span", " mm"}},
        {"G-SU-TI", "mm", {"the shortest edge of a patch", " mm"}},
        {"G-SU-DC", "mm", {"the most degenerate edge of a patch", " mm"}},
        {"G-SU-DP", "deg", {"the most degenerate corner of a patch", " degrees"}},
        {"G-SU-RN", "1", {"the ratio of the widths of neighbouring spans", ""}},
        {"KEIKO-NET-TURN", "deg", {"the turn of a row of control points", " degrees"}},
        {"KEIKO-NET-TWIST", "deg", {"the twist between rows of control points", " degrees"}},
        {"KEIKO-NET-RATIO", "1", {"the ratio of distances of control points", ""}},
        {"KEIKO-NET-POINTS", "mm", {"the least distance of control points", " mm"}},
        {"G-SU-EM", "mm", {"the distance from another face", " mm"}},
        {"G-CU-EM", "mm", {"the distance of an edge from another one", " mm"}},
        {"G-SU-IS", "mm", {"the distance of the face from itself", " mm"}},
        {"G-LO-IS", "mm", {"the part of a loop that crosses itself", " mm"}},
        {"G-CU-LG", "mm", {"the gap between edges of a loop", " mm"}},
        {"G-CU-NT", "deg", {"the kink of an edge", " degrees"}},
        {"G-CU-HD", "1", {"the degree of an edge", ""}},
        {"G-CU-IK", "mm", {"the shortest curve of an edge", " mm"}},
        {"G-CU-TI", "mm", {"the shortest edge of the face", " mm"}},
        {"G-FA-TI", "mm", {"the size of the face", " mm"}}};
    if (!worst) return unjudged_check(code, reason);
    return judged_by(wordings, "structure", code, *worst);
}

Check check_of_symmetry(const MeasuredValue& worst, const std::string& plane) {
    const std::string what = "the deviation from the mirror image at " + plane;
    return judged_check("KEIKO-SYMMETRY", "mm", worst, {what.c_str(), " mm"});
}

Check check_of_bend(const NarrowBend& bend, const CriteriaPreset& preset,
                    const std::string& sides) {
    const MeasuredValue worst{bend.angle, 0, preset.angle, bend.place, Verdict::fail};
    Check check = judged_check("G-SU-NT", "deg", worst, {"the angle across a strip", " degrees"});
    check.message += "; the strip is " + short_number(bend.width) + " mm wide and some " +
                     short_number(bend.length) + " mm long, between " + sides;
    return check;
}

Check check_of_narrow(const NarrowFace& narrow, double join, const std::string& neighbours) {
    MeasuredValue worst{narrow.width, 0, join, narrow.place, Verdict::fail};
    worst.at_least = true;
    Check check =
        judged_check("G-SU-NA", "mm", worst, {"the width of a strip beside a crease", " mm"});
    check.message += ", some " + short_number(narrow.length) + " mm long; across it " + neighbours +
                     " step by " + short_number(narrow.step) + " mm and turn by " +
                     short_number(narrow.angle) + " degrees";
    check.severity = Check::Severity::look;
    return check;
}

Check check_of_opening(const Opening& opening, const CriteriaPreset& preset,
                       const std::string& faces) {
    MeasuredValue worst{opening.width, opening.width_bound, preset.gap, opening.place};
    worst.verdict = judge(worst.value, worst.bound, worst.limit);
    Check check =
        judged_check("KEIKO-OPENING", "mm", worst, {"the opening between free edges", " mm"});
    check.message += opening.goes_on ? ", more than " : ", some ";
    check.message += short_number(opening.length) + " mm long";
    check.severity = Check::Severity::look;
    check.opening_length = opening.length;
    check.faces = faces;
    return check;
}

Check check_of_groove(const Groove& groove, const CriteriaPreset& preset,
                      const std::string& faces) {
    const bool is_gap = groove.width > preset.gap;
    const MeasuredValue worst{is_gap ? groove.width : groove.turn, 0,
                              is_gap ? preset.gap : preset.angle, groove.place, Verdict::fail};
    Check check =
        is_gap ? judged_check("KEIKO-OPENING", "mm", worst, {"the groove between creases", " mm"})
               : judged_check("G-SU-NT", "deg", worst,
                              {"the kink between faces with a crease each", " degrees"});
    check.message += ", some " + short_number(groove.length) + " mm long; the faces ";
    constexpr double rounding = 1e-9; // degrees, of the normals of parallel faces
    const double turn = groove.turn > rounding ? groove.turn : 0;
    check.message += is_gap ? "turn by " + short_number(turn) + " degrees"
                            : "are " + short_number(groove.width) + " mm apart";
    check.severity = Check::Severity::look;
    check.faces = faces;
    return check;
}

Check check_of_overlap(const Overlap& overlap, const CriteriaPreset& preset,
                       const std::string& faces) {
    struct OverlapWording {
        const char *code, *what;
    };
    static constexpr OverlapWording lap{"KEIKO-OVERLAP", "the overlapping edge"};
    static constexpr OverlapWording tee{"KEIKO-TEE", "the edge that stands on the other face"};
    static constexpr OverlapWording crossing{"KEIKO-CROSSING",
                                             "the edge that passes through the other face"};
    const OverlapWording& of = overlap.kind == Overlap::Kind::lap   ? lap
                               : overlap.kind == Overlap::Kind::tee ? tee
                                                                    : crossing;
    MeasuredValue worst{overlap.length, overlap.length_bound, preset.negligible, overlap.place};
    worst.verdict = judge(worst.value, worst.bound, worst.limit);
    Check check = judged_check(of.code, "mm", worst, {of.what, " mm"});
    if (overlap.kind != Overlap::Kind::crossing)
        check.message += "; up to " + short_number(overlap.depth) +
                         " mm inside the other's borders, " + short_number(overlap.distance) +
                         " mm from it";
    check.message += ", at " + short_number(overlap.angle) + " degrees to it";
    check.severity = Check::Severity::look;
    check.faces = faces;
    return check;
}

} // namespace keiko
