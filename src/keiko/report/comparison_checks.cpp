#include "keiko/report/comparison.h"
#include "keiko/report/comparison_words.h"
#include "keiko/report/html_text.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr double nothing = 1e-9; // mm: roundings

ComparisonCheck surface_check(const char* name, const std::string& what, const Deviation& d,
                              double tolerance) {
    const bool within = std::abs(d.worst.value) <= tolerance;
    return {name, within,
            what + " " + at_most(d.worst.value, d.reach) + " away, at " +
                place_text(d.worst.place) + "; " + short_number(tolerance) + " mm allowed"};
}

ComparisonCheck normals_check(const Comparison& c) {
    const DeviationPlace &a = c.deviation.worst_normal, &b = c.missing.worst_normal;
    const DeviationPlace& worst = a.value >= b.value ? a : b;
    return {"normals", worst.value <= c.tolerance.normal,
            "normals at most " + short_number(worst.value) + " degrees apart, at " +
                place_text(worst.place) + "; " + short_number(c.tolerance.normal) + " allowed"};
}

ComparisonCheck borders_check(const Comparison& c) {
    const DeviationPlace &a = c.deviation.worst_border, &b = c.missing.worst_border;
    const DeviationPlace& worst = a.value >= b.value ? a : b;
    return {"borders", worst.value <= c.tolerance.border,
            "borders " + at_most(worst.value, c.deviation.reach) + " apart, at " +
                place_text(worst.place) + "; " + short_number(c.tolerance.border) + " mm allowed"};
}

ComparisonCheck faces_check(const Comparison& c) {
    const std::size_t gone = faces_gone(c).size(), fresh = faces_new(c).size(),
                      turned = faces_turned(c).size();
    return {"faces", gone + fresh + turned == 0,
            std::to_string(gone) + " faces gone, " + std::to_string(fresh) + " new, " +
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
            std::to_string(worse) + " seams worse, " + std::to_string(better) + " better, " +
                std::to_string(other) + " otherwise changed, " +
                std::to_string(c.seams.removed.size()) + " gone, " +
                std::to_string(c.seams.added.size()) + " new; " + std::to_string(c.seams.matched) +
                " found again"};
}

ComparisonCheck findings_check(const Comparison& c) {
    const std::size_t fresh = c.seams.new_findings.size(), fixed = c.seams.solved_findings.size();
    return {"findings", fresh + fixed == 0,
            std::to_string(fresh) + " findings new, " + std::to_string(fixed) + " fixed, " +
                std::to_string(c.seams.same_findings.size()) + " the same"};
}

ComparisonCheck lines_check(const ComparedView& view, const BodyTolerance& tolerance) {
    double largest = 0;
    for (const auto* lines : {&view.lines, &view.after_lines})
        for (const LineShift& line : *lines) largest = std::max(largest, line.largest);
    const auto alone = [](const std::vector<LineShift>& lines) {
        return std::to_string(std::count_if(lines.begin(), lines.end(), is_alone));
    };
    return {view.picture.view + ": lines", lines_within(view, tolerance),
            "reflection lines moved by at most " + short_number(largest) + " mm on the part, " +
                short_number(tolerance.line) + " allowed; of " + std::to_string(view.lines.size()) +
                " lines " + alone(view.lines) + " gone or shorter, " + alone(view.after_lines) +
                " new or longer"};
}

} // namespace

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
    std::string text = std::to_string(picture.coverage_flips) + " pixels of the outline, " +
                       std::to_string(picture.face_flips) + " of another face";
    for (const LayerDifference& layer : picture.layers)
        if (!layer.within)
            text += "; " + layer.layer + " beyond its tolerance in " +
                    std::to_string(layer.beyond) + " pixels";
    return text;
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
    for (const ComparedView& view : c.views)
        if (!view.lines.empty() || !view.after_lines.empty())
            checks.push_back(lines_check(view, c.tolerance));
    return checks;
}

} // namespace keiko
