#include "keiko/inspect/seams/seam_quantities.h"

#include "keiko/inspect/seams/curvature_match.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keiko {
namespace {

/// Accuracy of extremes as a share of their limit: finer than any verdict depends on.
constexpr double relative_tolerance = 1e-4;
/// Error of an evaluated point, as a share of its distance from the origin: some tens of
/// roundings of the Bernstein sums.
constexpr double relative_rounding = 1e-14;

/// The larger of two extremes of one quantity; the bound must cover what either could hide.
std::optional<SeamExtreme> larger(const std::optional<SeamExtreme>& a,
                                  const std::optional<SeamExtreme>& b) {
    if (!a || !b) return a ? a : b;
    const double upper = std::max(a->value + a->bound, b->value + b->bound);
    SeamExtreme kept = b->value > a->value ? *b : *a;
    kept.bound = upper - kept.value;
    return kept;
}

std::optional<double> negated(const std::optional<double>& value) {
    if (!value) return std::nullopt;
    return -*value;
}

/// Questions about gap and angle.
std::vector<SeamQuestion> questions_of_form(const CriteriaPreset& preset) {
    return {{[](const SeamPoint& p) { return p.gap; }, relative_tolerance * preset.gap},
            {[](const SeamPoint& p) { return p.angle; }, relative_tolerance * preset.angle},
            {[](const SeamPoint& p) { return negated(p.angle); }, preset.angle}};
}

/// Questions about curvatures and their slopes.
std::vector<SeamQuestion> questions_of_bend(const CriteriaPreset& preset,
                                            const SeamQuantities& quantities) {
    return {{[&](const SeamPoint& p) { return quantities.mismatch(p); },
             relative_tolerance * 10 * quantities.curvature_limit().limit},
            {[&](const SeamPoint& p) { return quantities.slope(p); },
             relative_tolerance * 10 * preset.curvature_slope.value_or(unjudged_slope)}};
}

} // namespace

double SeamQuantities::mismatch(CurvatureFormula formula, const SeamPoint& point) const {
    return curvature_mismatch(formula, point.curvature_a, point.curvature_b, flat_radius_);
}

std::optional<double> SeamQuantities::mismatch(const SeamPoint& point) const {
    if (!point.angle) return std::nullopt;
    return mismatch(limit_.formula, point);
}

std::optional<double> SeamQuantities::slope(const SeamPoint& point) const {
    const double most = std::max(std::abs(point.curvature_a), std::abs(point.curvature_b));
    if (!point.angle || most * flat_radius_ < 1) return std::nullopt;
    return slope_angle(point.curvature_a, point.slope_a, point.curvature_b, point.slope_b);
}

bool SeamQuantities::is_floored(const SeamPoint& point) const {
    return mismatch(limit_.formula, point) <
           curvature_mismatch(limit_.formula, point.curvature_a, point.curvature_b, HUGE_VAL);
}

StretchExtremes extremes_along(const SeamProbe& probe, const CriteriaPreset& preset) {
    constexpr double longest = 0.01; // of the length
    const SeamQuantities quantities(preset);
    std::vector<SeamQuestion> form = questions_of_form(preset);
    const std::vector<SeamQuestion> bend = questions_of_bend(preset, quantities);
    const std::optional<SeamProbe> off_poles =
        probe.away_from_poles(std::min(preset.negligible, longest * probe.length()));
    if (!off_poles) form.insert(form.end(), bend.begin(), bend.end());
    auto found = seam_extremes(probe, form);
    if (off_poles)
        for (auto& extreme : seam_extremes(*off_poles, bend)) found.push_back(std::move(extreme));
    return {found[0], found[1], found[2], found[3], found[4]};
}

double position_error(const SurfaceModel& model, std::uint32_t face_a, std::uint32_t face_b,
                      const Vec3& place) {
    return relative_rounding * place.length() + model.faces[face_a].approximated +
           model.faces[face_b].approximated;
}

StretchExtremes larger_of(const StretchExtremes& a, const StretchExtremes& b) {
    return {larger(a.gap, b.gap), larger(a.angle, b.angle),
            larger(a.negated_angle, b.negated_angle), larger(a.curvature, b.curvature),
            larger(a.slope, b.slope)};
}

} // namespace keiko
