#include "keiko/inspect/check.h"

#include "keiko/inspect/openings/opening.h"
#include "keiko/inspect/overlaps/overlap.h"
#include "keiko/inspect/seams/curvature_match.h"
#include "keiko/inspect/seams/narrow_faces.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
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
    // Neither [SASIG-PDQ] nor [ISO10303-59] names a check of G3.
    Criterion{"KEIKO-G3", "", "curvature_slope",
              "Change of the slope of the normal curvature across a seam (G3)."},
    Criterion{"KEIKO-RUN-OUT", "", "fading",
              "Step of the slope of a crease's angle along the seam where the crease fades out."},
    Criterion{"G-SU-NA", "entirely_narrow_face", "width",
              "Width of a strip of a face beside a crease: the step across it is not judged."},
    Criterion{"G-SU-CR", "surface_with_small_curvature_radius", "radius",
              "Smallest radius of curvature of a face, over what its trims leave of it."},
    Criterion{"G-SU-WV", "", "waviness", "Depth of waves of a surface, off the form around them."},
    Criterion{"KEIKO-DENT", "", "dent",
              "Depth of a dent or height of a bump of a surface, off the form around it."},
    Criterion{"G-SU-FO", "abrupt_change_of_surface_normal", "fold",
              "Angle by which the normal of a face turns over inside it: the face folds back."},
    Criterion{"KEIKO-SINGULAR", "abrupt_change_of_surface_normal", "singular_place",
              "Angle between the normals about a place of a face at which they have no limit."},
    Criterion{
        "KEIKO-OPENING", "", "opening",
        "Width of a notch, slit or small hole between free edges of faces that meet or nearly do."},
    Criterion{"KEIKO-OVERLAP", "partly_overlapping_faces", "overlap",
              "Length of a free edge that lies on the inside of another face, the faces on each "
              "other."},
    Criterion{"KEIKO-TEE", "", "tee",
              "Length of a free edge that ends on the inside of another face, its face at an angle "
              "to that."},
    Criterion{"KEIKO-CROSSING", "", "crossing",
              "Length of a free edge beside the face that it passes through."},
    Criterion{"G-SU-HD", "excessively_high_degree_surface", "degree",
              "Degree of a spline surface, the larger of its two."},
    // Neither [SASIG-PDQ] as Keiko knows it nor [ISO10303-59] names a limit of spans.
    Criterion{"KEIKO-SPANS", "", "spans",
              "Number of knot spans of a spline surface, the larger of its two directions."},
    Criterion{"G-SU-IK", "indistinct_surface_knots", "knot_distance",
              "Width in space of the narrowest knot span of a spline surface."},
    Criterion{"G-SU-TI", "narrow_surface_patch", "patch_edge",
              "Length of the shortest edge of a patch that is not a point."},
    Criterion{"G-SU-DC", "nearly_degenerate_surface_boundary", "degenerate_edge",
              "Length of the shortest edge of a patch, 0 where the edge is a point."},
    Criterion{"G-SU-DP", "nearly_degenerate_surface_patch", "corner_angle",
              "Angle between the edges of a patch at a corner, from 0 or 180 degrees."},
    Criterion{"G-CU-TI", "short_length_edge", "edge_length",
              "Length of the shortest edge that bounds a face."},
    Criterion{"G-FA-TI", "small_area_face", "face_size",
              "Size of a face: the diagonal of the box of its borders."},
    Criterion{"KEIKO-SYMMETRY", "", "symmetry",
              "Largest distance of a body's surface from its own mirror image."},
    Criterion{"KEIKO-LINE-JUMP", "", "line_jump",
              "Jump of a reflection line across itself where it crosses a seam."},
    Criterion{
        "KEIKO-LINE-TURN", "", "line_turn",
        "Seam angle that moves a lamp's image as far as it jumps where its line crosses a seam."},
    Criterion{"KEIKO-LINE-KINK", "", "line_kink",
              "Angle of a reflection line where it crosses a seam."},
    Criterion{"KEIKO-LINE-BEND", "", "line_bend",
              "Change of a reflection line's curvature where it crosses a seam."}};

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

