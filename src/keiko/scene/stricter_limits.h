#pragma once

#include "keiko/scene/criteria_preset.h"

#include <string>
#include <vector>

namespace keiko {

/// Limits of a seam between faces of two zones of a preset, or of that preset itself: the stricter
/// limit of each criterion of seams and of lines. What one of them judges is judged. Curvatures
/// that they limit by different formulas are held to a limit by `catia` under which nothing passes
/// that either of them fails. Everything else is that of `a`.
CriteriaPreset stricter_limits(const CriteriaPreset& a, const CriteriaPreset& b);

/// Limits of a zone that let more pass than those of its preset, in words: "gap 0.05 mm instead of
/// 0.01 mm". Empty if none does.
std::vector<std::string> looser_limits(const CriteriaPreset& zone, const CriteriaPreset& preset);

} // namespace keiko
