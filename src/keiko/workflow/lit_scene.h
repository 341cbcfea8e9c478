#pragma once

#include "keiko/light/rig/prepared_rig.h"
#include "keiko/render/caustics/caustics.h"
#include "keiko/render/shading/glass_loss.h"
#include "keiko/render/shading/matter_loss.h"
#include "keiko/workflow/open_scene.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// The hit nearest to a point on the line through it along a normal, up to `reach` mm away.
std::optional<Hit> nearest_along(const Tracer& surfaces, const Vec3& point, const Vec3& normal,
                                 double reach);

/// A scene under a rig, prepared once for its light at many points, as numbers.
class LitScene {
public:
    /// Keeps references to both. `tubes`: model of light on surfaces. Throws Cancelled.
    LitScene(const Scene& scene, const LightRig& rig, TubeModel tubes, const Job& job = {});
    LitScene(const Scene& scene, LightRig&& rig, TubeModel tubes, const Job& job = {}) = delete;

    /// The first source that a point lies in a lamp of; nullopt: none.
    std::optional<std::size_t> source_around(const Vec3& point) const;
    /// Direct illuminance in lx by each source, in the order of the rig, of a point with a unit
    /// normal, caustics included. A point within 1e-3 mm of a surface counts as on it.
    std::vector<Rgb> direct(const Vec3& point, const Vec3& normal) const;
    /// Illuminance in lx of such a point by surfaces, gathered from the scene's solution; 0 without
    /// one.
    Rgb reflected(const Vec3& point, const Vec3& normal) const;

private:
    /// A place for which light is computed.
    struct Place {
        Vec3 position{0};
        std::optional<Hit> hit{}; ///< if it is on a surface

        std::optional<Root> root() const { return hit ? std::optional(hit->root) : std::nullopt; }
    };

    Place place_of(const Vec3& point, const Vec3& normal) const;
    void dim_by_glass(const Place& place, std::span<const LightId> lights,
                      std::vector<Rgb>& lux) const;
    void dim_by_matter(const Place& place, std::span<const LightId> lights,
                       std::vector<Rgb>& lux) const;
    std::vector<Rgb> caustics_at(const Place& place, const Vec3& normal) const;

    const Scene& scene_;
    PreparedRig rig_;
    TubeModel tubes_;
    GlassLoss glass_, straight_; ///< where caustics land, and without them
    MatterLoss matter_;
    std::optional<Caustics> caustics_;
};

} // namespace keiko