/// A value's error bound with its trailing zeros, "0.0370", which state its precision.
std::string bound_number(double bound) {
    char text[32];
    std::snprintf(text, sizeof text, "%#.3g", bound);
    return text;
}

/// Wording of a measure in messages.
struct Wording {
    const char* what; ///< "the gap"
    const char* unit; ///< " mm"
    double scale = 1; ///< what is printed is the value times this
};

std::string sentence(const MeasuredValue& worst, const Wording& wording) {
    const char* relation =
        worst.verdict == Verdict::fail
            ? (worst.at_least ? " is under the limit of " : " is over the limit of ")
        : worst.verdict == Verdict::pass ? " is within the limit of "
                                         : " cannot be told from the limit of ";
    const std::string bound = worst.verdict == Verdict::undecided
                                  ? " ± " + bound_number(worst.bound * wording.scale)
                                  : "";
    return std::string(wording.what) + " of " + short_number(worst.value * wording.scale) + bound +
           wording.unit + relation + short_number(worst.limit * wording.scale) + wording.unit;
}

Check named(std::string_view code) {
    const Criterion& criterion = criterion_of(code);
    Check check;
    check.code = criterion.code, check.rule = criterion.rule, check.quantity = criterion.quantity;
    return check;
}

Check judged(std::string_view code, const std::string& unit, const MeasuredValue& worst,
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

/// Reason why the angle of a stretch and the quantities derived from it are not judged, or nullptr.
const char* excuse_of(const MeasuredSeam& seam) {
    if (seam.scrap) return "the stretch is shorter than what is negligible";
    if (seam.kind == SeamClass::crease) return "the stretch is a crease";
    if (seam.kind == SeamClass::run_out) return "a crease fades out there";
    return nullptr;
}

Check gap_check(const MeasuredSeam& seam, double join) {
    if (seam.scrap) return not_judged("G-SU-LG", excuse_of(seam));
    Check check = judged("G-SU-LG", "mm", seam.gap, {"the gap", " mm"});
    if (seam.parted)
        check.message +=
            "; the borders part by more than the join distance of " + short_number(join) + " mm";
    return check;
}

/// Check of a seam whose angle is unknown. Where control points coincide at a border, its normal
/// may exist as a limit, and break.
Check unknown_angle(const MeasuredSeam& seam, const CriteriaPreset& preset) {
    if (seam.verdict == Verdict::pass) return not_judged("G-SU-NT", "a side has no normal");
    Check check = named("G-SU-NT");
    check.unit = "deg";
    check.worst = {0, 0, preset.angle, seam.middle, Verdict::undecided};
    check.message = "the angle cannot be measured: a side has no normal";
    return check;
}

/// True if a value is undecided because places have none, not because of its bound.
bool is_known_in_part(const MeasuredValue& worst) {
    return worst.verdict == Verdict::undecided && worst.value + worst.bound <= worst.limit;
}

Check angle_check(const MeasuredSeam& seam, const CriteriaPreset& preset) {
    if (const char* excuse = excuse_of(seam)) return not_judged("G-SU-NT", excuse);
    if (!seam.angle) return unknown_angle(seam, preset);
    Check check = judged("G-SU-NT", "deg", *seam.angle, {"the angle", " degrees"});
    if (seam.kind == SeamClass::fold)
        check.message += seam.stacked
                             ? "; the sides lie over each other, as two skins of a thin sheet do "
                               "where the faces between their borders are missing"
                             : "; the sides lie on each other";
    if (is_known_in_part(*seam.angle))
        check.message = "the angle is " + short_number(seam.angle->value) +
                        " degrees where it can be measured: a side has no normal elsewhere";
    return check;
}

Check fading_check(const MeasuredSeam& seam) {
    if (seam.scrap) return not_judged("KEIKO-RUN-OUT", excuse_of(seam));
    return judged("KEIKO-RUN-OUT", "deg/mm", *seam.fading,
                  {"the step of the slope at which the crease fades", " degrees/mm"});
}

Check curvature_check(const MeasuredSeam& seam) {
    if (const char* excuse = excuse_of(seam)) return not_judged("G-SU-NS", excuse);
    if (!seam.curvature) return not_judged("G-SU-NS", "gap and angle do not both pass");
    const CurvatureStep& step = *seam.curvature;
    Check check = judged("G-SU-NS", "1", step.worst, {"the curvature mismatch", " %", 100});
    check.formula = formula_text(step.formula);
    return check;
}

Check slope_check(const MeasuredSeam& seam) {
    if (const char* excuse = excuse_of(seam)) return not_judged("KEIKO-G3", excuse);
    if (!seam.curvature || seam.curvature->worst.verdict != Verdict::pass)
        return not_judged("KEIKO-G3", "gap, angle and curvature do not all pass");
    if (!seam.slope) return not_judged("KEIKO-G3", "the seam is nearly flat");
    Check check = judged("KEIKO-G3", "deg", seam.slope->worst,
                         {"the change of the curvature's slope", " degrees"});
    check.formula = "|atan2(k1',k1^2)-atan2(k2',k2^2)|";
    return check;
}

constexpr const char* no_curvature = "the face stands in for another, or nothing is left of it";

Check radius_check(const MeasuredFace& face) {
    if (!face.curvature) return not_judged("G-SU-CR", no_curvature);
    if (!face.radius) return not_judged("G-SU-CR", "the face is flat");
    return judged("G-SU-CR", "mm", *face.radius, {"the smallest radius", " mm"});
}

Check unsearched_check(const Flaw& flaw) {
    Check check = judged("G-SU-WV", "mm", flaw.depth, {"the depth of dents and waves", " mm"});
    check.message = "the face, some " + short_number(flaw.width) +
                    " mm long, is too large to be searched for dents and waves in a window of " +
                    short_number(flaw.window) + " mm";
    return check;
}

Check flaw_check(const Flaw& flaw) {
    if (flaw.kind == Flaw::Kind::unsearched) return unsearched_check(flaw);
    Check check = flaw.kind == Flaw::Kind::waves
                      ? judged("G-SU-WV", "mm", flaw.depth, {"the depth of the waves", " mm"})
                  : flaw.kind == Flaw::Kind::dent
                      ? judged("KEIKO-DENT", "mm", flaw.depth, {"the dent", " mm"})
                      : judged("KEIKO-DENT", "mm", flaw.depth, {"the bump", " mm"});
    check.message += ", some " + short_number(flaw.width) + " mm wide";
    const MeasuredValue& depth = flaw.depth;
    if (depth.verdict == Verdict::undecided && depth.value - depth.bound > depth.limit &&
        flaw.kind == Flaw::Kind::waves)
        check.message = "the waves of " + short_number(depth.value) + " mm may be form, as the " +
                        "surface holds less than two of them, some " + short_number(flaw.width) +
                        " mm long";
    return check;
}

/// One check a flaw. If there is no flaw, one check reports this, with the limit of the narrowest
/// window.
std::vector<Check> flaw_checks(const MeasuredFace& face, const WavinessLimit& limit) {
    if (!face.curvature) return {not_judged("G-SU-WV", no_curvature)};
    std::vector<Check> checks;
    for (const Flaw& flaw : face.flaws) checks.push_back(flaw_check(flaw));
    if (!checks.empty()) return checks;
    MeasuredValue none;
    none.limit = limit.depth, none.place = face.curvature->largest.place;
    const char* what = limit.waves_only ? "the depth of waves" : "the depth of dents and waves";
    checks.push_back(judged("G-SU-WV", "mm", none, {what, " mm"}));
    return checks;
}

/// One check a flaw that deserves a look.
std::vector<Check> looks_of(const MeasuredFace& face) {
    std::vector<Check> looks;
    for (const Flaw& flaw : face.flaws) {
        Check check = flaw_check(flaw);
        check.severity = Check::Severity::look;
        if (check.is_worth_a_look()) looks.push_back(std::move(check));
    }
    return looks;
}

/// Check of a singular place. A fold fails, like one at a seam, and a face that is not shown to be
/// regular is undecided. Places without a limit deserve a look.
Check check_of_singular(const SingularPlace& place, const CriteriaPreset& preset) {
    using Kind = SingularPlace::Kind;
    const Verdict of_place = place.kind == Kind::no_limit ? Verdict::fail : verdict_of(place.kind);
    const MeasuredValue worst{place.angle, 0, preset.angle, place.place, of_place};
    Check check = place.kind == Kind::fold
                      ? judged("G-SU-FO", "deg", worst, {"the turn of the normal", " degrees"})
                      : judged("KEIKO-SINGULAR", "deg", worst,
                               {"the angle between normals about one place", " degrees"});
    if (place.kind == Kind::unresolved) check.message = "the face is not shown to be regular";
    if (place.kind == Kind::uneven)
        check.message =
            "the weights of a patch differ by more than a factor of 10000: its seams may "
            "be measured in part";
    check.message += place.kind == Kind::fold ? "; the face folds back on itself" : "";
    if (place.extent > 1e-3) check.message += ", within some " + short_number(place.extent) + " mm";
    if (place.kind == Kind::no_limit) check.severity = Check::Severity::look;
    return check;
}

} // namespace

