#pragma once

#include "keiko/report/content/report.h"

#include <cstdint>
#include <string>

namespace keiko {

/// Tone of a seam: its verdict, or "crease" for scraps and passing creases.
std::string seam_tone(const MeasuredSeam& seam);

/// Note on an irregular point: a subdivision surface has no curvature there, so a failed limit says
/// nothing about the cage.
std::string irregular_note(const MeasuredSeam& seam);

/// The profile of a stretch; null if the report has none.
const SeamProfile* profile_of(const Report& report, std::uint32_t seam);

/// The plots of a stretch; empty if the report has no profile of it.
std::string plots_of(const Report& report, std::uint32_t seam);

} // namespace keiko
