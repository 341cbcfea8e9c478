#pragma once

#include "keiko/report/content/comparison.h"

namespace keiko {

// Tables of comparison_html, each an HTML fragment; empty where there is nothing to tell.

/// What was judged, and how it came out.
std::string html_checks(const Comparison& comparison);
/// How far the bodies are apart, both ways round, by shares of the area.
std::string html_percentiles(const Comparison& comparison);
/// The faces that are farthest off, with the worst place of each.
std::string html_worst_places(const Comparison& comparison);
/// Seams better, worse, gone and new.
std::string html_seam_changes(const Comparison& comparison);
/// Findings new, fixed and the same.
std::string html_finding_changes(const Comparison& comparison);
/// How far the reflection lines of a view have moved.
std::string html_line_shifts(const ComparedView& view, const BodyTolerance& tolerance);

} // namespace keiko
