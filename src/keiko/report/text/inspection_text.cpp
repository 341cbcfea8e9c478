#include "keiko/base/text.h"
#include "keiko/report/content/acceptance_texts.h"
#include "keiko/report/content/inspection_texts.h"
#include "keiko/report/content/line_list.h"
#include "keiko/report/content/scope_texts.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace keiko {
namespace {

/// A number without the sign of one that is rounded to 0.
std::string number(const char* format, double value) {
    char text[48];
    std::snprintf(text, sizeof text, format, value);
    if (std::strtod(text, nullptr) == 0) std::snprintf(text, sizeof text, format, 0.0);
    return text;
}

std::string faces_text(const Inspection& inspection) {
    if (!judges_faces(inspection.preset)) return "";
    const FaceCounts& counts = inspection.face_counts;
    return "; faces " + std::to_string(counts.fail) + " fail, " + std::to_string(counts.undecided) +
           " undecided, " + std::to_string(counts.pass) + " pass" +
           (counts.accepted > 0 ? ", " + std::to_string(counts.accepted) + " accepted" : "");
}

/// Adds the symmetry even if it passes, since its amount is of interest.
void add_symmetry(TextLines& lines, const Inspection& inspection) {
    for (const Check& check : inspection.checks)
        if (check.code == "KEIKO-SYMMETRY" && check.worst.verdict == Verdict::pass)
            lines.line() << "pass  " << check.code << "  " << placed_message(check);
}

/// Counts of stretches; empty if each seam is of one class.
std::string stretches_text(const Inspection& inspection) {
    const std::size_t stretches = inspection.seams.size(), seams = inspection.facts.seams;
    if (stretches == seams) return "";
    return " (of " + counted(seams, "seam") + ")";
}

/// "0.4 to 1.2"
std::string range_text(double low, double high) {
    return number("%.3f", low) + " to " + number("%.3f", high);
}

/// Gap, flush, radius and length of a joint.
std::string joint_sizes(const Joint& joint) {
    std::string text;
    if (const auto& e = joint.extremes)
        text = "gap " + range_text(e->narrowest.gap, e->widest.gap) + " mm, flush " +
               range_text(e->deepest.flush, e->proudest.flush) + " mm, radius from " +
               number("%.3f", e->sharpest.least_radius()) + " mm, ";
    text += number("%.1f", joint.length) + " mm long";
    if (joint.unmeasured > 0)
        text += ", of which " + number("%.1f", joint.unmeasured) + " mm cannot be measured";
    return text;
}

/// Adds each joint that was sought, whether judged or not.
void add_joints(TextLines& lines, const Inspection& inspection, std::size_t most) {
    if (!inspection.joints) return;
    const std::vector<Joint>& joints = *inspection.joints;
    lines.line() << counted(joints.size(), "joint") << " between panels that stand apart";
    const std::size_t shown = std::min(most, joints.size());
    for (std::size_t i = 0; i < shown; ++i)
        lines.line() << "joint " << i + 1 << "  " << joints[i].names << ": "
                     << joint_sizes(joints[i]);
    if (shown < joints.size())
        lines.line() << "and " << joints.size() - shown << " more joints; JSON lists them all";
}

void add_check_line(TextLines& lines, const Check& check) {
    lines.line() << outcome_of(check) << "  " << check.code << "  " << placed_message(check);
}

/// Adds the findings with the numbers by which `keiko accept` names them.
void add_findings(TextLines& lines, const Inspection& inspection, std::size_t most) {
    const std::vector<Check>& findings = inspection.findings;
    const std::size_t shown = std::min(most, findings.size());
    for (std::size_t i = 0; i < shown; ++i)
        lines.line() << outcome_of(findings[i]) << "  " << findings[i].code << "  #" << i + 1
                     << "  " << placed_message(findings[i]);
    if (shown < findings.size())
        lines.line() << "and " << findings.size() - shown
                     << " more findings; JSON, JUnit, SARIF and CSV list them all";
}

void add_accepted(TextLines& lines, const Inspection& inspection, std::size_t most) {
    const std::vector<Check>& accepted = inspection.accepted;
    if (accepted.empty()) return;
    lines.line() << accepted.size() << " accepted, no part of the verdict:";
    const std::size_t shown = std::min(most, accepted.size());
    for (std::size_t i = 0; i < shown; ++i)
        lines.line() << outcome_of(accepted[i]) << "  " << accepted[i].code << "  "
                     << placed_message(accepted[i]) << "; " << text_of(*accepted[i].accepted);
    if (shown < accepted.size()) lines.line() << "and " << accepted.size() - shown << " more";
}

void add_looks(TextLines& lines, const Inspection& inspection, std::size_t most) {
    if (inspection.looks.empty()) return;
    lines.line() << "worth a look, not judged:";
    const std::size_t shown = std::min(most, inspection.looks.size());
    for (std::size_t i = 0; i < shown; ++i) add_check_line(lines, inspection.looks[i]);
    if (shown < inspection.looks.size())
        lines.line() << "and " << inspection.looks.size() - shown << " more";
}

/// Right-aligned numbers, then the names, which may be long.
std::string row_text(std::size_t rank, const LineCrossing& c, const std::string& view) {
    const auto known = [&](const char* format, const LineValue& value) {
        return c.continued() ? number(format, value.value) : std::string("-");
    };
    char text[256];
    std::snprintf(
        text, sizeof text, "%3zu  %-9s %8s %9s %8s %8s %9s %9s  %5s  (%.1f, %.1f, %.1f)  ", rank,
        std::string(name_of(*c.verdict)).c_str(), number("%.3g", c.severity).c_str(),
        number("%.4f", c.plane_jump).c_str(), number("%.4f", c.turn.value).c_str(),
        known("%.4f", c.jump).c_str(), known("%.4f", c.kink).c_str(), known("%.2e", c.bend).c_str(),
        (std::to_string(c.plane) + "." + std::to_string(c.lamp)).c_str(), c.place.x, c.place.y,
        c.place.z);
    return text + c.faces + " in " + view;
}

} // namespace

