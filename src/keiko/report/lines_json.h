#pragma once

#include "keiko/inspect/joined_lines.h"

#include <string>
#include <vector>

namespace keiko {

/// The lines that one view shows.
struct ViewLines {
    std::string view;
    Camera camera;
    JoinedLines found;
};

/// What a search for lines found: to be written.
struct LineList {
    std::string tool_version;
    std::string rig; ///< its name
    LineLook look = LineLook::reflection;
    CriteriaPreset preset;
    double join = 0.5; ///< mm
    std::vector<ViewLines> views;
};

/// Crossings of all views by verdict.
struct CrossingCounts {
    std::size_t fail = 0, undecided = 0, pass = 0;
    std::size_t not_judged = 0; ///< lines that end at a seam without a jump that says why
};
CrossingCounts count_crossings(const LineList& list);

/// The worst of all crossings.
Verdict verdict_of(const LineList& list);

/// "keiko-lines/2", on one line of text; see docs/file-formats.md. Faces have the numbers of
/// `model`. It holds no time, so that every run gives the same bytes.
std::string lines_json(const LineList& list, const SurfaceModel& model);

/// A header and one row a point: view,line,piece,plane,lamp,face,x,y,z; `line` counts from 0
/// through all views, as in lines_json, `piece` within the line. A closed line has its first point
/// again at its end.
std::string lines_csv(const LineList& list, const SurfaceModel& model);

/// A header and one row a crossing, in the order of lines_json.
std::string crossings_csv(const LineList& list);

/// A table of the `most` worst crossings for people, with a line that tells what its columns are.
std::string crossings_table(const LineList& list, std::size_t most);

} // namespace keiko
