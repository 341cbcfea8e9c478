#include "keiko/base/units.h"
#include "keiko/inspect/seams/curvature_match.h"
#include "keiko/inspect/seams/seam_quantities.h"
#include "keiko/report/content/profiles_text.h"
#include "keiko/report/html/html_seam_parts.h"
#include "keiko/report/html/html_sections.h"
#include "keiko/report/markup/html_text.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

bool over(const MeasuredValue& worst) {
    return worst.verdict != Verdict::pass;
}

/// One measure against its limit, with a bar that is full at the limit.
std::string measure(std::string_view label, std::string_view tone, const std::string& value,
                    const std::string& note, double share_of_limit) {
    return "<div class=\"measure " + std::string(tone) + "\"><span class=\"soft\">" +
           std::string(label) + "</span> <b>" + value + "</b>" + html_bar(share_of_limit) +
           "<span class=\"soft small\">" + note + "</span></div>";
}

std::string gap_measure(const MeasuredSeam& seam) {
    const MeasuredValue& gap = seam.gap;
    return measure(seam.overlap && over(gap) ? "overlap" : "gap", name_of(gap.verdict),
                   fixed_number(gap.value, 4) + " mm", "limit " + short_number(gap.limit) + " mm",
                   share_of_limit(gap));
}

/// Shift of a lamp's image by a seam angle, for lamps 2 m away: docs/theory/verdict.md. Over a fold
/// no image is continued.
std::string lamp_shift(double degrees) {
    constexpr double lamp_distance = 2000; // mm
    constexpr double fold = 30;            // degrees
    if (degrees > fold) return "";
    const double shift = 2 * lamp_distance * std::tan(degrees_to_radians(degrees));
    return " · " + fixed_number(shift, 1) + " mm at 2 m";
}

/// `left`: degrees that are left where a crease ends at the stretch; 0 for others.
std::string angle_measure(const MeasuredSeam& seam, double left) {
    if (!seam.angle) return measure("angle", "crease", "–", "no normal on one side", 0);
    const MeasuredValue& angle = *seam.angle;
    if (left > 0)
        return measure(
            "angle", name_of(angle.verdict), fixed_number(left, 3) + "°",
            "where the crease ends, limit " + short_number(angle.limit) + "°" + lamp_shift(left),
            left / angle.limit);
    const std::string value = fixed_number(angle.value, 3) + "°";
    if (seam.kind == SeamClass::crease)
        return measure("angle", "crease", value, "a crease, not judged", 1);
    if (seam.kind == SeamClass::run_out)
        return measure("angle", "crease", value, "fades out, judged with the crease", 1);
    return measure("angle", name_of(angle.verdict), value,
                   "limit " + short_number(angle.limit) + "°" + lamp_shift(angle.value),
                   share_of_limit(angle));
}

/// Radius across the seam on a side; those of both sides have one sign where they bend one way.
std::string radius_text(double curvature) {
    constexpr double flat = 1e-6, in_metres = 1e-4, whole = 1e-2; // 1/mm
    const double size = std::abs(curvature);
    if (size < flat) return "flat";
    const double radius = 1 / curvature;
    if (size <= in_metres) return "R " + fixed_number(radius / 1000, 1) + " m";
    return "R " + (size > whole ? short_number(radius) : fixed_number(radius, 0)) + " mm";
}

std::string radii_text(double a, double b) {
    return radius_text(a) + " | " + radius_text(b);
}

/// The place of a profile nearest to a place, world, mm; null without a profile.
const SeamPoint* profile_point(const SeamProfile* profile, const Vec3& place) {
    const SeamPoint* nearest = nullptr;
    if (!profile) return nearest;
    for (const ProfileSample& sample : profile->samples)
        if (!nearest || (sample.point.place - place).length2() < (nearest->place - place).length2())
            nearest = &sample.point;
    return nearest;
}

/// The mismatch of a place and the largest of its seam, with the limit: "42.0 % where it is seen
/// best, up to 100.0 % on the seam, ...".
std::string mismatch_text(const CurvatureStep& step, const SeamPoint* shown,
                          const CriteriaPreset& limits) {
    const std::string largest = fixed_number(step.mismatch * 100, 1) + " %";
    const std::string limit = std::string(formula_text(step.formula)) + ", limit " +
                              short_number(step.worst.limit * 100) + " %" +
                              (step.flat ? ", against the flat radius" : "");
    if (!shown) return radii_text(step.curvature_a, step.curvature_b) + ", " + limit;
    const double here = SeamQuantities(limits).mismatch(step.formula, *shown);
    return fixed_number(here * 100, 1) + " % where it is seen best, up to " + largest +
           " on the seam, " + limit;
}

