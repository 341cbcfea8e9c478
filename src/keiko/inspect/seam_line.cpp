#include "keiko/inspect/seam_line.h"

#include "keiko/inspect/curvature_match.h"
#include "keiko/inspect/seam_extremes.h"
#include "keiko/inspect/slope_match.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Extremes are wanted to this share of their limit: less than any verdict turns on.
constexpr double relative_tolerance = 1e-4;
/// Error of an evaluated point, as a share of its distance from the origin: some tens of
/// roundings of the Bernstein sums.
constexpr double relative_rounding = 1e-14;
/// mm: CAD systems themselves join at 1e-7 to 1e-5; a gap below has no direction.
constexpr double same_place = 1e-6;
/// degrees; error of an angle between two evaluated normals.
constexpr double angle_rounding = 1e-10;

/// The share of its limit that a curvature step uses up.
struct CurvatureJudge {
    CurvatureLimit limit;
    double flat_radius, flat_change;

    explicit CurvatureJudge(const CriteriaPreset& preset)
        : limit(preset.curvature.value_or(CurvatureLimit{})),
          flat_radius(preset.flat_radius),
          flat_change(preset.flat_curvature_change) {}

    bool flat(const SeamPoint& p) const {
        return std::max(std::abs(p.curvature_a), std::abs(p.curvature_b)) * flat_radius < 1;
    }
    double value(const SeamPoint& p) const {
        return flat(p) ? std::abs(p.curvature_a - p.curvature_b)
                       : curvature_mismatch(limit.formula, p.curvature_a, p.curvature_b);
    }
    double allowed(const SeamPoint& p) const { return flat(p) ? flat_change : limit.limit; }
};

/// The larger of two extremes of one quantity; the bound must cover what either could hide.
void keep_worse(std::optional<SeamExtreme>& kept, const std::optional<SeamExtreme>& other) {
    if (!other) return;
    if (!kept) {
        kept = other;
        return;
    }
    const double upper = std::max(kept->value + kept->bound, other->value + other->bound);
    if (other->value > kept->value) kept = other;
    kept->bound = upper - kept->value;
}

/// Where a preset does not judge G3 it is still measured, to this share of a degree.
constexpr double unjudged_slope = 0.1;

struct LineExtremes {
    std::optional<SeamExtreme> gap, angle, negated_angle, curvature, slope;
    double length = 0;
};

std::vector<SeamQuestion> questions_of(const CriteriaPreset& preset,
                                       const CurvatureJudge& curvature) {
    return {{[](const SeamPoint& p) { return p.gap; }, relative_tolerance * preset.gap},
            {[](const SeamPoint& p) { return p.angle; }, relative_tolerance * preset.angle},
            {[](const SeamPoint& p) -> std::optional<double> {
                 if (!p.angle) return std::nullopt;
                 return -*p.angle;
             },
             preset.angle},
            {[&](const SeamPoint& p) -> std::optional<double> {
                 if (!p.angle) return std::nullopt;
                 return curvature.value(p) / curvature.allowed(p);
             },
             relative_tolerance * 10},
            {[&](const SeamPoint& p) -> std::optional<double> {
                 if (!p.angle || curvature.flat(p)) return std::nullopt;
                 return slope_angle(p.curvature_a, p.slope_a, p.curvature_b, p.slope_b);
             },
             relative_tolerance * 10 * preset.curvature_slope.value_or(unjudged_slope)}};
}

LineExtremes extremes_of(const SeamLine& line, const CriteriaPreset& preset) {
    const CurvatureJudge curvature(preset);
    const std::vector<SeamQuestion> questions = questions_of(preset, curvature);
    LineExtremes all;
    const int least_cells = std::max(2, 8 / static_cast<int>(line.probes.size()));
    for (const SeamProbe& probe : line.probes) {
        const int cells = std::clamp(2 * probe.patch_count(), least_cells, 64);
        const auto found = seam_extremes(probe, questions, cells);
        keep_worse(all.gap, found[0]);
        keep_worse(all.angle, found[1]);
        keep_worse(all.negated_angle, found[2]);
        keep_worse(all.curvature, found[3]);
        keep_worse(all.slope, found[4]);
        all.length += probe.length();
    }
    return all;
}

Worst worst(const SeamExtreme& extreme, double rounding, double limit) {
    const double bound = extreme.bound + rounding;
    return {extreme.value, bound, limit, extreme.point.place, judge(extreme.value, bound, limit)};
}

