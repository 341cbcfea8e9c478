#include "keiko/report/content/comparison.h"
#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace keiko {
namespace {

std::string tone_cell(const std::string& text) {
    return "<td class=\"tone\">" + html_escaped(text) + "</td>";
}

std::string row(const std::string& tone, const std::string& cells) {
    return "<tr class=\"" + tone + "\">" + cells + "</tr>";
}

/// Text of a missing number.
const std::string none = "–";

std::string number(const std::optional<double>& value, double scale = 1) {
    return value ? short_number(*value * scale) : none;
}

std::string percentile_row(const std::string& name, const Deviation& d) {
    std::string cells = html_text_cell(name, true);
    for (const double value : {d.median, d.percent_90, d.percent_99, d.percent_99_9, d.worst.value})
        cells += html_text_cell(distance_words(value, d.reach));
    const auto near = [&](double value) { return d.beyond < 1 ? short_number(value) : none; };
    return "<tr>" + cells + html_text_cell(near(d.mean)) +
           html_text_cell(near(d.root_mean_square)) + html_text_cell(short_number(100 * d.beyond)) +
           html_text_cell(short_number(100 * d.uncertain_share)) + "</tr>";
}

/// The faces with the largest deviations, beyond the tolerance, at most `most`.
std::vector<std::size_t> worst_faces(const Deviation& d, double tolerance, std::size_t most) {
    std::vector<std::size_t> order(d.faces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::erase_if(order,
                  [&](std::size_t f) { return std::abs(d.faces[f].worst.value) <= tolerance; });
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::abs(d.faces[a].worst.value) > std::abs(d.faces[b].worst.value);
    });
    order.resize(std::min(order.size(), most));
    return order;
}

std::string place_rows(const std::string& side, const Deviation& d,
                       const std::vector<std::string>& names,
                       const std::vector<std::string>& others, double tolerance) {
    constexpr std::size_t most = 10;
    std::string rows;
    for (const std::size_t f : worst_faces(d, tolerance, most)) {
        const FaceDeviation& face = d.faces[f];
        const std::string partner = face.partner == no_index ? none : others[face.partner];
        rows += row("fail", html_text_cell(side, true) + html_text_cell(names[f], true) +
                                html_text_cell(face.alone() ? "none" : partner, true) +
                                tone_cell(distance_words(face.worst.value, d.reach)) +
                                html_text_cell(place_text(face.worst.place)) +
                                html_text_cell(face.beyond < 1 ? short_number(face.root_mean_square)
                                                               : none));
    }
    return rows;
}

std::string state_cells(const SeamChange& c) {
    const auto both = [](const std::string& before, const std::string& after) {
        return html_text_cell(before == after ? before : before + " → " + after);
    };
    return both(short_number(c.before.gap), short_number(c.after.gap)) +
           both(number(c.before.angle), number(c.after.angle)) +
           both(number(c.before.curvature, 100), number(c.after.curvature, 100)) +
           both(std::string(name_of(c.before.verdict)), std::string(name_of(c.after.verdict))) +
           html_text_cell(place_text(c.after.place));
}

std::string tone_of(SeamTrend trend) {
    if (trend == SeamTrend::worse) return "fail";
    return trend == SeamTrend::better ? "pass" : "undecided";
}

std::string lone_rows(const Inspection& inspection, const std::vector<std::uint32_t>& seams,
                      const std::string& word) {
    std::string rows;
    for (const std::uint32_t i : seams) {
        const MeasuredSeam& seam = inspection.seams[i];
        rows += row("undecided",
                    tone_cell(word) + html_text_cell(seam.faces, true) +
                        html_text_cell(short_number(seam.gap.value)) +
                        html_text_cell(seam.angle ? short_number(seam.angle->value) : none) +
                        html_text_cell("") + html_text_cell(std::string(name_of(seam.verdict))) +
                        html_text_cell(place_text(seam.middle)));
    }
    return rows;
}

