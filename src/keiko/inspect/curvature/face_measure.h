#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/inspect/basics/face_limits.h"
#include "keiko/inspect/basics/verdict.h"
#include "keiko/inspect/flaws/flaw_search.h"
#include "keiko/inspect/regularity/singular_places.h"
#include "keiko/scene/criteria_preset.h"

#include <optional>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

// What is measured on each face by itself: inflections, curvature, and the verdict on all of it.

/// A parabolic curve on a face: one principal curvature is 0 along it and changes its sign, and the
/// Gaussian curvature with it. On one side the face is convex or concave, on the other a saddle.
struct InflectionCurve {
    bool closed = false;      ///< the last point is the first one again
    bool proved = true;       ///< its course; otherwise likely, not certain
    double length = 0;        ///< mm
    double rate = 0;          ///< 1/mm2: the fastest change of the curvature across the curve
    double deviation = 0;     ///< mm, about the largest distance between curve and chords
    std::vector<Vec3> points; ///< world, mm, on the exact surface
};

/// Options of inflection_curves.
struct InflectionOptions {
    double chord_error = 0.01; ///< mm
    /// 1/mm. A curvature that changes by less all over a face is visually flat, and often flat to
    /// the digits of a file.
    double flat_change = 2e-6;
};

/// The inflection curves of a placed face within its trims, followed over the borders of its
/// patches, the longest first (docs/theory/inspection.md). A jump of the Gaussian curvature over 0
/// at a knot line is none: that is a seam with different curvatures.
std::vector<InflectionCurve> inflection_curves(const SurfaceModel& model, std::uint32_t instance,
                                               std::uint32_t face,
                                               const InflectionOptions& options = {});

/// The largest or smallest curvature over a face.
struct CurvatureExtreme {
    double value = 0;       ///< 1/mm, or 1/mm2 of a Gaussian curvature
    double bound = 0;       ///< the true extreme lies at most this far beyond the value
    Vec3 place{0};          ///< world, mm
    bool undecided = false; ///< the bound stayed wider than curvature_tolerance requires
};

/// Tolerance of an extreme, as a share of the larger of it and the curvature of a sphere as large
/// as the face.
constexpr double curvature_tolerance = 1e-3;

/// The extremes of the curvatures of a placed face within its trims; positive where the surface
/// bends towards its outward normal.
struct FaceCurvature {
    CurvatureExtreme largest, smallest;                   ///< of both principal curvatures
    CurvatureExtreme largest_mean, smallest_mean;         ///< of the mean curvature
    CurvatureExtreme largest_gaussian, smallest_gaussian; ///< of the Gaussian curvature
    double size = 0; ///< mm, diagonal of the box around the face's control points
    /// Extent in mm of the surroundings of places such as a pole in which curvatures are unknown,
    /// because the parametrisation is singular there; 0 if the face has none.
    double singular = 0;
};

/// Finds the extremes by branch and bound with interval bounds of the curvatures
/// (docs/theory/inspection.md). They are accurate to curvature_tolerance if `most_splits` cuts of
/// pieces, and one a patch, suffice; `bound` states the accuracy reached. nullopt for a face that
/// its trims leave no material of.
std::optional<FaceCurvature> face_curvature(const SurfaceModel& model, std::uint32_t instance,
                                            std::uint32_t face, std::size_t most_splits = 5000);

/// Measurements of one placed face by itself, independent of its neighbours.
struct MeasuredFace {
    std::uint32_t instance = 0, face = 0; ///< into the model's arrays
    std::uint32_t id = 0;                 ///< Face::id
    std::string name; ///< "face 12 (fender-outer)"; with its instance if there are several
    /// Extremes of curvature. nullopt if trims leave no material of the face. Also nullopt if it is
    /// an approximation of a face of the file, or lies at an irregular point of a cage: its
    /// curvature then differs from the true one.
    std::optional<FaceCurvature> curvature;
    /// The smallest radius of curvature, mm; nullopt for a plane. It is measured even if the preset
    /// does not judge it; its limit is then 0.
    std::optional<MeasuredValue> radius;
    /// The smallest draft angle, degrees; nullopt if its preset has no limit of it, or trims leave
    /// no material.
    std::optional<MeasuredValue> draft;
    /// Dents, bumps and waves at least half as deep as the limit, the deepest first. `inspect`
    /// searches them (find_flaws) if the preset has a limit, judged or not.
    std::vector<Flaw> flaws;
    /// Places at which the face is not regular, the largest angle first. `inspect` searches them
    /// (singular_places) on faces that have a curvature. A fold is judged and fails.
    std::vector<SingularPlace> singular;
    /// Curves along which the face turns from convex or concave to a saddle, the longest first; not
    /// judged. Empty for a face that replaces another.
    std::vector<InflectionCurve> inflections;
    Verdict verdict = Verdict::pass; ///< the worst of all its verdicts; pass out of the scope
    bool in_scope = true;            ///< false: not judged
};

/// Measures and judges every placed face by itself, without flaws, in the order of instances and
/// faces. Throws Cancelled.
std::vector<MeasuredFace> measure_faces(const SurfaceModel& model, const FaceLimits& limits,
                                        const Job& job = {});

} // namespace keiko