CurvatureStep curvature_step(const SeamExtreme& extreme, const CriteriaPreset& preset) {
    const CurvatureJudge curvature(preset);
    const SeamPoint& p = extreme.point;
    CurvatureStep step{
        .curvature_a = p.curvature_a,
        .curvature_b = p.curvature_b,
        .formula = curvature.limit.formula,
        .mismatch = curvature_mismatch(curvature.limit.formula, p.curvature_a, p.curvature_b),
        .alias = curvature_mismatch(CurvatureFormula::alias, p.curvature_a, p.curvature_b),
        .catia = curvature_mismatch(CurvatureFormula::catia, p.curvature_a, p.curvature_b),
        .flat = curvature.flat(p),
        .worst = {}};
    const double allowed = curvature.allowed(p);
    step.worst = {curvature.value(p), extreme.bound * allowed, allowed, p.place, Verdict::pass};
    if (preset.curvature) step.worst.verdict = judge(step.worst.value, step.worst.bound, allowed);
    return step;
}

CurvatureSlopeStep slope_step(const SeamExtreme& extreme, const CriteriaPreset& preset) {
    const SeamPoint& p = extreme.point;
    CurvatureSlopeStep step{.slope_a = p.slope_a,
                            .slope_b = p.slope_b,
                            .change = std::abs(p.slope_a - p.slope_b),
                            .worst = {}};
    const double limit = preset.curvature_slope.value_or(unjudged_slope);
    step.worst = {extreme.value, extreme.bound, limit, p.place, Verdict::pass};
    if (preset.curvature_slope) step.worst.verdict = judge(extreme.value, extreme.bound, limit);
    return step;
}

void take(MeasuredSeam& seam, const Worst& worst) {
    seam.verdict = std::max(seam.verdict, worst.verdict);
    seam.severity = std::max(seam.severity, share_of_limit(worst));
}

double position_error(const SurfaceModel& model, const SeamLine& line, const Vec3& place) {
    return relative_rounding * place.length() + model.faces[line.face_a].approximated +
           model.faces[line.face_b].approximated;
}

void judge_beyond_gap(MeasuredSeam& seam, const LineExtremes& found, const CriteriaPreset& preset) {
    seam.angle = worst(*found.angle, angle_rounding, preset.angle);
    seam.smallest_angle = -found.negated_angle->value;
    // Faces that lie on each other all along are folded back on the same material: no edge. Trims
    // may have hooks of a few um.
    constexpr double folded = 179, hook = 1; // degrees, mm
    const bool doubled = seam.smallest_angle > folded && seam.length > hook;
    seam.crease = seam.angle->value > preset.feature_angle && !doubled;
    if (seam.crease) return;
    take(seam, *seam.angle);
    if (seam.verdict != Verdict::pass || !found.curvature) return;
    seam.curvature = curvature_step(*found.curvature, preset);
    if (preset.curvature) take(seam, seam.curvature->worst);
    if (seam.verdict != Verdict::pass || !found.slope) return;
    seam.slope = slope_step(*found.slope, preset);
    if (preset.curvature_slope) take(seam, seam.slope->worst);
}

/// Of an even number of pieces the middle is where the later half begins.
Vec3 middle_of(const SeamLine& line) {
    const SeamProbe& probe = line.probes[line.probes.size() / 2];
    return line.probes.size() % 2 == 0 ? probe.at(probe.begin()).place : probe.middle();
}

std::vector<Vec3> course_of(const SeamProbe& probe) {
    constexpr int steps = 32;
    std::vector<Vec3> course;
    for (int i = 0; i <= steps; ++i)
        course.push_back(probe.place(probe.begin() + (probe.end() - probe.begin()) * i / steps));
    return course;
}

} // namespace

MeasuredSeam measure_line(const SurfaceModel& model, const SeamLine& line,
                          const CriteriaPreset& preset) {
    const LineExtremes found = extremes_of(line, preset);
    MeasuredSeam seam;
    seam.instance_a = line.instance_a, seam.face_a = line.face_a;
    seam.instance_b = line.instance_b, seam.face_b = line.face_b;
    seam.id_a = model.faces[line.face_a].id, seam.id_b = model.faces[line.face_b].id;
    seam.middle = middle_of(line);
    for (const SeamProbe& probe : line.probes) seam.course.push_back(course_of(probe));
    seam.length = found.length;
    const SeamPoint& widest = found.gap->point;
    seam.gap = worst(*found.gap, position_error(model, line, widest.place), preset.gap);
    seam.overlap = widest.overlap && seam.gap.value > same_place;
    take(seam, seam.gap);
    if (found.angle) judge_beyond_gap(seam, found, preset);
    return seam;
}

} // namespace keiko
