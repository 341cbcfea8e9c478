#pragma once

#include "keiko/report/report.h"

#include <string>

namespace keiko {

// All three: keys in a fixed order, numbers in full precision, lengths in mm, angles in degrees,
// curvatures in 1/mm, shares of 1, points as [x, y, z]; null where nothing is known.

/// What is in a file, "keiko-model-facts/1": source, format unit,
/// parts, instances, faces, placed_faces, trimmed_faces, approximated_faces,
/// largest_approximation, patches, rational_patches, surface_kinds {kind: faces},
/// degrees [{u, v, patches}], bounds {lower, upper}, seams, border_length, free_border_length,
/// lost_faces [{id, name, reason}], diagnostics [{severity, entity, message}].
std::string facts_json(const ModelFacts& facts);

/// The geometry against criteria, "keiko-inspection/1": verdict ("pass", "undecided", "fail"),
/// counts {fail, undecided, pass, creases}, preset, join, model (as facts_json), worst_seams
/// [indices], seams [{faces, face_ids, instances, verdict, crease, severity, length, middle, gap,
/// angle, curvature}], findings [{code, rule, seam, faces, quantity, unit, formula?, message}].
/// Each gap, angle, curvature and finding has value, bound, limit, verdict and place.
std::string inspection_json(const Inspection& inspection);

/// The whole report, "keiko-report/1": tool {name, version}, the keys of inspection_json, then
/// coverage {rig, covered, unreached}, pictures and close_ups [{title, file, width, height,
/// markers [{number, x, y}], seam?}].
std::string report_json(const Report& report);

} // namespace keiko
