#pragma once

#include "keiko/base/job.h"
#include "keiko/inspect/worst.h"
#include "keiko/patch/seam.h"
#include "keiko/spec/criteria_preset.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace keiko {

/// The curvatures across the seam where they differ most.
struct CurvatureStep {
    double curvature_a = 0, curvature_b = 0; ///< 1/mm
    CurvatureFormula formula = CurvatureFormula::alias;
    double mismatch = 0;         ///< by the formula, share of 1
    double alias = 0, catia = 0; ///< by either formula, whichever is judged
    bool flat = false;           ///< both radii beyond flat_radius: judged by the change in 1/mm
    /// In the unit that is judged: share of 1, or 1/mm where flat.
    Worst worst;
};

/// How the curvatures across the seam change, where that differs most (G3).
struct CurvatureSlopeStep {
    double slope_a = 0, slope_b = 0; ///< 1/mm2, on the way from a to b
    double change = 0;               ///< 1/mm2, of the slope
    Worst worst;                     ///< degrees, see slope_angle
};

/// Everything known of the line along which two faces meet: a chain of one or more Seams; or of a
/// line inside one face along which its patches meet (`internal`).
struct MeasuredSeam {
    std::uint32_t instance_a = 0, face_a = 0, instance_b = 0, face_b = 0;
    std::uint32_t id_a = 0, id_b = 0; ///< Face::id of the sides
    std::string
        faces; ///< "face 12 (fender-outer) | face 13"; instances too where there are several
    std::vector<std::uint32_t> pieces; ///< into the seams measured; empty where internal
    double length = 0;                 ///< mm
    Vec3 middle{0};                    ///< a point halfway along, world, mm
    /// Where it runs: of each of its pieces 33 points from end to end, world, mm.
    std::vector<std::vector<Vec3>> course{};
    Worst gap;                              ///< G0, mm
    std::optional<Worst> angle;             ///< G1, degrees; nothing where a side has no normal
    double smallest_angle = 0;              ///< degrees, where there is an angle
    std::optional<CurvatureStep> curvature; ///< G2; only where gap and angle pass
    /// G3; only where gap, angle and curvature pass, and not all along nearly flat.
    std::optional<CurvatureSlopeStep> slope;
    /// The largest angle exceeds the preset's feature angle, and the sides are not folded back on
    /// each other all along, as those of a face that is there twice are.
    bool crease = false;

    /// Its worst place lies in the last ring around an irregular point of a subdivision surface,
    /// which has no curvature there.
    bool irregular = false;

    /// A knot line inside a face, along which the face itself breaks.
    bool internal = false;
    /// Where the gap is largest one side lies on the other's material.
    bool overlap = false;

    /// Of the gap, and except on creases of angle, curvature and its slope: the worst.
    Verdict verdict = Verdict::pass;
    /// How far over its limit the worst quantity is: 1 at the limit.
    double severity = 0;
};

/// Joins seams of the same two faces that touch (`join` mm) into chains and measures each on the
/// exact geometry; in the order of their first seams.
std::vector<MeasuredSeam> measure_seams(const SurfaceModel& model, std::span<const Seam> seams,
                                        const CriteriaPreset& preset, double join,
                                        const Job& job = {});

} // namespace keiko
