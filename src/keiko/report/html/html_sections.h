#pragma once

#include "keiko/report/content/report.h"

#include <string>

namespace keiko {

// The parts of report.html in the order of the page, each an HTML fragment; empty where there is
// nothing to tell.

/// What was inspected, the verdict and the counts.
std::string html_verdict(const Report& report);
/// The stripe pictures with the places of the worst seams.
std::string html_pictures(const Report& report);
/// One of its pictures with its markers.
std::string html_figure(const ReportPicture& picture);
/// Curvature and zebra pictures.
std::string html_form(const Report& report);
/// Sections and iso-curves with their combs.
std::string html_combs(const Report& report);
/// The picture of a close-up, and where there is one what makes a table's row open it.
std::string html_close_up(const Report& report, CloseUp::Of of, std::size_t index);
std::string html_opens_close_up(const Report& report, CloseUp::Of of, std::size_t index);
/// The close-ups that no other part shows, for rows to open, and the window that they open in.
std::string html_gallery(const Report& report);
/// The reflection lines in pictures, and what they do where they cross seams.
std::string html_lines(const Report& report);
/// The worst seams, each with its measures against their limits.
std::string html_worst_seams(const Report& report);
/// What is worth a look though nothing judges it.
std::string html_looks(const Report& report);
/// How much of the surface the lamps reach.
std::string html_coverage(const Report& report);
/// Every seam in a table.
std::string html_all_seams(const Report& report);
/// Every face by itself in a table.
std::string html_faces(const Report& report);
/// The file, what was lost of it and what was repaired.
std::string html_facts(const Report& report);

} // namespace keiko
