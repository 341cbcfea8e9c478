#pragma once

#include "keiko/keiko.h"

namespace keiko {

/// The rig that the options name, or else the scene's own. Throws Error without either.
LightRig rig_for_lines(const Scene& scene, const LinesOptions& options);

/// Whether a rig has lamps whose lines can be followed.
bool has_lines(const LightRig& rig);

/// As find_lines, of a rig that has lines and in views that are chosen already.
LineList lines_under(const Scene& scene, const LightRig& rig, std::span<const NamedView> views,
                     const LinesOptions& options, const Job& job);

} // namespace keiko
