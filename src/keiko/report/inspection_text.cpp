#include "keiko/report/inspection_text.h"

#include "keiko/base/counted.h"
#include "keiko/report/check_place.h"
#include "keiko/report/unmet_borders.h"

#include <algorithm>

namespace keiko {
namespace {

std::string faces_text(const Inspection& inspection) {
    if (inspection.preset.surface == SurfaceLimits{}) return "";
    const FaceCounts& counts = inspection.face_counts;
    return "; faces " + std::to_string(counts.fail) + " fail, " + std::to_string(counts.undecided) +
           " undecided, " + std::to_string(counts.pass) + " pass";
}

/// Where it passes, too: whoever asks for it wants to know by how much.
std::string symmetry_text(const Inspection& inspection) {
    std::string text;
    for (const Check& check : inspection.checks)
        if (check.code == "KEIKO-SYMMETRY" && !check.is_finding())
            text += "pass  " + check.code + "  " + placed_message(check) + "\n";
    return text;
}

/// Nothing where each seam is of one class.
std::string stretches_text(const Inspection& inspection) {
    const std::size_t stretches = inspection.seams.size(), seams = inspection.facts.seams;
    if (stretches == seams) return "";
    return " (" + std::to_string(stretches) + " stretches of " + counted(seams, "seam") + ")";
}

} // namespace

std::string seams_words(const Inspection& inspection) {
    const SeamCounts& counts = inspection.counts;
    const std::string unmet = unmet_borders(inspection.facts);
    return "seams " + std::to_string(counts.fail) + " fail, " + std::to_string(counts.undecided) +
           " undecided, " + std::to_string(counts.pass) + " pass, " +
           std::to_string(counts.creases) + " creases" +
           (counts.scraps > 0 ? ", " + counted(counts.scraps, "scrap") : "") +
           stretches_text(inspection) + (unmet.empty() ? "" : "; " + unmet);
}

std::string inspection_text(const Inspection& inspection, std::size_t most) {
    std::string text(name_of(inspection.verdict));
    text += ": " + seams_words(inspection) + faces_text(inspection) + "; by " +
            inspection.preset.name + "\n" + symmetry_text(inspection);
    const std::size_t shown = std::min(most, inspection.findings.size());
    for (std::size_t i = 0; i < shown; ++i) {
        const Check& finding = inspection.findings[i];
        text += std::string(name_of(finding.worst.verdict)) + "  " + finding.code + "  " +
                placed_message(finding) + "\n";
    }
    if (shown < inspection.findings.size())
        text += "and " + std::to_string(inspection.findings.size() - shown) +
                " more findings; --json, --junit, --sarif and --csv write them all\n";
    return text;
}

} // namespace keiko
