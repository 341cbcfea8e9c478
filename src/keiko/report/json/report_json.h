#pragma once

#include "keiko/report/content/report.h"

#include <string>

namespace keiko {

// All three have keys in a fixed order, numbers in full precision, lengths in mm, angles in
// degrees, curvatures in 1/mm, shares of 1, and points as [x, y, z]. Unknown values are null.

/// Summary of a file as "keiko-model-facts/1". File: source, file_format, unit,
/// millimetres_per_unit. Parts: parts, instances, part_list [{name, faces, patches, instances,
/// mirrored_instances}]. Faces: faces, placed_faces, trimmed_faces, approximated_faces,
/// largest_approximation. Patches: patches, rational_patches, surface_kinds {kind: faces}, degrees
/// [{u, v, patches}], bounds {lower, upper}. Borders: edges, degenerate_edges,
/// largest_edge_tolerance, join, seams, border_length, free_border_length. Remarks: lost_faces
/// [{id, name, reason}], remarks {notes, warnings, errors}, diagnostics [{severity, entity,
/// message}]. If a tracer was built: tracing {sub_patches, mixed_sub_patches,
/// trimmed_away_sub_patches, bytes, build_milliseconds?}. List of faces: face_list [{id, name,
/// part, layer, color, surface_kind, patches, degree [u, v], rational, loops, approximated}] with
/// `part` an index of part_list.
std::string facts_json(const ModelFacts& facts);

/// The geometry judged by criteria as "keiko-inspection/1". Verdict: tool {name, version}, verdict
/// ("pass", "undecided", "fail"). Counts of stretches: counts {fail, undecided, pass, creases,
/// run_outs, scraps}. Counts of faces: face_counts {fail, undecided, pass}. Input: preset, join,
/// model (as facts_json, without face_list).
/// Seams: worst_seams [numbers] and seams, a list of objects. Names of a seam: number (from 1),
/// line (from 1), faces, face_ids, instances. Its class: verdict, kind ("smooth", "run-out",
/// "crease", "fold"), scrap, severity. Its place: length, middle, from, to. Its measures: gap,
/// angle, curvature, curvature_slope, fading, internal, overlap, parted.
/// Faces: faces, a list of objects. Names of a face: number, name, face_id, instance. Its measures:
/// verdict, radius, curvature {largest, smallest, largest_mean, smallest_mean, largest_gaussian,
/// smallest_gaussian: each {value, bound, undecided, place}, singular (mm)}. Its inflections:
/// inflections [{closed, proved, length, rate (1/mm2), deviation (mm), points}]. Its flaws: flaws?
/// [{kind ("dent", "bump", "waves"), width (mm), value, bound, limit, verdict, place}].
/// Findings: findings [{code, rule, seam or face (numbers), faces, quantity, unit, formula?,
/// message}]. A bound is null if there is none. Each gap, radius, angle, curvature and finding has
/// value, bound, limit, verdict and place; limit and verdict are null if the value is not judged.
std::string inspection_json(const Inspection& inspection, const std::string& tool_version);

/// The whole report as "keiko-report/1". Inspection: tool {name, version} and the keys of
/// inspection_json, with the verdict of lines and seams together. Lines: lines {rig, look, preset,
/// verdict, counts, crossings} with the keys of lines_json, or null. Coverage: coverage {rig,
/// covered, unreached}. Pictures: pictures, line_pictures, curvature_pictures and close_ups
/// [{title, file, width, height, markers [{number, x, y}]}]. Close-ups have the number of their
/// seam or face, or the rank of their crossing, from 1. The report holds no time, so that every run
/// gives the same bytes.
std::string report_json(const Report& report);

} // namespace keiko
