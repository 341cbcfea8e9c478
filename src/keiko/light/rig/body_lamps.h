#pragma once

#include "keiko/light/rig/light_rig.h"
#include "keiko/math/affine.h"

#include <optional>

namespace keiko {

// Lights that stand for faces of a body that shine, and that the body itself shows. They belong
// to the body: another rig does not replace them, no rig file holds them.

/// True for a light that a face of a body shows.
bool is_body_lamp(const LightSource& source);
/// True if a rig has no light but those of a body: neither lamps nor even light.
bool shines_by_bodies_alone(const LightRig& rig);
/// Adds the lights of bodies in `from`, if there is such a rig, to another rig.
void add_body_lamps(const std::optional<LightRig>& from, LightRig& to);
/// Moves the lights of bodies with these; a motion that mirrors leaves them shining outwards.
void move_body_lamps(const Affine& motion, LightRig& rig);

} // namespace keiko
