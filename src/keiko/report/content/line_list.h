#pragma once

#include "keiko/inspect/lines/joined_lines.h"

#include <string>
#include <vector>

namespace keiko {

/// The lines of one view.
struct ViewLines {
    std::string view;
    Camera camera;
    JoinedLines found;
};

/// Results of a search for lines, prepared for writing.
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
    std::size_t not_judged = 0; ///< lines that end at a seam without a jump that explains it
};
CrossingCounts count_crossings(const LineList& list);

/// The worst of all crossings.
Verdict verdict_of(const LineList& list);

/// One of a list's crossings.
struct CrossingPlace {
    std::size_t view = 0;     ///< into LineList::views
    std::size_t crossing = 0; ///< into the view's crossings

    const LineCrossing& in(const LineList& list) const {
        return list.views[view].found.crossings[crossing];
    }
};
/// All crossings that have a verdict, worst first: tables and pictures number them in this order
/// from 1.
std::vector<CrossingPlace> ranked_crossings(const LineList& list);

} // namespace keiko
