#pragma once

#include "keiko/inspect/surface_lines.h"

#include <string>
#include <vector>

namespace keiko {

/// The lines that one view shows.
struct ViewLines {
    std::string view;
    Camera camera;
    std::vector<SurfaceLine> lines;
};

/// What a search for lines found: to be written.
struct LineList {
    std::string tool_version;
    std::string rig; ///< its name
    LineLook look = LineLook::reflection;
    std::vector<ViewLines> views;
};

/// "keiko-lines/1", on one line of text; see docs/file-formats.md. Faces have the numbers of
/// `model`. It holds no time, so that every run gives the same bytes.
std::string lines_json(const LineList& list, const SurfaceModel& model);

/// A header and one row a point: view,line,plane,lamp,face,x,y,z; `line` counts from 0 through all
/// views, as in lines_json. A closed line has its first point again at its end.
std::string lines_csv(const LineList& list, const SurfaceModel& model);

} // namespace keiko
