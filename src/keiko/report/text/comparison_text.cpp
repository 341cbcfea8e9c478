#include "keiko/base/text.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/report/content/comparison.h"
#include "keiko/report/content/scope_texts.h"
#include "keiko/report/markup/html_text.h"

#include <cmath>

namespace keiko {
namespace {

std::string place(const Vec3& p) {
    return "(" + place_text(p) + ")";
}

std::string share_text(const std::string& share, double value, const Deviation& d) {
    if (std::isinf(value)) return "less than " + share + " within " + short_number(d.reach) + " mm";
    return share + " within " + distance_words(value, d.reach);
}

std::string deviation_text(const std::string& what, const Deviation& d, double allowed) {
    const std::string limit = "; " + short_number(allowed) + " mm allowed";
    if (d.beyond >= 1)
        return what + ": everywhere " + distance_words(d.worst.value, d.reach) + limit;
    std::string text = what + ": " + at_most(d.worst.value, d.reach) + " at " +
                       place(d.worst.place) + limit + "; " +
                       share_text("99 % of the area", d.percent_99, d) + ", " +
                       share_text("half", d.median, d);
    if (d.beyond > 0)
        text += "; " + short_number(100 * d.beyond) + " % of the area further than " +
                short_number(d.reach) + " mm";
    if (d.uncertain_share > 0)
        text += "; not proved on " + short_number(100 * d.uncertain_share) + " % of the area";
    return text;
}

std::string check_text(const Comparison& c, const ComparisonCheck& check) {
    const double allowed = c.tolerance.deviation;
    if (check.name == "deviation")
        return deviation_text("deviation of " + c.after, c.deviation, allowed);
    if (check.name == "missing")
        return deviation_text("deviation of " + c.before + " from it", c.missing, allowed);
    return check.message;
}

std::string mark_of(const ComparisonCheck& check) {
    if (!check.judged) return "? ";
    return check.within ? "  " : "! ";
}

/// "face 1 (left) and face 2 (right)"
std::string sides_of(std::string faces) {
    if (const std::size_t bar = faces.find(between_faces); bar != std::string::npos)
        faces.replace(bar, between_faces.size(), " and ");
    return faces;
}

std::string change_text(const Comparison& c, const SeamChange& change) {
    const MeasuredSeam& seam = c.inspection_after.seams[change.seams.after.front()];
    std::string text = "seam " + std::string(name_of(change.trend)) + ": " + sides_of(seam.faces) +
                       ": gap " + short_number(change.before.gap) + " mm before, " +
                       short_number(change.after.gap) + " mm after";
    if (change.before.angle && change.after.angle)
        text += "; angle " + short_number(*change.before.angle) + " degrees before, " +
                short_number(*change.after.angle) + " after";
    if (change.before.curvature && change.after.curvature)
        text += "; curvature mismatch " + short_number(100 * *change.before.curvature) +
                " % before, " + short_number(100 * *change.after.curvature) + " % after";
    return text + "; " + std::string(name_of(change.before.verdict)) + " before, " +
           std::string(name_of(change.after.verdict)) + " after";
}

void add_seams(TextLines& lines, const Comparison& c) {
    for (const SeamChange& change : c.seams.changed) lines.line() << change_text(c, change);
    for (const std::uint32_t seam : c.seams.removed)
        lines.line() << "seam gone: " << sides_of(c.inspection_before.seams[seam].faces);
    for (const std::uint32_t seam : c.seams.added)
        lines.line() << "seam new: " << sides_of(c.inspection_after.seams[seam].faces);
    for (const Check& finding : c.seams.new_findings)
        lines.line() << "finding new: " << sides_of(finding.faces) << ": " << finding.message;
    for (const Check& finding : c.seams.solved_findings)
        lines.line() << "finding fixed: " << sides_of(finding.faces) << ": " << finding.message;
}

void add_faces(TextLines& lines, const Comparison& c) {
    if (c.faces_before.size() != c.faces_after.size())
        lines.line() << "faces: " << c.faces_before.size() << " before, " << c.faces_after.size()
                     << " after";
    for (const std::string& face : faces_gone(c)) lines.line() << "face gone: " << face;
    for (const std::string& face : faces_new(c)) lines.line() << "face new: " << face;
    for (const std::string& face : faces_turned(c)) lines.line() << "turned inside out: " << face;
}

} // namespace

std::string comparison_text(const Comparison& c) {
    TextLines lines;
    const std::string part = scope_words(c.inspection_after.scope);
    lines.line() << (c.same() ? "same within tolerance" : "different") << (part.empty() ? "" : "; ")
                 << part;
    for (const auto* inspection : {&c.inspection_before, &c.inspection_after})
        for (const std::string& sentence : scope_sentences(inspection->scope, inspection->preset))
            lines.line() << (inspection == &c.inspection_before ? "before: " : "after: ")
                         << sentence;
    if (c.alignment) lines.line() << "aligned: " << alignment_words(*c.alignment);
    for (const ComparisonCheck& check : comparison_checks(c))
        lines.line() << mark_of(check) << check_text(c, check);
    for (const ComparedView& view : c.views)
        lines.line() << (view.picture.within() ? "  " : "! ") << view.picture.view
                     << ": pictures: " << picture_words(view.picture);
    add_faces(lines, c);
    add_seams(lines, c);
    return lines.text();
}

} // namespace keiko
