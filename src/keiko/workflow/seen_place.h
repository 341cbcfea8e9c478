#pragma once

#include "keiko/workflow/open_scene.h"

#include <optional>

namespace keiko {

/// The hit at which a place of the body is visible to the camera; nullopt if something hides it or
/// it lies outside the picture. `place`: world, mm.
std::optional<Hit> seen_place(const Scene& scene, const Camera& camera, const Vec3& place);

} // namespace keiko
