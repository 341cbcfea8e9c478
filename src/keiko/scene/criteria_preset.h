#pragma once

#include "keiko/base/export.h"
#include "keiko/scene/draft_limit.h"
#include "keiko/scene/face_selection.h"
#include "keiko/scene/joint_limits.h"
#include "keiko/scene/symmetry.h"

#include <optional>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Formula by which two normal curvatures across a seam are compared; both are printed beside their
/// value.
enum class CurvatureFormula {
    alias, ///< |R1 - R2| / (R1 + R2), 100 % where the sides bend opposite ways
    catia  ///< |C1 - C2| / max(|C1|, |C2|), up to 200 % where they bend opposite ways
};

/// Limit of the curvature's step across a seam, and its formula.
struct CurvatureLimit {
    CurvatureFormula formula = CurvatureFormula::alias; ///< by which the step is measured
    double limit = 0.1;                                 ///< share of 1

    bool operator==(const CurvatureLimit&) const = default;
};

/// Limits of reflection lines where they cross a seam; what is absent is not judged. Keiko's own
/// limits, derived in docs/theory/verdict.md.
struct LineLimits {
    std::optional<double> jump; ///< mm on the part, sideways
    /// Degrees: the seam angle that would move the lamp's image on the C-plane as far.
    std::optional<double> turn;
    std::optional<double> kink; ///< degrees; only where jump and turn pass
    std::optional<double> bend; ///< 1/mm, change of the line's curvature; only where kink passes

    bool operator==(const LineLimits&) const = default;
};

/// Limit of the depth of dents, bumps and waves inside a face.
struct WavinessLimit {
    double depth = 0.01;     ///< mm from the form around them
    double window = 100;     ///< mm: how wide a piece of the face that form is taken from
    bool waves_only = false; ///< what bends there only once is form, however wide

    bool operator==(const WavinessLimit&) const = default;
};

/// Limits of each face, whatever its neighbours; what is absent is not judged.
struct SurfaceLimits {
    std::optional<double> minimum_radius;  ///< mm, G-SU-CR: of the principal curvatures
    std::vector<WavinessLimit> waviness;   ///< G-SU-WV and KEIKO-DENT; by ascending windows
    std::optional<DraftLimit> draft;       ///< KEIKO-DRAFT: of every place of a face
    std::optional<SymmetryLimit> symmetry; ///< KEIKO-SYMMETRY, of the body as a whole

    bool operator==(const SurfaceLimits&) const = default;
};

/// Limits of how faces are put together from patches and edges; what is absent is not judged.
struct StructureLimits {
    std::optional<int> degree;              ///< G-SU-HD: largest of a spline surface, in u and in v
    std::optional<int> spans;               ///< KEIKO-SPANS: most knot spans, in u and in v
    std::optional<double> knot_distance;    ///< mm, G-SU-IK: least width of a knot span
    std::optional<double> patch_edge;       ///< mm, G-SU-TI: shortest edge that is not a point
    std::optional<double> degenerate_edge;  ///< mm, G-SU-DC: shortest edge, points included
    std::optional<double> corner_angle;     ///< degrees, G-SU-DP: from 0 and from 180
    std::optional<double> short_edge;       ///< mm, G-CU-TI: shortest edge of a face
    std::optional<double> small_face;       ///< mm, G-FA-TI: smallest size of a face
    std::optional<double> width_ratio;      ///< G-SU-RN: of neighbouring knot spans, 1 or more
    std::optional<double> control_turn;     ///< degrees, KEIKO-NET-TURN: along a row of the net
    std::optional<double> control_twist;    ///< degrees, KEIKO-NET-TWIST: between rows side by side
    std::optional<double> control_ratio;    ///< KEIKO-NET-RATIO: of neighbouring legs, 1 or more
    std::optional<double> control_distance; ///< mm, KEIKO-NET-POINTS: least, of neighbours in a row
    std::optional<double> identical_face;   ///< mm, G-SU-EM: least distance of a face from another
    std::optional<double> identical_edge;   ///< mm, G-CU-EM: least distance of an edge from another
    std::optional<double> self_distance;    ///< mm, G-SU-IS: least distance of a face from itself
    std::optional<double> loop_crossing;    ///< mm, G-LO-IS: longest part of a loop cut off by it
    std::optional<double> edge_gap;         ///< mm, G-CU-LG: between edges that follow in a loop
    std::optional<double> edge_angle;       ///< degrees, G-CU-NT: kink inside an edge
    std::optional<int> edge_degree;         ///< G-CU-HD: largest of the curves of an edge
    std::optional<double> edge_knot_distance; ///< mm, G-CU-IK: shortest curve of an edge

