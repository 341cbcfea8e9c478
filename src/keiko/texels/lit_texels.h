#pragma once

#include "keiko/base/job.h"
#include "keiko/light/luminance/front_to_back.h"
#include "keiko/math/ray_differentials.h"
#include "keiko/texels/scene_texels.h"

#include <functional>
#include <optional>
#include <vector>

namespace keiko {

/// Light that arrives at a place from about one direction.
struct ArrivingLight {
    Vec3 towards{0, 0, 1}; ///< unit, to where it comes from
    Rgb illuminance{0};    ///< lx on a surface across it
};

/// Lights at a place in the middle of a shell, the same ones in the same order at each.
using LightsAt = std::function<std::vector<ArrivingLight>(const Vec3& place)>;

/// Light of texels along a part of a ray that is inside of their shells.
struct TexelLayer {
    double begin = 0, end = 0; ///< mm from the begin of the ray
    FrontToBack sum{};
};

/// Texels of a scene in its light (docs/theory/texels.md#light).
class LitTexels {
public:
    /// Finds the light at the nodes of the shells. `ambient`: cd/m2 from all sides. Keeps a
    /// reference to the texels. Throws Cancelled.
    LitTexels(const SceneTexels& texels, const LightsAt& lights, const Rgb& ambient,
              const Job& job = {});

    /// Layers along a segment, by rising begin. `spread` of the ray along it, from its begin, by
    /// mm: texels count as means over its width. They end early where less than a thousandth of
    /// the light behind passes.
    std::vector<TexelLayer> along(const Segment& segment,
                                  const std::optional<RayDifferentials>& spread) const;

private:
    /// Lights by node of a shell; empty at nodes without texels.
    using NodeLights = std::vector<std::vector<ArrivingLight>>;
    /// A place in a shell that is seen.
    struct Seen {
        std::size_t shell;
        const ShellPart& part;
        Vec3 in_cell, to_viewer;
        int level;
    };

    /// Lights at a place of a cell, by linear interpolation between its nodes.
    std::vector<ArrivingLight> lights_in(std::size_t shell, const ShellPart& part,
                                         const Vec3& in_cell) const;
    void add_run(std::size_t shell, const ShellRun& run, const Vec3& to_viewer, int level,
                 FrontToBack& sum) const;
    /// cd/m2 of an opaque layer of fibres of a unit direction.
    Rgb luminance(const Seen& seen, const Vec3& fibre, std::span<const ArrivingLight> lights) const;

    const SceneTexels& texels_;
    Rgb ambient_;
    std::vector<NodeLights> nodes_;  ///< by shell
    std::vector<double> highlights_; ///< fibre_highlight_scale() by shell
};

} // namespace keiko
