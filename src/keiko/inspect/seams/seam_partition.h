#pragma once

#include "keiko/base/export.h"
#include "keiko/inspect/seams/seam_probe.h"

#include <optional>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

/// The class of a place of a seam, by the angle between the normals of its two sides. Each class
/// has rules of its own: docs/theory/verdict.md.
enum class SeamClass {
    smooth,  ///< up to the feature angle: gap, angle, curvature and its slope are judged
    run_out, ///< the end of a crease, along which its angle fades to the limit of the angle
    crease,  ///< more than the feature angle: a feature line, whose gap alone is judged
    fold     ///< the sides lie on each other, as for a duplicated face: it fails
};

/// "smooth", "run-out", "crease", "fold"
constexpr std::string_view name_of(SeamClass kind) {
    switch (kind) {
        case SeamClass::smooth:
            return "smooth";
        case SeamClass::run_out:
            return "run-out";
        case SeamClass::crease:
            return "crease";
        case SeamClass::fold:
            return "fold";
    }
    return "";
}

/// Degrees: from this angle on the two sides count as folded back on each other.
constexpr double fold_angle = 179;

/// The class of one place; nullopt if a side has no normal. Run-outs belong to whole stretches.
inline std::optional<SeamClass> class_of(const SeamPoint& point, double feature_angle) {
    if (!point.angle) return std::nullopt;
    if (*point.angle > fold_angle) return SeamClass::fold;
    return *point.angle > feature_angle ? SeamClass::crease : SeamClass::smooth;
}

/// Limits by which a seam is cut into stretches.
struct StretchLimits {
    double feature_angle = 5;     ///< degrees
    double negligible = 0.1;      ///< mm; a shorter part may be missed
    double join = 0.5;            ///< mm: largest distance between pieces of one line
    double angle = 0.1;           ///< degrees: a run-out ends where the angle falls to this
    double fading = 0.0014;       ///< degrees/mm: largest step of the slope of a fading angle
    double longest_run_out = 200; ///< mm: an angle that fades over a longer distance is no run-out
};

/// A part of one piece of a seam, all of one class.
struct SeamPart {
    std::uint32_t piece = 0;            ///< index of the probe
    SeamClass kind = SeamClass::smooth; ///< of all its places
    SeamPoint begin, end;               ///< in the order of side a
    double length = 0;                  ///< mm, of side a
    double unknown = 0;                 ///< mm of it along which a side has no normal
};

/// mm: error of the position at which the class changes.
constexpr double class_change_bound = 1e-6;

/// Cuts a piece of a seam where its class changes, as parts in order, at least one. Steps between
/// patch changes are halved while their ends differ in class. They are also halved while the angle
/// at their middle deviates from the chord between their ends by enough to carry it over a
/// threshold. This is an estimate, down to an eighth of the negligible length. A place without
/// normals has the class of its neighbours.
std::vector<SeamPart> partition_seam(const SeamProbe& probe, std::uint32_t piece,
                                     const StretchLimits& limits);

} // namespace keiko
