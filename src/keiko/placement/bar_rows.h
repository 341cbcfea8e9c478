#pragma once

#include "keiko/light/rig/light_rig.h"
#include "keiko/placement/lamp_kind.h"

#include <vector>

namespace keiko {

/// Rows that the lamps of a rig hang in: its C-planes in order, then its rectangular panels that
/// shine to `body` (mm). Equal panels in a plane that lie side by side equally far apart are bars
/// of one row, without a diameter, as lights_of makes them. The long sides run along a row; a panel
/// alone is a row of one lamp. Panels of other shapes are in no row.
std::vector<CPlane> rows_of(const LightRig& rig, const Vec3& body);

/// Kind of the lamps in rows of a rig: tubes if it has any, else bars if a row has several.
LampKind kind_of(const LightRig& rig, const std::vector<CPlane>& rows);

} // namespace keiko
