#pragma once

#include "keiko/inspect/seams/seam_probe.h"

#include <optional>
#include <string_view>

namespace keiko {

/// The class of a place of a seam, by the angle between the normals of its two sides. Each class
/// has rules of its own: docs/theory/verdict.md.
enum class SeamClass {
    smooth,  ///< up to the feature angle: gap, angle, curvature and its slope are judged
    run_out, ///< the end of a crease, along which its angle fades to the limit of the angle
    crease,  ///< more than the feature angle: a feature line, whose gap alone is judged
    fold     ///< the sides lie on each other, as for a duplicated face: it fails
};

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

} // namespace keiko
