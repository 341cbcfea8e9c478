#include "keiko/base/text.h"
#include "keiko/report/content/comparison.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

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
