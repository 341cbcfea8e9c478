#include "keiko/workflow/mesh_light_shares.h"

#include "keiko/light/spotlight/point_light.h"
#include "keiko/raster/light_cone.h"
#include "keiko/raster/mesh_shadows.h"

#include <optional>
#include <variant>

namespace keiko {
namespace {

/// Parts along each edge of the triangles that a panel is divided into.
constexpr int parts_of_panel = 4;

/// Adds the middles of the parts of a triangle of a panel.
void add_points(const std::array<Vec3, 3>& triangle, const Vec3& normal,
                std::vector<EmittingPoint>& points) {
    const Vec3 across = (triangle[1] - triangle[0]) / parts_of_panel,
               along = (triangle[2] - triangle[0]) / parts_of_panel;
    const double area = across.cross(along).dot(normal); // negative beside a notch
    for (int i = 0; i < parts_of_panel; ++i)
        for (int j = 0; i + j < parts_of_panel; ++j) {
            const Vec3 corner = triangle[0] + across * i + along * j;
            points.push_back({corner + (across + along) / 3, normal, area});
            if (i + j + 1 < parts_of_panel)
                points.push_back({corner + (across + along) * 2 / 3, normal, area});
        }
}

std::vector<EmittingPoint> points_of(const PolygonLight& light) {
    std::vector<EmittingPoint> points;
    for (std::size_t i = 1; i + 1 < light.corners.size(); ++i)
        add_points({light.corners[0], light.corners[i], light.corners[i + 1]}, light.normal(),
                   points);
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
