#include "keiko/inspect/seams/seam_line.h"

#include "keiko/inspect/basics/approximation_error.h"
#include "keiko/inspect/seams/curvature_match.h"
#include "keiko/inspect/seams/seam_quantities.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// mm: CAD systems themselves join at 1e-7 to 1e-5; a gap below has no direction.
constexpr double same_place = 1e-6;
/// Share of 1; error of a mismatch of two evaluated curvatures.
constexpr double mismatch_rounding = 1e-9;

/// The parts of a line's pieces that make up a stretch, as probes of their own.
std::vector<SeamProbe> probes_of(const SeamLine& line, const SeamStretch& stretch) {
    std::vector<SeamProbe> probes;
    for (const SeamPart& part : stretch.parts)
        probes.push_back(line.probes[part.piece].part(part.begin, part.end));
    return probes;
}

StretchExtremes extremes_of(const std::vector<SeamProbe>& probes, const CriteriaPreset& preset) {
    StretchExtremes all;
    for (const SeamProbe& probe : probes) all = larger_of(all, extremes_along(probe, preset));
    return all;
}

MeasuredValue worst(const SeamExtreme& extreme, double rounding, double limit) {
    return {extreme.value, extreme.bound + rounding, limit, extreme.point.place,
            judge_maximum(extreme.value, extreme.bound, rounding, limit)};
}

CurvatureStep curvature_step(const SeamExtreme& extreme, const CriteriaPreset& preset,
                             const ApproximationError& off) {
    const SeamQuantities quantities(preset);
    const SeamPoint& p = extreme.point;
    const auto [formula, limit] = quantities.curvature_limit();
    CurvatureStep step{.curvature_a = p.curvature_a,
                       .curvature_b = p.curvature_b,
                       .formula = formula,
                       .mismatch = extreme.value,
                       .alias = quantities.mismatch(CurvatureFormula::alias, p),
                       .catia = quantities.mismatch(CurvatureFormula::catia, p),
                       .flat = quantities.is_floored(p),
                       .worst = {extreme.value, extreme.bound, limit, p.place, Verdict::pass}};
    const double error = curvature_mismatch_error(formula, p.curvature_a, p.curvature_b,
                                                  preset.flat_radius, off.curvature);
    step.worst.bound += error;
    if (preset.curvature)
        step.worst.verdict =
            judge_maximum(extreme.value, extreme.bound, mismatch_rounding + error, limit);
    return step;
}

CurvatureSlopeStep slope_step(const SeamExtreme& extreme, const CriteriaPreset& preset,
                              const ApproximationError& off) {
    const SeamPoint& p = extreme.point;
    CurvatureSlopeStep step{.slope_a = p.slope_a,
                            .slope_b = p.slope_b,
                            .change = std::abs(p.slope_a - p.slope_b),
                            .worst = {}};
    const double limit = preset.curvature_slope.value_or(unjudged_slope);
    const double error =
        slope_angle_error(p.curvature_a, p.curvature_b, off.curvature, off.curvature_slope);
    step.worst = {extreme.value, extreme.bound + error, limit, p.place, Verdict::pass};
    if (preset.curvature_slope)
        step.worst.verdict = judge_maximum(extreme.value, extreme.bound, error, limit);
    return step;
}

void take(MeasuredSeam& seam, const MeasuredValue& worst) {
    seam.verdict = std::max(seam.verdict, worst.verdict);
    seam.severity = std::max(seam.severity, share_of_limit(worst));
}

void judge_smooth(MeasuredSeam& seam, const StretchExtremes& found, const CriteriaPreset& preset,
                  const ApproximationError& off) {
    take(seam, *seam.angle);
    if (seam.verdict != Verdict::pass || !found.curvature) return;
    seam.curvature = curvature_step(*found.curvature, preset, off);
    if (preset.curvature) take(seam, seam.curvature->worst);
    if (seam.verdict != Verdict::pass || !found.slope) return;
    seam.slope = slope_step(*found.slope, preset, off);
    if (preset.curvature_slope) take(seam, seam.slope->worst);
}

/// A point halfway along; for an even number of parts, the beginning of the later half.
Vec3 middle_of(const std::vector<SeamProbe>& probes) {
    const SeamProbe& probe = probes[probes.size() / 2];
    return probes.size() % 2 == 0 ? probe.at(probe.begin()).place : probe.middle();
}

std::vector<Vec3> course_of(const SeamProbe& probe) {
    constexpr int steps = 32;
    std::vector<Vec3> course;
    for (int i = 0; i <= steps; ++i)
        course.push_back(probe.place(probe.begin() + (probe.end() - probe.begin()) * i / steps));
    return course;
}