Check check_of_lines(std::string_view code, const MeasuredValue& worst, std::size_t lines,
                     std::size_t failing) {
    struct LineWording {
        std::string_view code;
        const char* unit;
        Wording wording;
    };
    static constexpr LineWording wordings[] = {
        {"KEIKO-LINE-JUMP", "mm", {"the jump of a line", " mm"}},
        {"KEIKO-LINE-TURN", "deg", {"the turn of a line", " degrees"}},
        {"KEIKO-LINE-KINK", "deg", {"the kink of a line", " degrees"}},
        {"KEIKO-LINE-BEND", "1/mm", {"the change of a line's curvature", " /mm"}}};
    const auto found = std::find_if(std::begin(wordings), std::end(wordings),
                                    [&](const LineWording& w) { return w.code == code; });
    if (found == std::end(wordings))
        throw std::out_of_range("no criterion of lines " + std::string(code));
    Check check = judged(code, found->unit, worst, found->wording);
    check.message += "; of " + std::to_string(lines) + (lines == 1 ? " line " : " lines ") +
                     std::to_string(failing) + " not within it";
    return check;
}

Check check_of_structure(std::string_view code, const std::optional<MeasuredValue>& worst,
                         const char* reason) {
    struct StructureWording {
        std::string_view code;
        const char* unit;
        Wording wording;
    };
    static constexpr StructureWording wordings[] = {
        {"G-SU-HD", "1", {"the degree", ""}},
        {"KEIKO-SPANS", "1", {"the number of spans", ""}},
        {"G-SU-IK", "mm", {"the narrowest knot span", " mm"}},
        {"G-SU-TI", "mm", {"the shortest edge of a patch", " mm"}},
        {"G-SU-DC", "mm", {"the most degenerate edge of a patch", " mm"}},
        {"G-SU-DP", "deg", {"the most degenerate corner of a patch", " degrees"}},
        {"G-CU-TI", "mm", {"the shortest edge of the face", " mm"}},
        {"G-FA-TI", "mm", {"the size of the face", " mm"}}};
    if (!worst) return not_judged(code, reason);
    const auto found = std::find_if(std::begin(wordings), std::end(wordings),
                                    [&](const StructureWording& w) { return w.code == code; });
    if (found == std::end(wordings))
        throw std::out_of_range("no criterion of structure " + std::string(code));
    return judged(code, found->unit, *worst, found->wording);
}

