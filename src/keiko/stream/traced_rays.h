#pragma once

#include "keiko/base/export.h"
#include "keiko/intersect/hit/hit.h"
#include "keiko/math/rgb.h"
#include "keiko/workflow/open_scene.h"

#include <functional>
#include <span>
#include <vector>

namespace KEIKO_API keiko {

// Rays at hand, on what a scene shows, its ground included. Hit::face is the number of the face in
// files and reports. Each function throws FieldError "rays" for a ray that trace_rays() would
// refuse, and Cancelled.

/// The first hits of rays: `write(ray, hit)` is called once for each ray by its index, on any
/// thread; null: no hit.
void trace_hits(const Scene& scene, std::span<const Ray> rays,
                const std::function<void(std::size_t ray, const Hit* hit)>& write,
                const Job& job = {});

/// Every hit of rays by rising t: `write(ray, hits)` is called once for each ray by its index, on
/// any thread.
void trace_all_hits(const Scene& scene, std::span<const Ray> rays,
                    const std::function<void(std::size_t ray, std::span<const Hit> hits)>& write,
                    const Job& job = {});

/// Luminance in cd/m2 along each ray, against its direction, under a rig: that of a picture whose
/// pixels have no width. Rays that meet nothing have what is beyond: the sky, or the scene's
/// background.
std::vector<Rgb> luminances_along(const Scene& scene, const LightRig& rig,
                                  std::span<const Ray> rays, const Job& job = {});

} // namespace keiko
