#pragma once

#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/light/luminance/clear_coat.h"
#include "keiko/light/rig/prepared_rig.h"
#include "keiko/render/caustics/beam_mesh.h"
#include "keiko/render/caustics/surface_footprint.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// Illuminance by caustics, lx.
struct CausticLight {
    Rgb incident; ///< what arrives
    Rgb entering; ///< what enters the coat
};

/// Light that smooth mirrors and solid glass throw onto the other surfaces of a scene, of points,
/// spotlights, luminaires and suns (docs/theory/caustics.md).
class Caustics {
public:
    /// Follows the light of a rig. `materials`: one a face of the tracer's model. Keeps references
    /// to all but `spec`. Throws Cancelled.
    Caustics(const Tracer& tracer, std::span<const Material> materials, const PreparedRig& rig,
             const CausticSpec& spec, const Job& job = {});

    /// Mean illuminance of a footprint: the light of the beams that it cuts, by the share of each
    /// within it. Its sum over the pixels of a surface is the light of the beams.
    CausticLight over(const SurfaceFootprint& footprint, const ClearCoat* coat = nullptr) const;
    /// Illuminance by each source of the rig at a place of a surface, on a plane of unit `normal`
    /// there. Each ray that lands there is found by Newton's method from the beams about it, and
    /// brings the light of its chart over the Jacobian of the landings. Infinite where rays narrow
    /// 2e5 times and more from the first surface on, in foci and on focal lines. On a fold itself
    /// that ray does not count.
    std::vector<Rgb> at(const SurfaceFootprint& place) const;
    /// lm of all beams that land on a face.
    Rgb flux_on(std::uint32_t face) const;

private:
    struct Root;
    const LightChart& chart_of(std::uint32_t beam) const { return charts_[chart_of_beam_[beam]]; }
    void add(std::size_t source, const PreparedSource& light, std::span<const Box3> boxes,
             const Box3& scene, const CausticSpec& spec, const Job& job);
    std::vector<std::uint32_t> beams_at(const SurfaceFootprint& place) const;
    std::optional<Root> root_near(std::uint32_t beam, const Vec3& place) const;

    LightPaths paths_;
    double size_ = 0; ///< mm, of what casts them
    std::vector<LightChart> charts_;
    std::vector<std::size_t> source_of_chart_;
    std::size_t sources_;
    std::vector<Beam> beams_;
    std::vector<std::uint32_t> chart_of_beam_;
    BoxTree tree_;
};

} // namespace keiko
