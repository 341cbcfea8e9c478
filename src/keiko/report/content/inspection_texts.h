#pragma once

#include "keiko/base/error.h"
#include "keiko/base/export.h"
#include "keiko/inspect/check.h"
#include "keiko/inspect/inspection.h"
#include "keiko/inspect/model_facts.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

// An inspection, and the facts of its model, as text in each format, and the words that the formats
// share.

/// "seam 3 (face 1 | face 2)", whose number is that of the report's table, from 1; "face 1"; "lines
/// over face 1 | face 2 in view front".
std::string subject_of(const Check& check);

/// The worst value of a check with its unit, "0.208°".
std::string value_text(const Check& check);

/// "face 1 | face 2: the gap of ... is over the limit of ..., at 50.0, 0.0, 0.0"; the place in mm.
std::string placed_message(const Check& check);

/// Length of free edges, which no seam judges, in words: "798.8 of 798.8 mm of borders meet no
/// other". Empty if all borders meet to within rounding.
std::string unmet_borders(const ModelFacts& facts);

/// Statement that nothing was judged, for a body of several faces without any seam, with the
/// distance within which seams were searched. Else empty.
std::string nothing_judged(const Inspection& inspection);

/// Warning if joints were sought and none was found, or none judged, and if their gap, flush or
/// radius has limits and they were not sought; else empty.
std::string joints_not_judged(const Inspection& inspection);

/// Warning of the stretches whose curvature (G2), or its slope (G3), was not judged, as the gap,
/// angle or curvature before it fails and is accepted; empty if there are none.
std::string curvature_not_judged(const Inspection& inspection);

/// One remark, or several equal ones, for people.
struct FoldedRemark {
    Severity severity = Severity::note; ///< of all of them
    std::string text;                   ///< "face 12: invalid in the file (226 times)"
};

/// Remarks in which equal ones are one with their number, in the order of first occurrence.
std::vector<FoldedRemark> folded_remarks(const Diagnostics& remarks);

/// "note", "warning" or "error".
std::string_view name_of(Severity severity);

/// Counts of the stretches of seams: "stretches of seams 1 fail, 0 undecided, 2 pass, 0 creases,
/// 1 scrap (of 3 seams); 1.5 of 20.0 mm of borders meet no other".
std::string seams_words(const Inspection& inspection);

/// An inspection for people at a terminal: the verdict with its counts, then up to `most` findings,
/// the worst first, a line each.
std::string inspection_text(const Inspection& inspection, std::size_t most = 20);

/// Summary of a model file for a terminal: one fact a line.
std::string facts_text(const ModelFacts& facts);

// The JSON formats have keys in a fixed order, numbers in full precision, lengths in mm, angles in
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

/// All checks of an inspection as CSV ([RFC4180], UTF-8, dots for decimals): a header, then one row
/// a seam and criterion. Numbers are in full precision and empty if nothing was judged, where the
/// verdict is "not judged".
std::string checks_csv(const Inspection& inspection);

/// An inspection for build servers, as JUnit XML (the schema of the xUnit plugin of Jenkins,
/// junit-10.xsd): one suite, one case a seam and criterion. An exceeded limit is a failure. A value
/// that cannot be distinguished from its limit is an error, and so is a lost face. A check that
/// could not be judged is skipped. The XML holds no time, so that every run gives the same bytes.
std::string junit_xml(const Inspection& inspection);

/// Number of results that GitHub accepts in one run; it refuses a file with more.
constexpr std::size_t most_sarif_results = 25'000;

/// The findings as a SARIF 2.1.0 log [SARIF], for tools that show those of static analysers: one
/// rule a criterion, one result a finding. A failure is an error; what cannot be distinguished from
/// its limit is a warning, `properties.verdict` undecided; a lost face is an error of the run.
///
/// `files` are those of the model in the order of FaceFacts::file. A result stands in the file of
/// its first face, on the line of the face's entity or else on line 1, and names the second face as
/// a related location. Its partial fingerprint is a hash of the code and the names of the faces.
/// Of more than most_sarif_results findings the worst are kept, and a notification states how many
/// were left out. The log holds no time, so that every run gives the same bytes.
std::string sarif_json(const Inspection& inspection, const std::string& tool_version,
                       std::span<const std::filesystem::path> files);

} // namespace keiko
