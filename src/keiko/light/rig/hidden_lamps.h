#pragma once

#include "keiko/base/error.h"
#include "keiko/base/export.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/math/bounds.h"

namespace KEIKO_API keiko {

/// Warning if area lights of a rig stand behind others as viewed from a body in a box: their light
/// on it is too bright, since lamps hide nothing. Found by rays from the middle and the corners of
/// the box to places on each light; empty without such a light.
Diagnostics hidden_lamp_remarks(const LightRig& rig, const Box3& body);

} // namespace keiko
