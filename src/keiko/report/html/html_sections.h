#pragma once

#include "keiko/report/content/report.h"

#include <string>

namespace keiko {

// The parts of report.html in the order of the page, each an HTML fragment; empty if there is
// nothing to report.

/// The inspected model, the verdict and the counts.
std::string html_verdict(const Report& report);
/// The stripe pictures with the places of the worst seams.
std::string html_pictures(const Report& report);
/// One of its pictures with its markers.
std::string html_figure(const ReportPicture& picture);
/// Curvature and zebra pictures.
std::string html_form(const Report& report);
/// Sections and iso-curves with their combs.
std::string html_combs(const Report& report);
/// The picture of the close-up of a finding.
std::string html_close_up(const Report& report, CloseUp::Of of, std::size_t index);
/// The attributes by which a table's row opens the close-up of its finding.
std::string html_opens_close_up(const Report& report, CloseUp::Of of, std::size_t index);
/// The close-ups that no other part shows, for rows to open, and the window in which they open.
std::string html_gallery(const Report& report);
/// The reflection lines in pictures, and their crossings with seams.
std::string html_lines(const Report& report);
/// The worst seams, each with its measures against their limits.
std::string html_worst_seams(const Report& report);
/// Findings that deserve a look without being judged.
std::string html_looks(const Report& report);
/// Share of the surface that the lamps reach.
std::string html_coverage(const Report& report);
/// Every seam in a table.
std::string html_all_seams(const Report& report);
/// Every face by itself in a table.
std::string html_faces(const Report& report);
/// The file, its losses and its repairs.
std::string html_facts(const Report& report);

} // namespace keiko
