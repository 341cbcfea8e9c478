#include "keiko/inspect/check_sentence.h"
#include "keiko/inspect/seams/curvature_match.h"

#include <iterator>

namespace keiko {
namespace {

/// Reason why the angle of a stretch and the quantities derived from it are not judged, or nullptr.
const char* excuse_of(const MeasuredSeam& seam) {
    if (seam.scrap) return "the stretch is shorter than what is negligible";
    if (seam.kind == SeamClass::crease) return "the stretch is a crease";
    if (seam.kind == SeamClass::run_out) return "a crease fades out there";
    return nullptr;
}

Check gap_check(const MeasuredSeam& seam, double join) {
    if (seam.scrap) return unjudged_check("G-SU-LG", excuse_of(seam));
    Check check = judged_check("G-SU-LG", "mm", seam.gap, {"the gap", " mm"});
    if (seam.parted)
        check.message +=
            "; the borders part by more than the join distance of " + short_number(join) + " mm";
    return check;
}

/// Check of a seam whose angle is unknown. Where control points coincide at a border, its normal
/// may exist as a limit, and break.
Check unknown_angle(const MeasuredSeam& seam, const CriteriaPreset& preset) {
    if (seam.verdict == Verdict::pass) return unjudged_check("G-SU-NT", "a side has no normal");
    Check check = named_check("G-SU-NT");
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
    if (const char* excuse = excuse_of(seam)) return unjudged_check("G-SU-NT", excuse);
    if (!seam.angle) return unknown_angle(seam, preset);
    Check check = judged_check("G-SU-NT", "deg", *seam.angle, {"the angle", " degrees"});
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
    if (seam.scrap) return unjudged_check("KEIKO-RUN-OUT", excuse_of(seam));
    return judged_check("KEIKO-RUN-OUT", "deg/mm", *seam.fading,
                        {"the step of the slope at which the crease fades", " degrees/mm"});
}

Check curvature_check(const MeasuredSeam& seam) {
    if (const char* excuse = excuse_of(seam)) return unjudged_check("G-SU-NS", excuse);
    if (!seam.curvature) return unjudged_check("G-SU-NS", "gap and angle do not both pass");
    const CurvatureStep& step = *seam.curvature;
    Check check = judged_check("G-SU-NS", "1", step.worst, {"the curvature mismatch", " %", 100});
    check.formula = formula_text(step.formula);
    return check;
}

Check slope_check(const MeasuredSeam& seam) {
    if (const char* excuse = excuse_of(seam)) return unjudged_check("KEIKO-G3", excuse);
    if (!seam.curvature || seam.curvature->worst.verdict != Verdict::pass)
        return unjudged_check("KEIKO-G3", "gap, angle and curvature do not all pass");
    if (!seam.slope) return unjudged_check("KEIKO-G3", "the seam is nearly flat");
    Check check = judged_check("KEIKO-G3", "deg", seam.slope->worst,
                               {"the change of the curvature's slope", " degrees"});
    check.formula = "|atan2(k1',k1^2)-atan2(k2',k2^2)|";
    return check;
}

constexpr const char* no_curvature =
    "the face lies at an irregular point of a cage, or nothing is left of it";

Check radius_check(const MeasuredFace& face) {
    if (!face.curvature) return unjudged_check("G-SU-CR", no_curvature);
    if (!face.radius) return unjudged_check("G-SU-CR", "the face is flat");
    return judged_check("G-SU-CR", "mm", *face.radius, {"the smallest radius", " mm"});
}

Check draft_check(const MeasuredFace& face) {
    if (!face.draft) return unjudged_check("KEIKO-DRAFT", "nothing is left of the face");
    Check check =
        judged_check("KEIKO-DRAFT", "deg", *face.draft, {"the smallest draft", " degrees"});
    if (face.draft->verdict == Verdict::fail && face.draft->value < 0)
        check.message += "; the face is undercut there";
    return check;
}

/// A radius that no preset judges is worth a look where a bend is narrower than what counts.
Check narrow_radius_check(const MeasuredFace& face, double negligible) {
    MeasuredValue worst = *face.radius;
    worst.limit = negligible, worst.verdict = Verdict::fail;
    Check check = judged_check("G-SU-CR", "mm", worst, {"the smallest radius", " mm"});
    check.severity = Check::Severity::look;
    return check;
}

Check unsearched_check(const Flaw& flaw) {
    Check check =
        judged_check("G-SU-WV", "mm", flaw.depth, {"the depth of dents and waves", " mm"});
    const char* why = flaw.kind == Flaw::Kind::rough
                          ? " mm in size, approximates one of the file too roughly"
                          : " mm in size, is too large, or its control points too far apart,";
    check.message = "the face, some " + short_number(flaw.width) + why +
                    " to be searched for dents and waves in a window of " +
                    short_number(flaw.window) + " mm";
    return check;
}

Check flaw_check(const Flaw& flaw) {
    if (!flaw.is_searched()) return unsearched_check(flaw);
    Check check = flaw.kind == Flaw::Kind::waves
                      ? judged_check("G-SU-WV", "mm", flaw.depth, {"the depth of the waves", " mm"})
                  : flaw.kind == Flaw::Kind::dent
                      ? judged_check("KEIKO-DENT", "mm", flaw.depth, {"the dent", " mm"})
                      : judged_check("KEIKO-DENT", "mm", flaw.depth, {"the bump", " mm"});
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
    if (!face.curvature) return {unjudged_check("G-SU-WV", no_curvature)};
    std::vector<Check> checks;
    for (const Flaw& flaw : face.flaws) checks.push_back(flaw_check(flaw));
    if (!checks.empty()) return checks;
    MeasuredValue none;
    none.limit = limit.depth, none.place = face.curvature->largest.place;
    const char* what = limit.waves_only ? "the depth of waves" : "the depth of dents and waves";
    checks.push_back(judged_check("G-SU-WV", "mm", none, {what, " mm"}));
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
    Check check =
        place.kind == Kind::fold
            ? judged_check("G-SU-FO", "deg", worst, {"the turn of the normal", " degrees"})
            : judged_check("KEIKO-SINGULAR", "deg", worst,
                           {"the angle between normals about one place", " degrees"});
    if (place.kind == Kind::unresolved) check.message = "the face is not shown to be regular";
    if (place.kind == Kind::uneven)
        check.message =
            "the weights of a patch differ by more than a factor of 10000: its seams may "
            "be measured in part";
    if (place.kind == Kind::uneven_border)
        check.message =
            "the weights of a border curve differ by more than a factor of 1000000: "
            "its seams may not be found or be measured in part";
    check.message += place.kind == Kind::fold ? "; the face folds back on itself" : "";
    if (place.extent > 1e-3) check.message += ", within some " + short_number(place.extent) + " mm";
    if (place.kind == Kind::no_limit) check.severity = Check::Severity::look;
    return check;
}

} // namespace

std::string_view outcome_of(const Check& check) {
    if (check.is_accepted()) return "accepted";
    return check.is_worth_a_look() ? "look" : name_of(check.worst.verdict);
}

std::vector<Check> checks_of(const MeasuredFace& face, const CriteriaPreset& preset,
                             std::uint32_t index) {
    const SurfaceLimits& limits = preset.surface;
    std::vector<Check> checks;
    if (limits.minimum_radius)
        checks.push_back(radius_check(face));
    else if (face.radius && face.radius->value < preset.negligible)
        checks.push_back(narrow_radius_check(face, preset.negligible));
    if (limits.draft) checks.push_back(draft_check(face));
    std::vector<Check> flaws =
        limits.waviness.empty() ? looks_of(face) : flaw_checks(face, limits.waviness.front());
    std::move(flaws.begin(), flaws.end(), std::back_inserter(checks));
    for (const SingularPlace& place : face.singular)
        checks.push_back(check_of_singular(place, preset));
    for (Check& check : checks) check.face = index, check.faces = face.name;
    return checks;
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