std::string seams_words(const Inspection& inspection) {
    const SeamCounts& counts = inspection.counts;
    const std::string unmet = unmet_borders(inspection.facts);
    return "stretches of seams " + std::to_string(counts.fail) + " fail, " +
           std::to_string(counts.undecided) + " undecided, " + std::to_string(counts.pass) +
           " pass, " + std::to_string(counts.creases) + " creases" +
           (counts.run_outs > 0 ? ", " + counted(counts.run_outs, "run-out") : "") +
           (counts.scraps > 0 ? ", " + counted(counts.scraps, "scrap") : "") +
           (counts.accepted > 0 ? ", " + std::to_string(counts.accepted) + " accepted" : "") +
           stretches_text(inspection) + (unmet.empty() ? "" : "; " + unmet);
}

std::string inspection_text(const Inspection& inspection, std::size_t most) {
    TextLines lines;
    const std::string part = scope_words(inspection.scope);
    lines.line() << name_of(inspection.verdict) << ": " << seams_words(inspection)
                 << faces_text(inspection) << "; by " << inspection.preset.name
                 << (part.empty() ? "" : "; ") << part;
    for (const std::string& sentence : scope_sentences(inspection.scope, inspection.preset))
        lines.line() << sentence;
    add_symmetry(lines, inspection);
    add_joints(lines, inspection, most);
    add_findings(lines, inspection, most);
    add_accepted(lines, inspection, most);
    add_looks(lines, inspection, most);
    return lines.text();
}

std::string crossings_table(const LineList& list, std::size_t most) {
    const std::vector<CrossingPlace> ranked = ranked_crossings(list);
    if (ranked.empty()) return "";
    TextLines lines;
    lines.line()
        << "  #  verdict   severity  plane mm   turn °  jump mm    kink ° bend 1/mm   lamp  "
           "place";
    for (std::size_t i = 0; i < std::min(ranked.size(), most); ++i)
        lines.line() << row_text(i + 1, ranked[i].in(list), list.views[ranked[i].view].view);
    if (ranked.size() > most)
        lines.line() << "... and " << ranked.size() - most << " crossings less bad";
    return lines.text();
}

} // namespace keiko
