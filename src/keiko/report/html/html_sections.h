#pragma once

#include "keiko/report/content/comparison.h"
#include "keiko/report/content/report.h"

#include <span>
#include <string>
#include <string_view>

namespace keiko {

// The parts of the HTML pages, each a fragment; empty if there is nothing to report. First those
// of report.html, in the order of the page.

/// A section with its heading; empty without content.
std::string html_section(const std::string& title, const std::string& content);

/// The inspected model, the verdict and the counts.
std::string html_verdict(const Report& report);
/// The part of the body that was judged, and the zones; empty if all is judged by the preset
/// itself.
std::string html_scope(const Report& report);
/// The line drawing, and the stripe pictures with the places of the worst seams.
std::string html_pictures(const Report& report);
/// Style of html_drawing, for the page's style sheet.
extern const std::string_view drawing_style;
/// The line drawing, whose marks lead to rows of html_findings, or why there is none.
std::string html_drawing(const Report& report);
/// A picture with its markers.
std::string html_figure(const ReportPicture& picture);
/// Pictures in a row; empty without any.
std::string html_figures(std::span<const ReportPicture> pictures);
/// Curvature and zebra pictures.
std::string html_form(const Report& report);
/// Sections and iso-curves with their combs.
std::string html_combs(const Report& report);
/// The picture of the close-up of a finding, of several of its face the one nearest to `place`.
std::string html_close_up(const Report& report, CloseUp::Of of, std::size_t index,
                          const Vec3& place);
/// The attributes by which a table's row opens the close-up of its finding.
std::string html_opens_close_up(const Report& report, CloseUp::Of of, std::size_t index);
/// The close-ups that no other part shows, for rows to open, and the window in which they open.
std::string html_gallery(const Report& report);
/// The reflection lines in pictures, and their crossings with seams.
std::string html_lines(const Report& report);
/// The faults to mend first, or else the worst seams, each with its measures against their limits.
std::string html_first_screen(const Report& report);
/// The faults that the first screen leaves out, in a table; empty without any.
std::string html_more_faults(const Report& report);
/// A stretch of a seam with its measures against their limits; `heading`, before its name, and
/// `note`: fragments on its fault.
std::string html_seam_card(const Report& report, std::size_t rank, const ShownItem& item,
                           const std::string& heading, const std::string& note);
/// Faults that no standing view shows.
std::string html_hidden(const Report& report);
/// The notes of the analysis, each with its place.
std::string html_notes(const Report& report);
/// The profiles of failing and undecided stretches that the first screen does not show.
std::string html_more_profiles(const Report& report);
/// Findings of seams, faces and lines, by the numbers of report.json.
std::string html_findings(const Report& report);
/// Findings that are accepted, and acceptances that cover nothing.
std::string html_accepted(const Report& report);
/// Findings that deserve a look without being judged.
std::string html_looks(const Report& report);
/// Share of the surface that the lamps reach.
std::string html_coverage(const Report& report);
/// Every stretch of a seam in a table, except the scraps.
std::string html_all_seams(const Report& report);
/// The scraps in a table of their own; empty without any.
std::string html_scraps(const Report& report);
/// The joints between panels, where they were sought.
std::string html_joints(const Report& report);
/// Every face by itself in a table.
std::string html_faces(const Report& report);
/// The file, its losses and its repairs.
std::string html_facts(const Report& report);

// The maps and tables of the page of a comparison.

/// A map of deviations in one view.
struct DeviationMapFigure {
    std::string view;          ///< name of the view
    std::string_view png;      ///< bytes of the picture
    int width = 0, height = 0; ///< pixels of the picture
};

/// Style of html_maps, for the page's style sheet.
extern const std::string_view maps_style;
/// The maps side by side, each above the same caption in plain text; empty without any.
std::string html_maps(std::span<const DeviationMapFigure> maps, const std::string& caption);

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
