#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/bezier/nurbs.h"
#include "keiko/math/rgb.h"

#include <optional>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// A curve in space that other programs show under its name.
struct NamedCurve {
    std::string name;                       ///< what it is, and its verdict
    std::optional<Rgb> color{};             ///< parts 0 to 1; nullopt: none
    double deviation = 0;                   ///< mm, at most about this far from the exact curve
    std::vector<NurbsCurve<Vec4>> pieces{}; ///< in their order along it, mm
};

/// The curves of one file.
struct CurveSet {
    std::string name;                 ///< of the body that they lie on
    std::vector<NamedCurve> curves{}; ///< in the order of the file
};

} // namespace keiko
