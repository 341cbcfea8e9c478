#pragma once

#include "keiko/light/rig/light_id.h"
#include "keiko/light/rig/light_visibility.h"
#include "keiko/light/rig/prepared_rig.h"
#include "keiko/light/rig/surface_light.h"
#include "keiko/render/shading/occluded_visibility.h"
#include "keiko/visibility/query/occluders.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// Corners of a box around some lamps of a source, by rising number, and those between them:
/// everything that may light a surface, mm.
std::vector<Vec3> light_bounds(const PreparedSource& source, std::span<const int> lamps,
                               const Vec3& point);

/// Corners of a convex body around the part of one lamp of a source that a point queries: a tube's
/// axis, or all of it if shadows are weighed over its width.
std::vector<Vec3> lamp_corners(const PreparedSource& source, int lamp, const Vec3& point,
                               TubeModel model);

/// The sources of a rig as lights that the surfaces of a scene may occlude.
class DirectLighting {
public:
    /// Without occluders no shadows are cast. Keeps references to all.
    DirectLighting(const PreparedRig& rig, const Occluders* occluders, const Tracer& tracer)
        : rig_(rig), occluders_(occluders), tracer_(tracer) {}

    /// All lights, by source, then by lamp.
    const std::vector<LightId>& lights() const { return rig_.lights; }
    /// Visibility of some lights from a point with a unit normal on the side to be lit, by source,
    /// then by lamp; for a point on a surface, `root` is its own. `axes`: see light_visibilities();
    /// rigs with a medium have them always.
    std::vector<LightVisibility> light_visibility(const Vec3& point, const Vec3& normal,
                                                  const std::optional<Root>& root,
                                                  std::span<const LightId> lights, TubeModel model,
                                                  bool axes = true) const;

    /// Visibility of some lamps of a source, by rising number, from such a point. Keeps references.
    OccludedVisibility visibility(const PreparedSource& source, std::span<const int> lamps,
                                  const Vec3& point, const Vec3& normal,
                                  const std::optional<Root>& root) const;

    /// False if all of the hull of `places` is proved to have one visibility of a light: all of it
    /// or nothing; see Occluders::may_occlude(). Windows are not tested. False, too, for an open
    /// sky, whose light is fitted.
    bool may_occlude(std::span<const Vec3> places, const LightId& light,
                     const std::optional<Vec3>& facing, TubeModel model) const;

private:
    const PreparedRig& rig_;
    const Occluders* occluders_;
    const Tracer& tracer_;
};

/// Point of a surface or in space with the known visibility of some lights of a rig.
class PointLighting {
public:
    /// Point with a unit normal on the side to be lit. `lights` are by source, then by lamp; `seen`
    /// of each is as returned by DirectLighting::light_visibility for the same model. Keeps
    /// references to rig and lights.
    PointLighting(const PreparedRig& rig, const Vec3& point, const Vec3& normal, TubeModel model,
                  std::span<const LightId> lights, std::vector<LightVisibility> seen)
        : rig_(rig),
          point_(point),
          normal_(normal),
          model_(model),
          lights_(lights),
          seen_(std::move(seen)) {}

    /// lx from each light, in order.
    std::vector<Rgb> illuminance_by_light(const ClearCoat* coat = nullptr) const;
    /// cd/m2 that the lobe of a kernel, made for the point's normal, reflects to its viewer of each
    /// light. `lighting` is that of the scene, `root` the point's own.
    template <class Kernel>
    std::vector<Rgb> glossy_by_light(const Kernel& kernel, const DirectLighting& lighting,
                                     const std::optional<Root>& root) const {
        return by_light([&](const PreparedSource& source, std::span<const int> lamps,
                            std::span<const LightVisibility> seen) {
            return glossy_luminance_by_lamp(
                source, lamps, seen, rig_.medium, point_, kernel,
                lighting.visibility(source, lamps, point_, normal_, root));
        });
    }

private:
    /// Values of `of_source` for each source, some of its lamps and their visibility, in the order
    /// of the lights.
    template <class OfSource>
    std::vector<Rgb> by_light(const OfSource& of_source) const {
        std::vector<Rgb> all;
        all.reserve(lights_.size());
        each_source(
            lights_, [&](std::size_t source, std::span<const int> lamps, std::size_t first) {
                for (const Rgb& value : of_source(rig_.sources[source], lamps,
                                                  std::span(seen_).subspan(first, lamps.size())))
                    all.push_back(value);
            });
        return all;
    }

    const PreparedRig& rig_;
    Vec3 point_, normal_;
    TubeModel model_;
    std::span<const LightId> lights_;
    std::vector<LightVisibility> seen_;
};

} // namespace keiko