/// `shown`: where the reflection breaks most, if known; else the radii are those of the largest
/// mismatch.
std::string curvature_measure(const MeasuredSeam& seam, const SeamPoint* shown,
                              const CriteriaPreset& limits) {
    const std::string radii =
        shown ? radii_text(shown->curvature_a, shown->curvature_b) : std::string("–");
    if (!seam.curvature)
        return measure("curvature", "crease", radii, "judged where gap and angle pass", 0);
    const CurvatureStep& step = *seam.curvature;
    return measure("curvature", name_of(step.worst.verdict),
                   shown ? radii : fixed_number(step.mismatch * 100, 1) + " %",
                   mismatch_text(step, shown, limits), share_of_limit(step.worst));
}

/// Cell of the fading; empty for a seam that is no crease, and for a crease that does not fade out.
std::string fading_measure(const MeasuredSeam& seam) {
    if (!seam.fading) return "";
    const MeasuredValue& worst = *seam.fading;
    return measure("run-out", name_of(worst.verdict), short_number(worst.value) + " °/mm",
                   "step of the slope, limit " + short_number(worst.limit) + " °/mm",
                   share_of_limit(worst));
}

/// Cell of the slope; empty if the preset does not judge it.
std::string slope_measure(const MeasuredSeam& seam, const CriteriaPreset& preset) {
    if (!preset.curvature_slope) return "";
    if (!seam.slope)
        return measure("curvature's slope", "crease", "–",
                       seam.curvature && seam.curvature->worst.verdict == Verdict::pass
                           ? "nearly flat, not judged"
                           : "judged where curvature passes",
                       0);
    const MeasuredValue& worst = seam.slope->worst;
    return measure("curvature's slope", name_of(worst.verdict), fixed_number(worst.value, 3) + "°",
                   "limit " + short_number(worst.limit) + "°", share_of_limit(worst));
}

/// Note on unusual properties of the seam.
std::string kind_note(const MeasuredSeam& seam) {
    std::string note = seam.internal ? " · a knot line inside the face" : "";
    if (seam.kind == SeamClass::fold)
        note += " · folded back";
    else if (seam.overlap && over(seam.gap))
        note += " · one side lies on the other";
    if (seam.parted) note += " · wider than the join distance";
    return note;
}

/// The plots of a stretch, folded.
std::string folded_profile_of(const Report& report, std::uint32_t index) {
    const std::string plots = plots_of(report, index);
    return plots.empty() ? ""
                         : "<details><summary>all along the seam</summary>" + plots + "</details>";
}

} // namespace

std::string seam_tone(const MeasuredSeam& seam) {
    if (seam.scrap || seam.is_passing_crease()) return "crease";
    return std::string(name_of(seam.verdict));
}

std::string irregular_note(const MeasuredSeam& seam) {
    return seam.irregular ? ", at an irregular point of the cage" : "";
}

const SeamProfile* profile_of(const Report& report, std::uint32_t seam) {
    const auto found =
        std::find_if(report.profiles.begin(), report.profiles.end(),
                     [seam](const SeamProfile& profile) { return profile.seam == seam; });
    return found == report.profiles.end() ? nullptr : &*found;
}

std::string plots_of(const Report& report, std::uint32_t seam) {
    const SeamProfile* profile = profile_of(report, seam);
    if (!profile) return "";
    const Inspection& inspection = report.inspection;
    const CriteriaPreset& limits = limits_of(inspection, inspection.seams[seam]);
    return profile_svg(*profile, SeamQuantities(limits).curvature_limit().formula);
}

std::string html_seam_card(const Report& report, std::size_t rank, const ShownItem& item,
                           const std::string& heading, const std::string& note) {
    const std::uint32_t index = item.seam;
    const SeamPoint* shown =
        item.fault ? profile_point(profile_of(report, index), item.place) : nullptr;
    const MeasuredSeam& seam = report.inspection.seams[index];
    const CriteriaPreset& limits = limits_of(report.inspection, seam);
    return "<div class=\"card seam " + seam_tone(seam) + "\"><div class=\"rank\">" +
           std::to_string(rank) + "</div><div class=\"body\"><div class=\"name\">" + heading +
           "seam " + std::to_string(index + 1) + " · " + html_escaped(seam.faces) + "</div>" +
           note + "<div class=\"soft small\">at " + place_with_axes(item.place) +
           irregular_note(seam) + " · seam of " + fixed_number(seam.length, 1) + " mm" +
           kind_note(seam) + "</div><div class=\"measures\">" + gap_measure(seam) +
           angle_measure(seam, item.fault ? item.fault->left_of_crease : 0) +
           curvature_measure(seam, shown, limits) + slope_measure(seam, limits) +
           fading_measure(seam) + "</div>" + folded_profile_of(report, index) + "</div>" +
           html_close_up(report, CloseUp::Of::seam, index, item.place) + "</div>\n";
}

} // namespace keiko