/// Measured seam with its faces and its position only.
MeasuredSeam located(const SurfaceModel& model, const SeamLine& line, const SeamStretch& stretch,
                     const std::vector<SeamProbe>& probes) {
    MeasuredSeam seam;
    seam.instance_a = line.instance_a, seam.face_a = line.face_a;
    seam.instance_b = line.instance_b, seam.face_b = line.face_b;
    seam.id_a = model.faces[line.face_a].id, seam.id_b = model.faces[line.face_b].id;
    seam.kind = stretch.kind, seam.length = stretch.length;
    seam.middle = middle_of(probes);
    for (const SeamProbe& probe : probes) seam.course.push_back(course_of(probe));
    return seam;
}

void judge_gap(MeasuredSeam& seam, const SeamExtreme& gap, double error, double limit) {
    seam.gap = worst(gap, error, limit);
    seam.overlap = gap.point.overlap && seam.gap.value > same_place;
    seam.stacked =
        seam.kind == SeamClass::fold && gap.point.stacked && seam.gap.verdict == Verdict::fail;
    take(seam, seam.gap);
}

/// Judges the angle and the quantities derived from it by the rules of the class.
void judge_angle(MeasuredSeam& seam, const StretchExtremes& found, const SeamStretch& stretch,
                 const CriteriaPreset& preset, const ApproximationError& off) {
    seam.angle = worst(*found.angle, angle_rounding + off.angle, preset.angle);
    seam.smallest_angle = -found.negated_angle->value;
    if (stretch.unknown) {
        seam.angle->verdict = std::max(seam.angle->verdict, Verdict::undecided);
        take(seam, *seam.angle);
    }
    if (stretch.kind == SeamClass::smooth) judge_smooth(seam, found, preset, off);
    if (stretch.kind == SeamClass::fold) take(seam, *seam.angle);
    seam.fading = stretch.fading;
    if (seam.fading) take(seam, *seam.fading);
}

/// The error of the differences between both sides.
ApproximationError error_of(const SurfaceModel& model, const SeamLine& line) {
    return approximation_error(model, line.face_a, scale_of(model.instances[line.instance_a])) +
           approximation_error(model, line.face_b, scale_of(model.instances[line.instance_b]));
}

MeasuredSeam measure_stretch(const SurfaceModel& model, const SeamLine& line,
                             const SeamStretch& stretch, const CriteriaPreset& preset) {
    const std::vector<SeamProbe> probes = probes_of(line, stretch);
    const StretchExtremes found = extremes_of(probes, preset);
    MeasuredSeam seam = located(model, line, stretch, probes);
    if (!found.gap) {
        seam.verdict = Verdict::undecided;
        return seam;
    }
    judge_gap(seam, *found.gap,
              position_error(model, line.face_a, line.face_b, found.gap->point.place), preset.gap);
    if (found.angle)
        judge_angle(seam, found, stretch, preset, error_of(model, line));
    else if (stretch.length > same_place)
        seam.verdict = std::max(seam.verdict, Verdict::undecided);
    return seam;
}

} // namespace

StretchLimits stretch_limits(double size_a, double size_b, const CriteriaPreset& preset,
                             double join) {
    constexpr double share_of_face = 0.01;
    // The rest beside a run-out is judged as smooth: there no bound may straddle the limit.
    constexpr double faded = 0.99;
    return {.feature_angle = preset.feature_angle,
            .negligible =
                std::max(class_change_bound,
                         std::min(preset.negligible, share_of_face * std::min(size_a, size_b))),
            .join = join,
            .angle = faded * preset.angle,
            .fading = preset.fading,
            .longest_run_out = preset.longest_run_out};
}

std::vector<MeasuredStretch> measure_line(const SurfaceModel& model, const SeamLine& line,
                                          const CriteriaPreset& preset, const StretchLimits& limits,
                                          const PiecesBeyond& beyond) {
    std::vector<MeasuredStretch> measured;
    for (SeamStretch& stretch : seam_stretches(line.probes, limits, beyond)) {
        MeasuredSeam seam = measure_stretch(model, line, stretch, preset);
        seam.scrap = stretch.scrap, seam.negligible = limits.negligible;
        seam.parted = limits.join > 0 && seam.gap.value > limits.join;
        measured.push_back({std::move(seam), std::move(stretch.parts)});
    }
    return measured;
}

} // namespace keiko
