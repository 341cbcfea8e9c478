#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/geometry/seam/seam.h"
#include "keiko/inspect/basics/face_limits.h"
#include "keiko/inspect/basics/verdict.h"
#include "keiko/inspect/seams/knot_piece.h"
#include "keiko/inspect/seams/model_borders.h"
#include "keiko/inspect/seams/seam_partition.h"
#include "keiko/scene/criteria_preset.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// The curvatures across the seam at the place of their largest difference.
struct CurvatureStep {
    double curvature_a = 0, curvature_b = 0;            ///< 1/mm
    CurvatureFormula formula = CurvatureFormula::alias; ///< that the mismatch is judged by
    double mismatch = 0;                                ///< by the formula, share of 1
    double alias = 0, catia = 0;                        ///< by either formula, whichever is judged
    bool flat = false; ///< the preset's flat radius replaces the curvatures to which the change is
                       ///< compared
    MeasuredValue worst; ///< share of 1
};

/// Slopes of the curvatures across the seam at the place of their largest difference (G3).
struct CurvatureSlopeStep {
    double slope_a = 0, slope_b = 0; ///< 1/mm2, in the direction from a to b
    double change = 0;               ///< 1/mm2, of the slope
    MeasuredValue worst;             ///< degrees, see slope_angle
};

/// A stretch of the line along which two faces meet, all of one class; or of a line inside one
/// face along which its patches meet (`internal`).
struct MeasuredSeam {
    /// Indices of its two sides in the model's arrays.
    std::uint32_t instance_a = 0, face_a = 0, instance_b = 0, face_b = 0;
    std::uint32_t id_a = 0, id_b = 0; ///< Face::id of the sides
    std::string faces; ///< "face 12 (fender-outer) | face 13"; instances too if there are several
    std::uint32_t line = 0;            ///< number of the line that it is a stretch of, from 0
    std::vector<std::uint32_t> pieces; ///< into MeasuredSeams::pieces; empty where internal
    std::vector<KnotPiece> knots{};    ///< its pieces where internal
    double length = 0;                 ///< mm
    Vec3 middle{0};                    ///< a point halfway along, world, mm
    /// Course of the stretch: 33 points of each of its pieces, from end to end, world, mm. The
    /// position of an end at which the class changes is accurate to class_change_bound.
    std::vector<std::vector<Vec3>> course{};
    SeamClass kind = SeamClass::smooth; ///< class of all its places
    /// True if it is shorter than the preset's negligible length, and so not judged: `verdict` is
    /// pass.
    bool scrap = false;
    double negligible = 0;              ///< mm: a shorter stretch of the line is a scrap
    MeasuredValue gap;                  ///< G0, mm
    std::optional<MeasuredValue> angle; ///< G1, degrees; nullopt if a side has no normal
    double smallest_angle = 0;          ///< degrees, if there is an angle
    /// G2; only where smooth, and gap and angle pass.
    std::optional<CurvatureStep> curvature;
    /// G3; only if gap, angle and curvature pass, and unless the seam is nearly flat all along.
    std::optional<CurvatureSlopeStep> slope;
    /// Degrees/mm: of a crease that fades out, the largest step of its angle's slope there.
    std::optional<MeasuredValue> fading;

    /// The face of side a.
    PlacedFace side_a() const { return {instance_a, face_a}; }
    /// The face of side b.
    PlacedFace side_b() const { return {instance_b, face_b}; }

    /// True if its worst place lies in the last ring around an irregular point of a subdivision
    /// surface, which has no curvature there.
    bool irregular = false;

    /// A knot line inside a face, along which the face itself breaks.
    bool internal = false;
    /// True if one side lies on the other's material where the gap is largest.
    bool overlap = false;
    /// True for a fold whose sides lie over each other at a distance larger than the gap allowed,
    /// like the two skins of a sheet without the faces between their borders.
    bool stacked = false;
    /// True if the gap grows past the distance within which borders count as a seam.
    bool parted = false;

    /// The worst verdict of the quantities by which its class is judged.
    Verdict verdict = Verdict::pass;
    /// Ratio of the worst judged quantity to its limit: 1 at the limit; 0 for a scrap.
    double severity = 0;

    /// True for a crease or its run-out if all of its judged quantities pass.
    bool is_passing_crease() const {
        return (kind == SeamClass::crease || kind == SeamClass::run_out) &&
               verdict == Verdict::pass && !scrap;
    }
    /// True if the angle is compared with a limit.
    bool is_angle_judged() const {
        return !scrap && (kind == SeamClass::smooth || kind == SeamClass::fold);
    }
};

/// The judged seams of a model.
struct MeasuredSeams {
    std::vector<Seam> pieces;        ///< as paired, cut where their class changes
    std::vector<MeasuredSeam> seams; ///< its stretches, of one class each
};

/// Joins seams of the same two faces that touch (`join` mm) into lines, cuts each line into
/// stretches of one class and measures these on the exact geometry; in the order of their first
/// seams.
MeasuredSeams measure_seams(const ModelBorders& borders, std::span<const Seam> seams,
                            const FaceLimits& limits, double join, const Job& job = {});

/// Measures the seams, followed by the stretches of knot lines inside faces (measure_knot_lines).
/// Scraps are excused by what they add up to (judged_scraps), on seams and knot lines together.
MeasuredSeams measure_all_seams(const ModelBorders& borders, std::span<const Seam> seams,
                                const FaceLimits& limits, double join, const Job& job = {});

/// Number of lines to which stretches belong: the number of seams in reports.
std::size_t line_count(std::span<const MeasuredSeam> seams);

/// Measures lines inside faces as seams of a face with itself, within its trims, in the order of
/// the faces and of each face's instances. These are the lines along which two patches meet with
/// less than G2, as knots of high multiplicity leave them. So are the lines across which a placed
/// face bends within the preset's negligible length (bend_pieces). A line breaks above 1e-4 mm,
/// 1e-4 degrees or, for its curvatures, 0.1 % and 2e-7 /mm of the unplaced face: digits of files
/// cause less. In a face whose approximation may hide as much, all sides between patches count.
/// Scraps are judged too, until measure_all_seams takes them out of it. Faces at irregular points
/// of cages are left out: they have knots of their own and none of the file's.
std::vector<MeasuredSeam> measure_knot_lines(const ModelBorders& borders, const FaceLimits& limits,
                                             const Job& job = {});

} // namespace keiko
