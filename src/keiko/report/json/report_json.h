#pragma once

#include "keiko/report/content/report.h"

#include <string>

namespace keiko {

// All three: keys in a fixed order, numbers in full precision, lengths in mm, angles in degrees,
// curvatures in 1/mm, shares of 1, points as [x, y, z]; null where nothing is known.

/// What is in a file, "keiko-model-facts/1": source, file_format, unit, millimetres_per_unit,
/// parts, instances, part_list [{name, faces, patches, instances, mirrored_instances}], faces,
/// placed_faces, trimmed_faces, approximated_faces, largest_approximation, patches,
/// rational_patches, surface_kinds {kind: faces}, degrees [{u, v, patches}],
/// bounds {lower, upper}, edges, degenerate_edges, largest_edge_tolerance, join, seams,
/// border_length, free_border_length, lost_faces [{id, name, reason}], remarks {notes, warnings,
/// errors}, diagnostics [{severity, entity, message}], tracing {sub_patches, mixed_sub_patches,
/// trimmed_away_sub_patches, bytes, build_milliseconds?} where a tracer was built, face_list [{id,
/// name, part, layer, color, surface_kind, patches, degree [u, v], rational, loops,
/// approximated}] with `part` an index of part_list.
std::string facts_json(const ModelFacts& facts);

/// The geometry against criteria, "keiko-inspection/1": tool {name, version}, verdict ("pass",
/// "undecided", "fail"), counts {fail, undecided, pass, creases, run_outs, scraps} of stretches,
/// face_counts {fail, undecided, pass}, preset, join, model (as facts_json, without face_list),
/// worst_seams [numbers], seams [{number (from 1), line (from 1), faces, face_ids, instances,
/// verdict, kind
/// ("smooth", "run-out", "crease", "fold"), scrap, severity, length, middle, from, to, gap, angle,
/// curvature, curvature_slope, fading, internal, overlap, parted}], faces [{number, name, face_id,
/// instance, verdict, radius, curvature {largest, smallest, largest_mean, smallest_mean,
/// largest_gaussian, smallest_gaussian: each {value, bound, undecided, place}, singular (mm)},
/// inflections [{closed, proved, length, rate (1/mm2), deviation (mm), points}], flaws? [{kind
/// ("dent", "bump", "waves"), width (mm), value, bound, limit, verdict, place}]}], findings [{code,
/// rule, seam or face (numbers), faces, quantity, unit, formula?, message}]. A bound is null where
/// there is none. Each gap, radius, angle, curvature and finding has value, bound,
/// limit, verdict and place; limit and verdict are null where the value is not judged.
std::string inspection_json(const Inspection& inspection, const std::string& tool_version);

/// The whole report, "keiko-report/1": tool {name, version}, the keys of inspection_json with the
/// verdict of lines and seams together, then lines {rig, look, preset, verdict, counts, crossings}
/// with the keys of lines_json or null, coverage {rig, covered, unreached}, pictures,
/// line_pictures, curvature_pictures and close_ups [{title, file, width, height, markers [{number,
/// x, y}]}], close-ups with the number of their seam or face, or the rank of their crossing,
/// from 1. It holds no time, so that every run gives the same bytes.
std::string report_json(const Report& report);

} // namespace keiko
