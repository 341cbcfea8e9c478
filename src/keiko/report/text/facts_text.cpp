#include "keiko/base/text.h"
#include "keiko/report/content/inspection_texts.h"

#include <string_view>

namespace keiko {
namespace {

void write_counts(TextLines& lines, const ModelFacts& facts) {
    lines.line("parts") << facts.parts << ", placed " << facts.instances << " times";
    std::ostream& out = lines.line("faces");
    out << facts.faces << ", " << facts.trimmed_faces << " trimmed, " << facts.lost_faces.size()
        << " lost";
    if (facts.approximated_faces > 0)
        out << ", " << facts.approximated_faces << " approximated to "
            << facts.largest_approximation << " mm";
    lines.line("surfaces");
    std::string_view comma;
    for (const auto& [kind, count] : facts.kinds) {
        out << comma << count << " " << kind;
        comma = ", ";
    }
    lines.line("patches") << facts.patches << ", " << facts.rational_patches << " rational";
    lines.line("degrees");
    comma = "";
    for (const auto& [degree, count] : facts.degrees) {
        out << comma << count << " of " << degree[0] << "x" << degree[1];
        comma = ", ";
    }
}

/// ", up to 0.01 mm", or an empty text for a kind without size.
void write_size(std::ostream& out, double millimetres) {
    if (millimetres > 0) out << ", up to " << millimetres << " mm";
}

void write_repairs(TextLines& lines, const ModelFacts& facts) {
    for (const auto& [kind, total] : facts.repair_totals) {
        std::ostream& out = lines.line("repairs");
        out << total.count << " × " << text_of(kind) << " on " << total.faces
            << (total.faces == 1 ? " face" : " faces");
        write_size(out, total.size);
    }
    for (const Repair& repair : facts.repairs) {
        std::ostream& out = lines.line("repair");
        out << "face " << repair.face << ": " << text_of(repair.kind);
        if (!repair.detail.empty()) out << ": " << repair.detail;
        if (repair.count > 1) out << ", " << repair.count << " times";
        write_size(out, repair.size);
    }
}

void write_remarks(TextLines& lines, const ModelFacts& facts) {
    for (const LostFace& face : facts.lost_faces)
        lines.line("lost") << "face " << face.id << (face.name.empty() ? "" : " ") << face.name
                           << ": " << face.reason;
    if (!facts.repair_totals.empty()) write_repairs(lines, facts);
    for (const FoldedRemark& remark : folded_remarks(facts.diagnostics))
        lines.line(name_of(remark.severity)) << remark.text;
}

void write_tracing(TextLines& lines, const TraceFacts& facts) {
    std::ostream& out = lines.line("tracing");
    out << facts.sub_patches << " sub-patches, " << facts.mixed_sub_patches << " cut by trims, "
        << facts.trimmed_away_sub_patches << " trimmed away, " << facts.bytes << " bytes";
    if (facts.build_milliseconds) out << ", built in " << *facts.build_milliseconds << " ms";
}

} // namespace

std::string facts_text(const ModelFacts& facts) {
    TextLines lines;
    lines.line("file") << facts.source;
    lines.line("format") << facts.format;
    lines.line("unit") << (facts.unit.empty() ? "none named, read as mm" : facts.unit);
    write_counts(lines, facts);
    if (!facts.bounds.empty())
        lines.line("box") << facts.bounds.lower << " to " << facts.bounds.upper << " mm";
    lines.line("edges") << facts.edges << ", " << facts.degenerate_edges
                        << " degenerate, tolerances up to " << facts.largest_edge_tolerance
                        << " mm";
    lines.line("seams") << facts.seams << " within " << facts.join << " mm";
    lines.line("borders") << facts.border_length << " mm, " << facts.free_length
                          << " mm of them free";
    if (facts.tracing) write_tracing(lines, *facts.tracing);
    write_remarks(lines, facts);
    return lines.text();
}

} // namespace keiko
