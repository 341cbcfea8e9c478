#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/judged_scope.h"
#include "keiko/scene/criteria_preset.h"

#include <optional>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

// Words on the part of a body that is judged, which every format states beside the verdict, so that
// a pass never hides the rest.

/// "12 of 52 faces judged (layers SKIN)"; empty if all faces are.
std::string scope_words(const std::optional<JudgedScope>& scope);

/// Sentences on the part of the body that is judged and on each zone: its faces, the limits by
/// which it lets more pass than the preset, and what passes by these alone. Empty without both.
std::vector<std::string> scope_sentences(const std::optional<JudgedScope>& scope,
                                         const CriteriaPreset& preset);

/// True if faces are judged by themselves, in any zone or by the preset itself.
bool judges_faces(const CriteriaPreset& preset);
/// True if dents and waves are searched, in any zone or by the preset itself.
bool searches_flaws(const CriteriaPreset& preset);
/// True if the slope of the curvature is judged, in any zone or by the preset itself.
bool judges_slopes(const CriteriaPreset& preset);

/// The heading of a column of values: with their limit, such as "gap mm ≤ 0.01", unless zones have
/// others.
std::string with_limit(const std::string& name, const std::string& limit,
                       const CriteriaPreset& preset);

} // namespace keiko
