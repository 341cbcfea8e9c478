#include "keiko/report/text/inspection_text.h"

#include "keiko/base/text.h"
#include "keiko/report/content/check_place.h"
#include "keiko/report/content/unmet_borders.h"

#include <algorithm>

namespace keiko {
namespace {

std::string faces_text(const Inspection& inspection) {
    if (inspection.preset.surface == SurfaceLimits{}) return "";
    const FaceCounts& counts = inspection.face_counts;
    return "; faces " + std::to_string(counts.fail) + " fail, " + std::to_string(counts.undecided) +
           " undecided, " + std::to_string(counts.pass) + " pass";
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

void add_check_line(TextLines& lines, const Check& check) {
    lines.line() << outcome_of(check) << "  " << check.code << "  " << placed_message(check);
}

void add_looks(TextLines& lines, const Inspection& inspection, std::size_t most) {
    if (inspection.looks.empty()) return;
    lines.line() << "worth a look, not judged:";
    const std::size_t shown = std::min(most, inspection.looks.size());
    for (std::size_t i = 0; i < shown; ++i) add_check_line(lines, inspection.looks[i]);
    if (shown < inspection.looks.size())
        lines.line() << "and " << inspection.looks.size() - shown << " more";
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
           stretches_text(inspection) + (unmet.empty() ? "" : "; " + unmet);
}

std::string inspection_text(const Inspection& inspection, std::size_t most) {
    TextLines lines;
    lines.line() << name_of(inspection.verdict) << ": " << seams_words(inspection)
                 << faces_text(inspection) << "; by " << inspection.preset.name;
    add_symmetry(lines, inspection);
    const std::size_t shown = std::min(most, inspection.findings.size());
    for (std::size_t i = 0; i < shown; ++i) add_check_line(lines, inspection.findings[i]);
    if (shown < inspection.findings.size())
        lines.line() << "and " << inspection.findings.size() - shown
                     << " more findings; JSON, JUnit, SARIF and CSV list them all";
    add_looks(lines, inspection, most);
    return lines.text();
}

} // namespace keiko
