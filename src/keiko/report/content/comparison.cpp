#include "keiko/report/content/comparison.h"

#include "keiko/base/text.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

template <class Test>
std::vector<std::string> chosen(const Deviation& deviation, const std::vector<std::string>& names,
                                const Test& test) {
    std::vector<std::string> found;
    for (std::size_t i = 0; i < deviation.faces.size(); ++i)
        if (test(deviation.faces[i])) found.push_back(names[i]);
    return found;
}

constexpr double nothing = 1e-9; // mm: roundings

ComparisonCheck surface_check(const char* name, const std::string& what, const Deviation& d,
                              double tolerance) {
    const bool within = std::abs(d.worst.value) <= tolerance;
    return {name, within,
            what + " " + at_most(d.worst.value, d.reach) + " away, at " +
                place_text(d.worst.place) + "; " + short_number(tolerance) + " mm allowed"};
}

/// True if no place of either body has any of the other within reach.
bool are_apart(const Comparison& c) {
    return c.deviation.beyond >= 1 && c.missing.beyond >= 1;
}

ComparisonCheck normals_check(const Comparison& c) {
    if (are_apart(c))
        return {.name = "normals",
                .within = false,
                .message = "normals cannot be compared: nothing of one part lies within " +
                           short_number(c.deviation.reach) + " mm of the other",
                .judged = false};
    const DeviationPlace &a = c.deviation.worst_normal, &b = c.missing.worst_normal;
    const DeviationPlace& worst = a.value >= b.value ? a : b;
    return {"normals", worst.value <= c.tolerance.normal,
            "normals at most " + short_number(worst.value) + " degrees apart, at " +
                place_text(worst.place) + "; " + short_number(c.tolerance.normal) + " allowed"};
}

ComparisonCheck borders_check(const Comparison& c) {
    const bool after = c.deviation.worst_border.value >= c.missing.worst_border.value;
    const Deviation& d = after ? c.deviation : c.missing;
    const DeviationPlace& worst = d.worst_border;
    const bool within = worst.value <= c.tolerance.border;
    const std::string claim = within || d.claimed_border <= c.tolerance.border
                                  ? ""
                                  : "; the file of the part " +
                                        std::string(after ? "after" : "before") +
                                        " itself claims this edge to no more than " +
                                        short_number(d.claimed_border) + " mm";
    return {"borders", within,
            "borders " + at_most(worst.value, c.deviation.reach) + " apart, at " +
                place_text(worst.place) + "; " + short_number(c.tolerance.border) + " mm allowed" +
                claim};
}

ComparisonCheck faces_check(const Comparison& c) {
    const std::size_t gone = faces_gone(c).size(), fresh = faces_new(c).size(),
                      turned = faces_turned(c).size();
    return {"faces", gone + fresh + turned == 0,
            counted(gone, "face") + " gone, " + std::to_string(fresh) + " new, " +
                std::to_string(turned) + " turned inside out; " +
                std::to_string(c.faces_before.size()) + " before, " +
                std::to_string(c.faces_after.size()) + " after"};
}

ComparisonCheck seams_check(const Comparison& c) {
    std::size_t better = 0, worse = 0;
    for (const SeamChange& change : c.seams.changed) {
        better += change.trend == SeamTrend::better;
        worse += change.trend == SeamTrend::worse;
    }
    const std::size_t other = c.seams.changed.size() - better - worse;
    return {"seams", c.seams.changed.empty() && c.seams.removed.empty() && c.seams.added.empty(),
            counted(worse, "seam") + " worse, " + std::to_string(better) + " better, " +
                std::to_string(other) + " otherwise changed, " +
                std::to_string(c.seams.removed.size()) + " gone, " +
                std::to_string(c.seams.added.size()) + " new; " + std::to_string(c.seams.matched) +
                " found again"};
}

ComparisonCheck findings_check(const Comparison& c) {
    const std::size_t fresh = c.seams.new_findings.size(), fixed = c.seams.solved_findings.size();
    return {"findings", fresh + fixed == 0,
            counted(fresh, "finding") + " new, " + std::to_string(fixed) + " fixed, " +
                std::to_string(c.seams.same_findings.size()) + " the same"};
}

/// "reflection lines moved by at most 0.2 mm on the part, 0.1 allowed"
std::string movement(const ComparedView& view, const BodyTolerance& tolerance) {
    double largest = 0;
    bool paired = false;
    for (const auto* lines : {&view.lines, &view.after_lines})
        for (const LineShift& line : *lines) {
            largest = std::max(largest, line.largest);
            paired = paired || line.alone < line.length;
        }
    if (!paired) return "no reflection line lies near one of the other part";
    return "reflection lines moved by at most " + short_number(largest) + " mm on the part, " +
           short_number(tolerance.line) + " allowed";
}

/// "at most 0.02 mm (0.015 pixels) from the other part, at 1.0, 2.0, 3.0"
std::string shift_words(const OutlineShift& worst, double reach) {
    constexpr double rounding = 1e-9; // pixels
    const bool told = std::isfinite(worst.pixels) && worst.pixels > rounding;
    const std::string pixels = told ? " (" + short_number(worst.pixels) + " pixels)" : "";
    return at_most(worst.distance, reach) + pixels + " from the other part, at " +
           place_text(worst.place);
}