std::string finding_rows(const std::vector<Check>& findings, const std::string& word,
                         const std::string& tone) {
    std::string rows;
    for (const Check& finding : findings)
        rows += row(tone, tone_cell(word) + html_text_cell(finding.faces, true) +
                              html_text_cell(finding.message, true) +
                              html_text_cell(place_text(finding.worst.place)));
    return rows;
}

std::string line_rows(const std::vector<LineShift>& lines, const std::string& side, double allowed,
                      bool every) {
    std::string rows;
    for (const LineShift& line : lines) {
        const bool within = line.largest <= allowed && !is_alone(line);
        if (within && !every) continue;
        rows +=
            row(within ? "pass" : "fail",
                html_text_cell(side, true) + html_text_cell(std::to_string(line.plane + 1)) +
                    html_text_cell(std::to_string(line.lamp + 1)) +
                    html_text_cell(fixed_number(line.length, 1)) +
                    html_text_cell(fixed_number(line.alone, 1)) +
                    html_text_cell(short_number(line.mean)) +
                    tone_cell(short_number(line.largest)) + html_text_cell(place_text(line.place)));
    }
    return rows;
}

std::string check_row(const ComparisonCheck& check) {
    const std::string tone = !check.judged ? "undecided" : check.within ? "pass" : "fail";
    const std::string word = !check.judged ? "not judged" : check.within ? "within" : "beyond";
    return row(tone, html_text_cell(check.name, true) + tone_cell(word) +
                         html_text_cell(check.message, true));
}

} // namespace

std::string html_checks(const Comparison& c) {
    std::string rows;
    for (const ComparisonCheck& check : comparison_checks(c)) rows += check_row(check);
    for (const ComparedView& view : c.views)
        rows += check_row(
            {view.picture.view + ": pictures", view.picture.within(), picture_words(view.picture)});
    return html_plain_table({"<check", "", "<"}, rows);
}

std::string html_percentiles(const Comparison& c) {
    return html_plain_table({"<of the area", "half within", "90 %", "99 %", "99.9 %", "worst",
                             "mean, mm", "rms, mm", "beyond reach, %", "not proved, %"},
                            percentile_row("after from before", c.deviation) +
                                percentile_row("before from after", c.missing));
}

std::string html_worst_places(const Comparison& c) {
    const double tolerance = c.tolerance.deviation;
    const std::string rows =
        place_rows("after", c.deviation, c.faces_after, c.faces_before, tolerance) +
        place_rows("before", c.missing, c.faces_before, c.faces_after, tolerance);
    if (rows.empty()) return "";
    return html_plain_table(
        {"<revision", "<face", "<lies on", "worst", "at, mm", "root mean square, mm"}, rows);
}

std::string html_seam_changes(const Comparison& c) {
    std::string rows;
    for (const SeamChange& change : c.seams.changed)
        rows += row(
            tone_of(change.trend),
            tone_cell(std::string(name_of(change.trend))) +
                html_text_cell(c.inspection_after.seams[change.seams.after.front()].faces, true) +
                state_cells(change));
    rows += lone_rows(c.inspection_before, c.seams.removed, "gone");
    rows += lone_rows(c.inspection_after, c.seams.added, "new");
    if (rows.empty()) return "";
    return html_plain_table(
        {"", "<faces", "gap, mm", "angle, °", "curvature, %", "verdict", "at, mm"}, rows);
}

std::string html_finding_changes(const Comparison& c) {
    const std::string rows = finding_rows(c.seams.new_findings, "new", "fail") +
                             finding_rows(c.seams.solved_findings, "fixed", "pass") +
                             finding_rows(c.seams.same_findings, "same", "crease");
    if (rows.empty()) return "";
    return html_plain_table({"", "<faces", "<finding", "at, mm"}, rows);
}

std::string html_line_shifts(const ComparedView& view, const BodyTolerance& tolerance) {
    const std::string rows = line_rows(view.lines, "before", tolerance.line, true) +
                             line_rows(view.after_lines, "after", tolerance.line, false);
    if (rows.empty()) return "";
    return html_plain_table({"<line of", "plane", "lamp", "length, mm", "without partner, mm",
                             "moved in the mean, mm", "at most, mm", "at, mm"},
                            rows);
}

} // namespace keiko
