#pragma once

#include "keiko/report/content/line_list.h"
#include "keiko/report/markup/json_text.h"

namespace keiko {

/// Lines in a report: rig, look, preset, verdict, counts and crossings, with the keys of lines_json
/// but without the curves.
Json line_verdicts_json(const LineList& list);

} // namespace keiko
