#include "keiko/workflow/mesh_light_shares.h"

#include "keiko/light/spotlight/point_light.h"
#include "keiko/raster/light_cone.h"
#include "keiko/raster/mesh_shadows.h"
#include "keiko/raster/panel_points.h"

#include <optional>
#include <variant>

namespace keiko {
namespace {

/// Parts along each edge of the triangles that a panel is divided into.
constexpr int parts_of_panel = 4;

std::vector<EmittingPoint> points_of(const PolygonLight& light) {
    std::vector<EmittingPoint> points = points_of_panel(light.corners, parts_of_panel);
    const std::size_t one_side = points.size();
    for (std::size_t i = 0; light.two_sided && i < one_side; ++i) {
        points.push_back(points[i]);
        points.back().normal = -points[i].normal;
    }
    return points;
}

/// The share of each kind of light; nullopt for one that casts no shadows.
struct ShareOf {
    const MeshView& view;
    const ShadowCasters& casters;
    MeshShadows by;
    const Job& job;

    template <PointLight Light>
    std::optional<Image> operator()(const Light& light) const {
        return lit_pixels(view, casters, Viewpoint::at(light.position), by, job);
    }
    std::optional<Image> operator()(const Sun& sun) const {
        return lit_pixels(view, casters, Viewpoint::towards(sun.towards()), by, job);
    }
    std::optional<Image> operator()(const PolygonLight& light) const {
        return lit_pixels(view, casters, points_of(light), by, job);
    }
    std::optional<Image> operator()(const SphereLight& light) const {
        return lit_by_cones(view, casters, {light.center, light.radius}, job);
    }
    template <class Other>
    std::optional<Image> operator()(const Other&) const {
        return std::nullopt;
    }
};

} // namespace

std::vector<MeshLightShare> mesh_light_shares(const LightRig& rig, const MeshView& view,
                                              const ShadowCasters& casters, MeshShadows by,
                                              const Job& job) {
    std::vector<MeshLightShare> shares;
    for (std::size_t i = 0; i < rig.sources.size(); ++i)
        if (auto share = std::visit(ShareOf{view, casters, by, job}, rig.sources[i]))
            shares.push_back({i, std::move(*share)});
    return shares;
}

} // namespace keiko
