#include "keiko/report/content/inspection_texts.h"
#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_text.h"

namespace keiko {
namespace {

std::string fact(std::string_view name, const std::string& html) {
    return "<dt>" + std::string(name) + "</dt><dd>" + html + "</dd>";
}

/// "3 x plane, 46 x b-spline"
template <class Counts, class Name>
std::string listed(const Counts& counts, const Name& name) {
    std::string text;
    for (const auto& [key, count] : counts)
        text += (text.empty() ? "" : ", ") + std::to_string(count) + " × " + name(key);
    return text;
}

std::string faces_text(const ModelFacts& facts) {
    std::string text = std::to_string(facts.faces);
    if (facts.placed_faces != facts.faces)
        text += ", placed " + std::to_string(facts.placed_faces) + " times";
    text += ", " + std::to_string(facts.trimmed_faces) + " trimmed";
    if (facts.approximated_faces > 0)
        text += ", " + std::to_string(facts.approximated_faces) + " approximated to " +
                short_number(facts.largest_approximation) + " mm";
    return text;
}

std::string box_text(const Box3& box) {
    if (box.empty()) return "empty";
    const Vec3 size = box.extent();
    return fixed_number(size.x, 1) + " × " + fixed_number(size.y, 1) + " × " +
           fixed_number(size.z, 1) + " mm, from " + place_text(box.lower) + " to " +
           place_text(box.upper);
}

std::string tracing_text(const TraceFacts& facts) {
    constexpr double mebibyte = 1 << 20;
    return std::to_string(facts.sub_patches) + " sub-patches, " +
           std::to_string(facts.mixed_sub_patches) + " cut by trims, " +
           fixed_number(static_cast<double>(facts.bytes) / mebibyte, 2) + " MiB";
}

std::string lost_faces(const ModelFacts& facts) {
    std::string html = "<ul>";
    for (const LostFace& face : facts.lost_faces)
        html += "<li>face " + std::to_string(face.id) +
                (face.name.empty() ? "" : " (" + html_escaped(face.name) + ")") + ": " +
                html_escaped(face.reason) + "</li>";
    return html + "</ul>";
}

std::string size_text(double millimetres) {
    return millimetres > 0 ? short_number(millimetres) : "";
}

std::string repairs(const ModelFacts& facts) {
    if (facts.repairs.empty()) return "nothing had to be repaired";
    std::string html = "<ul>";
    for (const auto& [kind, total] : facts.repair_totals)
        html += "<li>" + std::to_string(total.count) + " × " + std::string(text_of(kind)) + " on " +
                std::to_string(total.faces) + (total.faces == 1 ? " face" : " faces") +
                (total.size > 0 ? ", up to " + size_text(total.size) + " mm" : "") + "</li>";
    html +=
        "</ul><details><summary>by face</summary><table><thead><tr><th>face</th>"
        "<th class=\"left\">repair</th><th>times</th><th>largest mm</th></tr></thead><tbody>";
    for (const Repair& repair : facts.repairs)
        html += "<tr><td>" + std::to_string(repair.face) + "</td><td class=\"left\">" +
                std::string(text_of(repair.kind)) +
                (repair.detail.empty() ? "" : ": " + html_escaped(repair.detail)) + "</td><td>" +
                std::to_string(repair.count) + "</td><td>" + size_text(repair.size) + "</td></tr>";
    return html + "</tbody></table></details>";
}

std::string remarks(const ModelFacts& facts) {
    std::string html = "<ul>";
    for (const FoldedRemark& remark : folded_remarks(facts.diagnostics))
        html += "<li>" + html_escaped(remark.text) + "</li>";
    return html + "</ul>";
}

} // namespace

std::string html_facts(const Report& report) {
    const ModelFacts& facts = report.inspection.facts;
    std::string html = "<section id=\"file\"><h2>File</h2><dl class=\"card\">";
    html += fact("source", html_escaped(facts.source));
    html += fact("format", html_escaped(facts.format));
    html += fact("unit", facts.unit.empty() ? "none named, read as mm" : html_escaped(facts.unit));
    html += fact("parts",
                 std::to_string(facts.parts) + ", " + std::to_string(facts.instances) + " placed");
    html += fact("faces", faces_text(facts));
    html += fact("surfaces", html_escaped(listed(facts.kinds, [](const auto& kind) {
                     return kind.empty() ? std::string("unnamed") : kind;
                 })));
    html += fact("patches", std::to_string(facts.patches) + ", " +
                                std::to_string(facts.rational_patches) + " rational");
    html +=
        fact("degrees", listed(facts.degrees, [](const auto& degree) {
                 return "(" + std::to_string(degree[0]) + ", " + std::to_string(degree[1]) + ")";
             }));
    html += fact("size", box_text(facts.bounds));
    html += fact("borders", fixed_number(facts.border_length, 1) + " mm, of which " +
                                fixed_number(facts.free_length, 1) + " mm meet no other face");
    html += fact("seams", "within " + short_number(report.inspection.join) +
                              " mm: " + std::to_string(report.inspection.facts.seams));
    if (facts.tracing) html += fact("ray tracing", tracing_text(*facts.tracing));
    if (!facts.lost_faces.empty()) html += fact("lost faces", lost_faces(facts));
    html += fact("repairs", repairs(facts));
    if (!facts.diagnostics.empty()) html += fact("remarks", remarks(facts));
    return html + "</dl></section>\n";
}

} // namespace keiko
