#include "keiko/inspect/joint_checks.h"
#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>

namespace keiko {
namespace {

/// Worst outcome of a joint: "pass" only where a limit was held against it.
std::string tone_of(const Joint& joint, const JointLimits& limits) {
    const std::vector<Check> checks = checks_of(joint, limits);
    if (checks.empty()) return "crease";
    const auto worst = std::max_element(
        checks.begin(), checks.end(),
        [](const Check& a, const Check& b) { return a.worst.verdict < b.worst.verdict; });
    return std::string(name_of(worst->worst.verdict));
}

/// "3.482 to 4.210", sorted by the larger.
std::string range_cell(double low, double high) {
    return html_cell(short_number(high, 9), fixed_number(low, 3) + " to " + fixed_number(high, 3));
}

std::string size_cells(const Joint& joint) {
    const std::string none = html_cell("", "–");
    if (!joint.extremes) return none + none + none;
    const JointExtremes& e = *joint.extremes;
    const double radius = e.sharpest.least_radius();
    return range_cell(e.narrowest.gap, e.widest.gap) +
           range_cell(e.deepest.flush, e.proudest.flush) +
           html_number_cell(radius, fixed_number(radius, 3), false);
}

std::string row(const Joint& joint, std::size_t number, const JointLimits& limits) {
    const std::string tone = tone_of(joint, limits);
    return "<tr class=\"" + tone + "\">" +
           html_cell(std::to_string(number), std::to_string(number)) +
           html_words_cell(joint.names) +
           html_cell(tone, "<span class=\"chip\">" + (tone == "crease" ? "not judged" : tone) +
                               "</span>") +
           size_cells(joint) +
           html_number_cell(joint.length, fixed_number(joint.length, 1), false) +
           html_number_cell(joint.unmeasured, fixed_number(joint.unmeasured, 1),
                            joint.unmeasured > 0) +
           html_place_cell(joint.stations.front().place) + "</tr>\n";
}

/// A size that is wanted: ", 4 ± 0.5 mm"; empty where none is.
std::string wanted(const std::optional<NominalSize>& size) {
    if (!size) return "";
    return ", " + short_number(size->nominal) + " ± " + short_number(size->tolerance) + " mm";
}

} // namespace

std::string html_joints(const Report& report) {
    const Inspection& inspection = report.inspection;
    if (!inspection.joints || inspection.joints->empty()) return "";
    const JointLimits& limits = inspection.preset.joint;
    std::string html =
        "<section><h2>Joints</h2><p class=\"soft\">Between panels that stand apart: the gap "
        "between "
        "their foremost points, and by how much the second stands out over the first.</p>" +
        html_table_head(
            {"#", "faces", "verdict", "gap mm" + wanted(limits.gap),
             "flush mm" + wanted(limits.flush),
             limits.radius ? "radius mm ≥ " + short_number(*limits.radius) : "radius mm",
             "length mm", "unmeasured mm", "begins x, y, z"},
            {"faces"});
    for (std::size_t i = 0; i < inspection.joints->size(); ++i)
        html += row((*inspection.joints)[i], i + 1, limits);
    return html + std::string(html_table_end) + "</section>\n";
}

} // namespace keiko
