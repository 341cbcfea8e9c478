#pragma once

#include "keiko/report/content/line_list.h"

namespace keiko {

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
