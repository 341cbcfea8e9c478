#pragma once

#include "keiko/base/export.h"
#include "keiko/light/rig/light_rig.h"

#include <array>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

/// Kinds of lamps that hang where a row is placed.
enum class LampKind {
    tube,  ///< parallel tubes
    panel, ///< one luminous panel, as large as the row
    screen ///< bright bars in place of tubes, as wide as the dark ones between them
};

/// Every kind.
inline constexpr std::array lamp_kinds{LampKind::tube, LampKind::panel, LampKind::screen};

/// "tube", "panel", "screen"
std::string_view name_of(LampKind kind);

/// The lights of a kind in the rectangle of a row. Panels and bars shine from the plane of the row
/// to the side of `body` (mm), with the luminance of its lamps.
std::vector<LightSource> lights_of(const CPlane& row, LampKind kind, const Vec3& body);

} // namespace keiko
