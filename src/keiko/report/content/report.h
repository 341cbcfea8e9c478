#pragma once

#include "keiko/base/export.h"
#include "keiko/base/output_folder.h"
#include "keiko/inspect/inspection.h"
#include "keiko/inspect/seams/seam_profile.h"
#include "keiko/placement/best_view.h"
#include "keiko/report/content/combs_text.h"
#include "keiko/report/content/line_list.h"
#include "keiko/scene/analysis.h"
#include "keiko/triage/triage.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// A number drawn on a picture, pixels from the upper left.
struct PictureMarker {
    int number = 0;      ///< the rank that is drawn
    double x = 0, y = 0; ///< middle of the mark
};

/// A finished picture and its texts.
struct ReportPicture {
    std::string title;                  ///< e.g. "front"
    std::string caption;                ///< one sentence, or empty
    std::string file_name;              ///< beside the report, e.g. "front.png"
    std::string png;                    ///< the file's bytes
    int width = 0, height = 0;          ///< pixels
    std::vector<PictureMarker> markers; ///< the number is that of a shown item, from 1
};

/// A close-up of a finding.
struct CloseUp {
    /// Kind of a finding.
    enum class Of {
        seam,    ///< a stretch of a seam
        face,    ///< a face that does not pass
        crossing ///< a line that crosses a seam
    };
    Of of = Of::seam; ///< kind of the finding
    /// Index into Inspection::seams or faces, or into ranked_crossings.
    std::uint32_t index = 0;
    ReportPicture picture; ///< the close-up itself
    Vec3 place{0};         ///< in its middle; world, mm
};

/// Share of the surface that the lamps' reflections reach.
struct CoverageSummary {
    std::string rig;                    ///< path or name of the rig
    double covered = 0;                 ///< share of 1
    std::vector<std::string> unreached; ///< faces or regions, one line each
};

/// A file that a report rests on.
struct InputFile {
    std::string path;   ///< as it was named, or as a file names it
    std::string sha256; ///< of its bytes, 64 hexadecimal digits
};

/// All contents of a report. Values only: the same report gives the same bytes.
struct Report {
    std::string tool_version;                ///< version of Keiko that made it
    std::vector<InputFile> inputs;           ///< models, scene, rig, views and settings, each once
    std::vector<std::string> opened;         ///< the models in order, or the scene file
    std::vector<NamedView> views;            ///< of `pictures`, in order
    Inspection inspection;                   ///< seams, faces and their verdicts
    std::optional<CoverageSummary> coverage; ///< of lamps that were placed or rated
    std::optional<LineList> lines;           ///< of the views of `pictures`
    Triage triage;                           ///< of whole_inspection()
    /// Zebra in the standing views by which the first faults are ordered.
    std::vector<ReportPicture> standing_pictures;
    /// Line drawing with the findings' numbers, SVG, or a sentence why there is none; or empty.
    std::string drawing;
    std::vector<ReportPicture> pictures;      ///< stripe pictures, in order
    std::vector<ReportPicture> line_pictures; ///< stripe pictures with the lines
    /// Analysis pictures of the surface, each named for its view.
    std::vector<ReportPicture> curvature_pictures;
    std::vector<CombPicture> combs;        ///< if combs were requested
    std::vector<std::string> comb_remarks; ///< on planes that gave no section
    std::vector<CloseUp> close_ups;        ///< of the worst findings, in their order
    std::vector<SeamProfile> profiles;     ///< of the worst stretches that do not pass, in order
    std::vector<AnalysisNote> notes;       ///< of the analysis, on this body
};

/// The worst of the verdicts of the inspection and the lines.
inline Verdict verdict_of(const Report& report) {
    const Verdict seams = report.inspection.verdict;
    return report.lines ? std::max(seams, verdict_of(*report.lines)) : seams;
}

/// The inspection with what was judged of lines.
inline Inspection whole_inspection(const Report& report) {
    return report.lines ? with_lines(report.inspection, *report.lines) : report.inspection;
}

/// Number of worst seams that reports name.
constexpr std::size_t worst_seam_count = 5;

/// An item of the first screen, which pictures number: a fault, or a stretch of a seam.
struct ShownItem {
    const TriageItem* fault = nullptr; ///< null for a stretch without findings
    std::uint32_t seam = no_index;     ///< the stretch that shows most of it, if no face does
    std::uint32_t face = no_index;     ///< that shows most of it
    Vec3 place{0};                     ///< the worst one, world, mm
};

/// The first faults of the triage; without any, the worst stretches of seams. Jumps that no eye
/// resolves are the last of them where most stretches are among those. Refers to the report.
std::vector<ShownItem> shown_items(const Report& report);

/// The stretches that the first screen shows, then the worst that do not pass: `most` at most.
std::vector<std::uint32_t> first_seams(const Report& report, std::size_t most);

/// Largest number of stretches whose profiles a page shows.
constexpr std::size_t most_profiles = 20;

/// The whole report as "keiko-report/1", in the manner of inspection_json. Inspection: tool {name,
/// version}, inputs [{path, sha256}], opened [paths], views [{name, camera}] and the keys of
/// inspection_json, with the verdict of lines and seams together. Lines: lines {rig, look, preset,
/// verdict, counts, crossings} with the keys of lines_json, or null. Triage: triage {items,
/// hidden}, both [{mending, findings, seams, face (numbers), length (mm), visible (share of 1),
/// width (arc minutes), weight (arc minutes), view, mirrored, fine}]. Coverage: coverage
/// {rig, covered, unreached}. Pictures: standing_pictures, pictures, line_pictures,
/// curvature_pictures and close_ups
/// [{title, file, width, height, markers [{number, x, y}]}]. Close-ups have the number of their
/// seam or face, or the rank of their crossing, from 1. Notes: notes [{text, place (mm), face}],
/// the face null if the note has no place any more. The report holds no time, so that every run
/// gives the same bytes.
std::string report_json(const Report& report);

/// The report for people: one HTML page that needs no other file, pictures included.
std::string report_html(const Report& report);

/// report.html (self-contained), report.json and the pictures.
FolderContent report_files(const Report& report);

} // namespace keiko
