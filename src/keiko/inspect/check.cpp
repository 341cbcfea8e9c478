#include "keiko/inspect/check.h"

#include "keiko/inspect/curvature_match.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <stdexcept>

namespace keiko {
namespace {

constexpr std::array criteria{
    Criterion{"G-SU-LG", "gap_between_faces_related_to_an_edge", "gap",
              "Distance between the trimmed borders of the two sides of a seam (G0)."},
    Criterion{"G-SU-NT", "g1_discontinuity_between_adjacent_faces", "angle",
              "Angle between the surface normals on the two sides of a seam (G1)."},
    Criterion{"G-SU-NS", "g2_discontinuity_between_adjacent_faces", "curvature",
              "Mismatch of the normal curvatures across a seam (G2)."},
    // Neither SASIG nor ISO 10303-59 names a check of G3.
    Criterion{"KEIKO-G3", "", "curvature_slope",
              "Change of the slope of the normal curvature across a seam (G3)."},
    Criterion{"G-SU-CR", "surface_with_small_curvature_radius", "radius",
              "Smallest radius of curvature of a face, over what its trims leave of it."}};

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

/// How a measure is put into words.
struct Wording {
    const char* what; ///< "the gap"
    const char* unit; ///< " mm"
    double scale = 1; ///< what is printed is the value times this
};

std::string sentence(const Worst& worst, const Wording& wording) {
    const char* relation =
        worst.verdict == Verdict::fail
            ? (worst.at_least ? " is under the limit of " : " is over the limit of ")
        : worst.verdict == Verdict::pass ? " is within the limit of "
                                         : " cannot be told from the limit of ";
    return std::string(wording.what) + " of " + short_number(worst.value * wording.scale) +
           wording.unit + relation + short_number(worst.limit * wording.scale) + wording.unit;
}

Check named(std::string_view code) {
    const Criterion& criterion = criterion_of(code);
    Check check;
    check.code = criterion.code, check.rule = criterion.rule, check.quantity = criterion.quantity;
    return check;
}

Check judged(std::string_view code, const std::string& unit, const Worst& worst,
             const Wording& wording) {
    Check check = named(code);
    check.unit = unit, check.worst = worst, check.message = sentence(worst, wording);
    return check;
}

Check not_judged(std::string_view code, const std::string& reason) {
    Check check = named(code);
    check.judged = false, check.message = "the " + check.quantity + " is not judged: " + reason;
    std::replace(check.message.begin(), check.message.end(), '_', ' ');
    return check;
}

Check angle_check(const MeasuredSeam& seam) {
    if (!seam.angle) return not_judged("G-SU-NT", "a side has no normal");
    if (seam.crease) return not_judged("G-SU-NT", "the seam is a crease");
    return judged("G-SU-NT", "deg", *seam.angle, {"the angle", " degrees"});
}

Check curvature_check(const MeasuredSeam& seam) {
    if (seam.crease) return not_judged("G-SU-NS", "the seam is a crease");
    if (!seam.curvature) return not_judged("G-SU-NS", "gap and angle do not both pass");
    const CurvatureStep& step = *seam.curvature;
    Check check = step.flat
                      ? judged("G-SU-NS", "1/mm", step.worst, {"the curvature change", " /mm"})
                      : judged("G-SU-NS", "1", step.worst, {"the curvature mismatch", " %", 100});
    check.formula = step.flat ? "|C1-C2|" : std::string(formula_text(step.formula));
    return check;
}

Check slope_check(const MeasuredSeam& seam) {
    if (seam.crease) return not_judged("KEIKO-G3", "the seam is a crease");
    if (!seam.curvature || seam.curvature->worst.verdict != Verdict::pass)
        return not_judged("KEIKO-G3", "gap, angle and curvature do not all pass");
    if (!seam.slope) return not_judged("KEIKO-G3", "the seam is nearly flat");
    Check check = judged("KEIKO-G3", "deg", seam.slope->worst,
                         {"the change of the curvature's slope", " degrees"});
    check.formula = "|atan2(k1',k1^2)-atan2(k2',k2^2)|";
    return check;
}

} // namespace

std::vector<Check> checks_of(const MeasuredFace& face, const SurfaceLimits& limits,
                             std::uint32_t index) {
    if (!limits.minimum_radius) return {};
    Check check = !face.curvature ? not_judged("G-SU-CR",
                                               "the face stands in for another, or nothing is "
                                               "left of it")
                  : !face.radius
                      ? not_judged("G-SU-CR", "the face is flat")
                      : judged("G-SU-CR", "mm", *face.radius, {"the smallest radius", " mm"});
    check.face = index, check.faces = face.name;
    return {std::move(check)};
}

const Criterion& criterion_of(std::string_view code) {
    const auto found = std::find_if(criteria.begin(), criteria.end(),
                                    [&](const Criterion& c) { return c.code == code; });
    if (found == criteria.end()) throw std::out_of_range("no criterion " + std::string(code));
    return *found;
}

std::vector<Check> checks_of(const MeasuredSeam& seam, const CriteriaPreset& preset,
                             std::uint32_t index) {
    std::vector<Check> checks{judged("G-SU-LG", "mm", seam.gap, {"the gap", " mm"}),
                              angle_check(seam)};
    if (preset.curvature) checks.push_back(curvature_check(seam));
    if (preset.curvature_slope) checks.push_back(slope_check(seam));
    for (Check& check : checks) {
        check.seam = index;
        check.faces = seam.faces;
    }
    return checks;
}

} // namespace keiko
