#include "keiko/inspect/finding.h"

#include "keiko/inspect/curvature_match.h"

#include <cstdio>

namespace keiko {
namespace {

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

std::string sentence(const std::string& what, const Worst& worst, const std::string& unit,
                     double scale) {
    const std::string relation = worst.verdict == Verdict::fail
                                     ? " is over the limit of "
                                     : " cannot be told from the limit of ";
    return what + " " + short_number(worst.value * scale) + unit + relation +
           short_number(worst.limit * scale) + unit;
}

Finding gap_finding(const MeasuredSeam& seam) {
    return {.code = "G-SU-LG",
            .rule = "gap_between_faces_related_to_an_edge",
            .quantity = "gap",
            .unit = "mm",
            .formula = "",
            .worst = seam.gap,
            .seam = 0,
            .faces = "",
            .message = sentence("the gap of", seam.gap, " mm", 1)};
}

Finding angle_finding(const Worst& angle) {
    return {.code = "G-SU-NT",
            .rule = "g1_discontinuity_between_adjacent_faces",
            .quantity = "angle",
            .unit = "deg",
            .formula = "",
            .worst = angle,
            .seam = 0,
            .faces = "",
            .message = sentence("the angle of", angle, " degrees", 1)};
}

Finding curvature_finding(const CurvatureStep& step) {
    return {.code = "G-SU-NS",
            .rule = "g2_discontinuity_between_adjacent_faces",
            .quantity = "curvature",
            .unit = step.flat ? "1/mm" : "1",
            .formula = step.flat ? "|C1-C2|" : std::string(formula_text(step.formula)),
            .worst = step.worst,
            .seam = 0,
            .faces = "",
            .message = step.flat ? sentence("the curvature change of", step.worst, " /mm", 1)
                                 : sentence("the curvature mismatch of", step.worst, " %", 100)};
}

/// Neither SASIG nor ISO 10303-59 names a check of G3.
Finding slope_finding(const CurvatureSlopeStep& step) {
    return {
        .code = "KEIKO-G3",
        .rule = "",
        .quantity = "curvature_slope",
        .unit = "deg",
        .formula = "|atan2(k1',k1^2)-atan2(k2',k2^2)|",
        .worst = step.worst,
        .seam = 0,
        .faces = "",
        .message = sentence("the change of the curvature's slope of", step.worst, " degrees", 1)};
}

} // namespace

std::vector<Finding> findings_of(const MeasuredSeam& seam, std::uint32_t index) {
    std::vector<Finding> found;
    if (seam.gap.verdict != Verdict::pass) found.push_back(gap_finding(seam));
    if (seam.angle && !seam.crease && seam.angle->verdict != Verdict::pass)
        found.push_back(angle_finding(*seam.angle));
    if (seam.curvature && seam.curvature->worst.verdict != Verdict::pass)
        found.push_back(curvature_finding(*seam.curvature));
    if (seam.slope && seam.slope->worst.verdict != Verdict::pass)
        found.push_back(slope_finding(*seam.slope));
    for (Finding& finding : found) {
        finding.seam = index;
        finding.faces = seam.faces;
    }
    return found;
}

} // namespace keiko