Check check_of_symmetry(const MeasuredValue& worst, const std::string& plane) {
    const std::string what = "the deviation from the mirror image at " + plane;
    return judged("KEIKO-SYMMETRY", "mm", worst, {what.c_str(), " mm"});
}

Check check_of_kink(const NarrowFace& narrow, const CriteriaPreset& preset,
                    const std::string& neighbours) {
    const MeasuredValue worst{narrow.angle, 0, preset.angle, narrow.place, Verdict::fail};
    Check check = judged("G-SU-NT", "deg", worst, {"the angle across a strip", " degrees"});
    check.message += "; the strip is " + short_number(narrow.width) + " mm wide and some " +
                     short_number(narrow.length) + " mm long, between " + neighbours;
    return check;
}

Check check_of_narrow(const NarrowFace& narrow, double join, const std::string& neighbours) {
    MeasuredValue worst{narrow.width, 0, join, narrow.place, Verdict::fail};
    worst.at_least = true;
    Check check = judged("G-SU-NA", "mm", worst, {"the width of a strip beside a crease", " mm"});
    check.message += ", some " + short_number(narrow.length) + " mm long; across it " + neighbours +
                     " step by " + short_number(narrow.step) + " mm and turn by " +
                     short_number(narrow.angle) + " degrees";
    check.severity = Check::Severity::look;
    return check;
}

