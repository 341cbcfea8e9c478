#pragma once

#include "keiko/inspect/seams/seam_extremes.h"
#include "keiko/scene/criteria_preset.h"

#include <optional>
#include <vector>

namespace keiko {

/// Degrees: limit of G3 to whose accuracy it is measured if a preset does not judge it.
constexpr double unjudged_slope = 0.1;

/// The quantities of a place of a seam that presets judge, by the formulas of one preset.
class SeamQuantities {
public:
    /// Copies the preset's limit of the curvatures and its flat radius.
    explicit SeamQuantities(const CriteriaPreset& preset)
        : limit_(preset.curvature.value_or(CurvatureLimit{})), flat_radius_(preset.flat_radius) {}

    /// Limit and formula of the mismatch: the default ones if the preset does not judge it.
    const CurvatureLimit& curvature_limit() const { return limit_; }
    /// G2, share of 1, by either formula. It has no meaning without an angle.
    double mismatch(CurvatureFormula formula, const SeamPoint& point) const;
    /// G2, share of 1, by the preset's formula; nullopt if a side has no normal.
    std::optional<double> mismatch(const SeamPoint& point) const;
    /// G3, degrees (slope_angle); nullopt if a side has no normal or both are nearly flat.
    std::optional<double> slope(const SeamPoint& point) const;
    /// True if the flat radius replaces the curvatures to which the change is compared.
    bool is_floored(const SeamPoint& point) const;

private:
    CurvatureLimit limit_;
    double flat_radius_;
};

/// The extremes of a stretch, or of a part of it; nullopt where a quantity has no value anywhere.
struct StretchExtremes {
    std::optional<SeamExtreme> gap;           ///< mm
    std::optional<SeamExtreme> angle;         ///< degrees
    std::optional<SeamExtreme> negated_angle; ///< degrees, minus the smallest angle
    std::optional<SeamExtreme> curvature;     ///< G2, share of 1
    std::optional<SeamExtreme> slope;         ///< G3, degrees
};

/// The extremes along one piece of a seam, as accurate as the limits of the preset require.
StretchExtremes extremes_along(const SeamProbe& probe, const CriteriaPreset& preset);

/// mm: error of an evaluated gap at a place, with what the faces of the seam differ from the
/// file's.
double position_error(const SurfaceModel& model, std::uint32_t face_a, std::uint32_t face_b,
                      const Vec3& place);

/// The larger of both in each quantity. The bounds cover what either could hide.
StretchExtremes larger_of(const StretchExtremes& a, const StretchExtremes& b);

} // namespace keiko
