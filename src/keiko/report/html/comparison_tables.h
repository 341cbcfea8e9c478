#pragma once

#include "keiko/report/content/comparison.h"

namespace keiko {

// Tables of comparison_html, each an HTML fragment; empty if there is nothing to report.

/// Criteria that were judged, and their outcomes.
std::string html_checks(const Comparison& comparison);
/// Deviations of the bodies, in both directions, by shares of the area.
std::string html_percentiles(const Comparison& comparison);
/// The faces with the largest deviations, with the worst place of each.
std::string html_worst_places(const Comparison& comparison);
/// Seams better, worse, gone and new.
std::string html_seam_changes(const Comparison& comparison);
/// Findings new, fixed and the same.
std::string html_finding_changes(const Comparison& comparison);
/// Movement of the reflection lines of a view.
std::string html_line_shifts(const ComparedView& view, const BodyTolerance& tolerance);

} // namespace keiko
