#include "keiko/report/facts_text.h"

#include "keiko/report/folded_remarks.h"

#include <sstream>
#include <string_view>

namespace keiko {
namespace {

constexpr int name_width = 12;

std::ostream& begin_line(std::ostream& out, std::string_view name) {
    out << name;
    for (std::size_t i = name.size(); i < name_width; ++i) out << ' ';
    return out;
}

void write_counts(std::ostream& out, const ModelFacts& facts) {
    begin_line(out, "parts") << facts.parts << ", placed " << facts.instances << " times\n";
    begin_line(out, "faces") << facts.faces << ", " << facts.trimmed_faces << " trimmed, "
                             << facts.lost_faces.size() << " lost";
    if (facts.approximated_faces > 0)
        out << ", " << facts.approximated_faces << " approximated to "
            << facts.largest_approximation << " mm";
    out << "\n";
    begin_line(out, "surfaces");
    std::string_view comma;
    for (const auto& [kind, count] : facts.kinds) {
        out << comma << count << " " << kind;
        comma = ", ";
    }
    out << "\n";
    begin_line(out, "patches") << facts.patches << ", " << facts.rational_patches << " rational\n";
    begin_line(out, "degrees");
    comma = "";
    for (const auto& [degree, count] : facts.degrees) {
        out << comma << count << " of " << degree[0] << "x" << degree[1];
        comma = ", ";
    }
    out << "\n";
}

/// ", up to 0.01 mm", or nothing for a kind without size.
void write_size(std::ostream& out, double millimetres) {
    if (millimetres > 0) out << ", up to " << millimetres << " mm";
}

void write_repairs(std::ostream& out, const ModelFacts& facts) {
    for (const auto& [kind, total] : facts.repair_totals) {
        begin_line(out, "repairs") << total.count << " × " << text_of(kind) << " on " << total.faces
                                   << (total.faces == 1 ? " face" : " faces");
        write_size(out, total.size);
        out << "\n";
    }
    for (const Repair& repair : facts.repairs) {
        begin_line(out, "repair") << "face " << repair.face << ": " << text_of(repair.kind);
        if (!repair.detail.empty()) out << ": " << repair.detail;
        if (repair.count > 1) out << ", " << repair.count << " times";
        write_size(out, repair.size);
        out << "\n";
    }
}

void write_remarks(std::ostream& out, const ModelFacts& facts) {
    for (const LostFace& face : facts.lost_faces)
        begin_line(out, "lost") << "face " << face.id << (face.name.empty() ? "" : " ") << face.name
                                << ": " << face.reason << "\n";
    if (!facts.repair_totals.empty()) write_repairs(out, facts);
    for (const FoldedRemark& remark : folded_remarks(facts.diagnostics))
        begin_line(out, name_of(remark.severity)) << remark.text << "\n";
}

void write_tracing(std::ostream& out, const TraceFacts& facts) {
    begin_line(out, "tracing") << facts.leaves << " leaves, " << facts.mixed_leaves
                               << " cut by trims, " << facts.trimmed_away_leaves
                               << " trimmed away, " << facts.bytes << " bytes";
    if (facts.build_milliseconds) out << ", built in " << *facts.build_milliseconds << " ms";
    out << "\n";
}

} // namespace

std::string facts_text(const ModelFacts& facts) {
    std::ostringstream out;
    begin_line(out, "file") << facts.source << "\n";
    begin_line(out, "format") << facts.format << "\n";
    begin_line(out, "unit") << (facts.unit.empty() ? "none named, read as mm" : facts.unit) << "\n";
    write_counts(out, facts);
    if (!facts.bounds.empty())
        begin_line(out, "box") << facts.bounds.lower << " to " << facts.bounds.upper << " mm\n";
    begin_line(out, "edges") << facts.edges << ", " << facts.degenerate_edges
                             << " degenerate, tolerances up to " << facts.largest_edge_tolerance
                             << " mm\n";
    begin_line(out, "seams") << facts.seams << " within " << facts.join << " mm\n";
    begin_line(out, "borders") << facts.border_length << " mm, " << facts.free_length
                               << " mm of them free\n";
    if (facts.tracing) write_tracing(out, *facts.tracing);
    write_remarks(out, facts);
    return out.str();
}

} // namespace keiko