Check check_of_opening(const Opening& opening, const CriteriaPreset& preset,
                       const std::string& faces) {
    MeasuredValue worst{opening.width, opening.width_bound, preset.gap, opening.place};
    worst.verdict = judge(worst.value, worst.bound, worst.limit);
    Check check = judged("KEIKO-OPENING", "mm", worst, {"the opening between free edges", " mm"});
    check.message += opening.goes_on ? ", more than " : ", some ";
    check.message += short_number(opening.length) + " mm long";
    check.severity = Check::Severity::look;
    check.faces = faces;
    return check;
}

Check check_of_overlap(const Overlap& overlap, const CriteriaPreset& preset,
                       const std::string& faces) {
    struct OverlapWording {
        const char *code, *what;
    };
    static constexpr OverlapWording lap{"KEIKO-OVERLAP", "the overlapping edge"};
    static constexpr OverlapWording tee{"KEIKO-TEE", "the edge that stands on the other face"};
    static constexpr OverlapWording crossing{"KEIKO-CROSSING",
                                             "the edge that passes through the other face"};
    const OverlapWording& of = overlap.kind == Overlap::Kind::lap   ? lap
                               : overlap.kind == Overlap::Kind::tee ? tee
                                                                    : crossing;
    MeasuredValue worst{overlap.length, overlap.length_bound, preset.negligible, overlap.place};
    worst.verdict = judge(worst.value, worst.bound, worst.limit);
    Check check = judged(of.code, "mm", worst, {of.what, " mm"});
    if (overlap.kind != Overlap::Kind::crossing)
        check.message += "; up to " + short_number(overlap.depth) +
                         " mm inside the other's borders, " + short_number(overlap.distance) +
                         " mm from it";
    check.message += ", at " + short_number(overlap.angle) + " degrees to it";
    check.severity = Check::Severity::look;
    check.faces = faces;
    return check;
}

std::string_view outcome_of(const Check& check) {
    return check.is_worth_a_look() ? "look" : name_of(check.worst.verdict);
}

std::vector<Check> checks_of(const MeasuredFace& face, const CriteriaPreset& preset,
                             std::uint32_t index) {
    const SurfaceLimits& limits = preset.surface;
    std::vector<Check> checks;
    if (limits.minimum_radius) checks.push_back(radius_check(face));
    std::vector<Check> flaws =
        limits.waviness.empty() ? looks_of(face) : flaw_checks(face, limits.waviness.front());
    std::move(flaws.begin(), flaws.end(), std::back_inserter(checks));
    for (const SingularPlace& place : face.singular)
        checks.push_back(check_of_singular(place, preset));
    for (Check& check : checks) check.face = index, check.faces = face.name;
    return checks;
}

const Criterion& criterion_of(std::string_view code) {
    const auto found = std::find_if(criteria.begin(), criteria.end(),
                                    [&](const Criterion& c) { return c.code == code; });
    if (found == criteria.end()) throw std::out_of_range("no criterion " + std::string(code));
    return *found;
}

std::vector<Check> checks_of(const MeasuredSeam& seam, const CriteriaPreset& preset, double join,
                             std::uint32_t index) {
    std::vector<Check> checks{gap_check(seam, join), angle_check(seam, preset)};
    if (preset.curvature) checks.push_back(curvature_check(seam));
    if (preset.curvature_slope) checks.push_back(slope_check(seam));
    if (seam.fading) checks.push_back(fading_check(seam));
    for (Check& check : checks) {
        check.seam = index;
        check.faces = seam.faces;
    }
    return checks;
}

} // namespace keiko