ComparisonCheck outlines_check(const Comparison& c, const ComparedView& view) {
    const OutlineDifference& outlines = view.outlines;
    const std::size_t measured = outlines.excused + outlines.moved;
    std::string message = "no pixel differs at an outline";
    if (measured > 0)
        message = "outlines in " + counted(measured, "pixel") + " that differ " +
                  shift_words(outlines.worst, c.deviation.reach) + "; " +
                  short_number(c.tolerance.outline) + " mm or " +
                  short_number(c.tolerance.outline_pixels) + " pixels allowed, exceeded in " +
                  counted(outlines.moved, "pixel");
    if (outlines.alike > 0)
        message += "; " + counted(outlines.alike, "pixel") +
                   " not judged, in which both parts show the same surface";
    return {view.picture.view + ": outlines", outlines.within(), message};
}

ComparisonCheck lines_check(const ComparedView& view, const BodyTolerance& tolerance) {
    const auto alone = [](const std::vector<LineShift>& lines) {
        return std::to_string(std::count_if(lines.begin(), lines.end(), is_alone));
    };
    return {view.picture.view + ": lines", lines_within(view, tolerance),
            movement(view, tolerance) + "; of " + counted(view.lines.size(), "line") + " " +
                alone(view.lines) + " gone or shorter, " + alone(view.after_lines) +
                " new or longer"};
}

} // namespace

bool Comparison::same() const {
    const std::vector<ComparisonCheck> checks = comparison_checks(*this);
    return std::all_of(checks.begin(), checks.end(),
                       [](const ComparisonCheck& check) { return check.within; }) &&
           std::all_of(views.begin(), views.end(),
                       [](const ComparedView& view) { return view.picture.within(); });
}

std::vector<std::string> faces_gone(const Comparison& comparison) {
    return chosen(comparison.missing, comparison.faces_before,
                  [](const FaceDeviation& face) { return face.alone(); });
}

std::vector<std::string> faces_new(const Comparison& comparison) {
    return chosen(comparison.deviation, comparison.faces_after,
                  [](const FaceDeviation& face) { return face.alone(); });
}

std::vector<std::string> faces_turned(const Comparison& comparison) {
    constexpr double mostly = 0.5;
    return chosen(comparison.deviation, comparison.faces_after,
                  [](const FaceDeviation& face) { return face.turned > mostly && !face.alone(); });
}

bool is_alone(const LineShift& line) {
    constexpr double wander = 1, share = 0.01; // mm, and share of the length: tolerance where a
                                               // silhouette cuts it
    return line.alone > wander + share * line.length;
}

bool lines_within(const ComparedView& view, const BodyTolerance& tolerance) {
    const auto within = [&](const LineShift& line) {
        return line.largest <= tolerance.line && !is_alone(line);
    };
    return std::all_of(view.lines.begin(), view.lines.end(), within) &&
           std::all_of(view.after_lines.begin(), view.after_lines.end(), within);
}

std::string distance_words(double value, double reach) {
    if (std::isinf(value)) return "further than " + short_number(reach) + " mm";
    return (std::abs(value) < nothing ? "< 1e-9" : short_number(value)) + std::string(" mm");
}

std::string at_most(double value, double reach) {
    const bool in_words = std::isinf(value) || std::abs(value) < nothing;
    return (in_words ? "" : "at most ") + distance_words(std::abs(value), reach);
}

std::string picture_words(const PictureOutcome& picture) {
    if (!picture.problem.empty()) return picture.problem;
    if (picture.within()) return "the same within tolerance";
    std::string text = counted(picture.coverage_flips, "pixel") + " of the outline, " +
                       std::to_string(picture.face_flips) + " of another face";
    for (const LayerDifference& layer : picture.layers)
        if (!layer.within)
            text +=
                "; " + layer.layer + " beyond its tolerance in " + counted(layer.beyond, "pixel");
    return text;
}

std::string triple(const Vec3& v, int digits) {
    return "(" + short_number(v.x, digits) + ", " + short_number(v.y, digits) + ", " +
           short_number(v.z, digits) + ")";
}

std::string alignment_words(const Alignment& a) {
    constexpr int digits = 6;
    return "turned by " + short_number(a.angle, digits) + " degrees about " +
           triple(a.axis, digits) + ", its centre shifted by " + triple(a.shift, digits) +
           " mm; root mean square distance left " + short_number(a.residual) + " mm" +
           (a.converged ? "" : "; not converged");
}

std::vector<ComparisonCheck> comparison_checks(const Comparison& c) {
    std::vector<ComparisonCheck> checks{
        surface_check("deviation", "surfaces of the part after", c.deviation,
                      c.tolerance.deviation),
        surface_check("missing", "surfaces of the part before", c.missing, c.tolerance.deviation),
        normals_check(c),
        borders_check(c),
        faces_check(c),
        seams_check(c),
        findings_check(c)};
    for (const ComparedView& view : c.views) checks.push_back(outlines_check(c, view));
    for (const ComparedView& view : c.views)
        if (!view.lines.empty() || !view.after_lines.empty())
            checks.push_back(lines_check(view, c.tolerance));
    return checks;
}

} // namespace keiko
