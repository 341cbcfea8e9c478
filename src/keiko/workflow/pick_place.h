#pragma once

#include "keiko/base/export.h"
#include "keiko/report/content/picked_place.h"
#include "keiko/workflow/open_scene.h"

#include <optional>

namespace KEIKO_API keiko {

/// The surface under a point of a camera's picture, in pixels, with the bound of its hit and ranges
/// of its curvatures (docs/theory/inspection.md). `seen`: the tracer of the scene, or of a part of
/// it, see seen_without. nullopt without a surface.
std::optional<PickedPlace> pick_place(const Scene& scene, const Tracer& seen, const Camera& camera,
                                      const Vec2& pixel);

} // namespace keiko
