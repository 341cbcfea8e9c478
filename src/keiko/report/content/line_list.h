#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/inspection.h"
#include "keiko/inspect/lines/joined_lines.h"

#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// The lines of one view.
struct ViewLines {
    std::string view;  ///< name of the view
    Camera camera;     ///< of the view
    JoinedLines found; ///< lines and crossings, from this viewpoint
};

/// Results of a search for lines, prepared for writing.
struct LineList {
    std::string tool_version;             ///< version of Keiko that found them
    std::string rig;                      ///< its name
    LineLook look = LineLook::reflection; ///< kind of the lines
    CriteriaPreset preset;                ///< that crossings were judged by
    double join = 0.5;                    ///< mm
    std::vector<ViewLines> views;         ///< one a view
    AcceptanceList acceptances{}; ///< of findings; only those of lines in one of the views apply
    /// The faces that are judged, and the zones; nullopt if the preset has no zones and all are.
    std::optional<JudgedScope> scope{};
    std::vector<LineSource> sources{}; ///< whose lines they are: planes of lines by their index
};

/// Crossings of all views by verdict.
struct CrossingCounts {
    std::size_t fail = 0, undecided = 0, pass = 0; ///< number of each
    std::size_t not_judged = 0;   ///< lines that end at a seam without a jump that explains it
    std::size_t out_of_scope = 0; ///< crossings between faces that are not judged
};
/// Counts the crossings of all views.
CrossingCounts count_crossings(const LineList& list);

/// The worst of all crossings, without what is accepted.
Verdict verdict_of(const LineList& list);

/// One of a list's crossings.
struct CrossingPlace {
    std::size_t view = 0;     ///< into LineList::views
    std::size_t crossing = 0; ///< into the view's crossings

    /// The crossing itself.
    const LineCrossing& in(const LineList& list) const {
        return list.views[view].found.crossings[crossing];
    }
};
/// All crossings that have a verdict, worst first: tables and pictures number them in this order
/// from 1.
std::vector<CrossingPlace> ranked_crossings(const LineList& list);

/// Checks of the lines that cross each seam, in the order of views and faces: the worst crossing
/// for each limit of a view. Findings that the list accepts are marked.
std::vector<Check> line_checks(const LineList& list);

/// The inspection with the checks, the findings and what is accepted of the lines among its own,
/// for other programs.
Inspection with_lines(Inspection inspection, const LineList& list);

/// "keiko-lines/2", on one line of text; see docs/file-formats.md. Faces have the numbers of
/// `model`. It holds no time, so that every run gives the same bytes.
std::string lines_json(const LineList& list, const SurfaceModel& model);

/// CSV with a header and one row a point: view,line,piece,plane,lamp,face,x,y,z. `line` counts from
/// 0 through all views, as in lines_json, `piece` within the line. A closed line repeats its first
/// point at its end.
std::string lines_csv(const LineList& list, const SurfaceModel& model);

/// CSV with a header and one row an inflection of a line: view,line,plane,lamp,along,x,y,z. `along`
/// is in mm from where the line begins.
std::string line_inflections_csv(const LineList& list);

/// CSV with a header and one row a crossing, in the order of lines_json.
std::string crossings_csv(const LineList& list);

/// A table of the `most` worst crossings for people, numbered as in ranked_crossings, with a line
/// that explains its columns.
std::string crossings_table(const LineList& list, std::size_t most);

} // namespace keiko