    bool operator==(const StructureLimits&) const = default;
};

/// Limits beyond which something is reported as worth inspecting, without a part in any verdict.
struct LookLimits {
    /// Dents, bumps and waves; by ascending windows. Used where SurfaceLimits has no such limit.
    std::vector<WavinessLimit> waviness;
    /// mm of the body from its image at the plane that it is nearly symmetric about, if there is
    /// one; the plane is found. Used where SurfaceLimits has no such limit.
    std::optional<double> symmetry{};

    bool operator==(const LookLimits&) const = default;
};

struct Zone;

/// Limits that a surface is held to. They are practice, not a standard; `source` states whose.
/// Users name or write a preset file (keiko-preset/1, read_preset); the values here are those of
/// the class-a-outer that comes with Keiko, which searches for dents and waves too.
struct CriteriaPreset {
    std::string name = "class-a-outer"; ///< by which users choose it
    /// Whose practice the limits are.
    std::string source = "class A as quoted in trade forums; practice, not a standard";
    double gap = 0.01;                                          ///< mm, G0
    double angle = 0.1;                                         ///< degrees, G1
    std::optional<CurvatureLimit> curvature = CurvatureLimit{}; ///< G2; nothing: not judged
    double feature_angle = 5; ///< degrees; places of a seam with more are a crease, no finding
    /// Degrees/mm: how large a step the slope of a crease's angle may have where it fades out.
    double fading = 0.0014;
    double longest_run_out = 200; ///< mm; an angle that fades over more is no run-out of a crease
    double negligible = 0.1;      ///< mm; a shorter stretch of a seam is a scrap, listed alone
    double flat_radius =
        100000;         ///< mm; larger radii of curvature are compared as if they were this
    std::string caveat; ///< what the limits are not, or empty
    std::optional<double> curvature_slope;                  ///< degrees, G3; nothing: not judged
    LineLimits lines{std::nullopt, 0.1, 5.7, std::nullopt}; ///< of reflection lines at seams
    SurfaceLimits surface{};                                ///< of each face by itself
    StructureLimits structure{};                            ///< of patches and edges
    LookLimits look{};                                      ///< of what is worth inspecting
    JointLimits joint{.parallelism = 0.5};                  ///< of joints, where requested
    /// Faces with limits of their own. A face belongs to the first that selects it, and is judged
    /// by the limits above without any.
    std::vector<Zone> zones;

    /// The limits by which dents and waves are searched for: those that are judged, else the
    /// others.
    const std::vector<WavinessLimit>& flaw_limits() const {
        return surface.waviness.empty() ? look.waviness : surface.waviness;
    }

    bool operator==(const CriteriaPreset&) const = default;
};

/// Faces with limits of their own, such as the class B surfaces of a body.
struct Zone {
    std::string name;        ///< unique in its preset
    std::string file;        ///< path of the file that has it, for messages
    FaceSelection selection; ///< at least one condition
    /// Limits of its faces, without zones. `feature_angle`, `longest_run_out`, `negligible`,
    /// `flat_radius`, the symmetry and `look` are those of the preset: what a place of a seam is
    /// does not depend on the zone.
    CriteriaPreset limits;

    bool operator==(const Zone&) const = default;
};

} // namespace keiko
