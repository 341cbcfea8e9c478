#include "keiko/raster/shadow_volumes.h"

#include "keiko/raster/depth_tile.h"
#include "keiko/raster/lit_pixels.h"
#include "keiko/raster/tile_items.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace keiko {
namespace {

/// An edge at which the number of triangles between a light and what is behind changes.
struct ContourEdge {
    std::uint32_t from, to; ///< corners of the mesh
    int layers;             ///< triangles left of it, seen from the light, less those right of it
};

/// The number of the first corner at the place of each one.
std::vector<std::uint32_t> joined_corners(const SurfaceMesh& mesh) {
    const auto place = [&](std::uint32_t i) {
        const Vec3& p = mesh.positions[i];
        return std::tuple(p.x, p.y, p.z);
    };
    std::vector<std::uint32_t> order(mesh.positions.size()), joined(mesh.positions.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(place(a), a) < std::pair(place(b), b);
    });
    for (std::size_t i = 0; i < order.size(); ++i)
        joined[order[i]] =
            i > 0 && place(order[i]) == place(order[i - 1]) ? joined[order[i - 1]] : order[i];
    return joined;
}

/// The edges of all triangles that cast shadows, each turned to the light, and their layers: 1 or
/// -1.
std::vector<ContourEdge> turned_edges(const ShadowCasters& casters, const Viewpoint& light) {
    const std::vector<std::uint32_t> joined = joined_corners(casters.mesh());
    std::vector<ContourEdge> edges;
    for (std::uint32_t t = 0; t < casters.mesh().triangles.size(); ++t) {
        const auto [a, b, c] = casters.corners(t);
        const double side = (b - a).cross(c - a).dot(light.way_to(a));
        if (side == 0 || casters.hold(t, light)) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& corners = casters.mesh().triangles[t];
            const std::uint32_t from = joined[corners[i]], to = joined[corners[(i + 1) % 3]];
            const int layers = (side < 0) == (from < to) ? 1 : -1;
            if (from != to) edges.push_back({std::min(from, to), std::max(from, to), layers});
        }
    }
    return edges;
}

std::vector<ContourEdge> contour_edges(const ShadowCasters& casters, const Viewpoint& light) {
    std::vector<ContourEdge> edges = turned_edges(casters, light), contour;
    std::sort(edges.begin(), edges.end(), [](const ContourEdge& a, const ContourEdge& b) {
        return std::pair(a.from, a.to) < std::pair(b.from, b.to);
    });
    for (std::size_t i = 0; i < edges.size();) {
        ContourEdge sum = edges[i];
        while (++i < edges.size() && edges[i].from == sum.from && edges[i].to == sum.to)
            sum.layers += edges[i].layers;
        if (sum.layers != 0) contour.push_back(sum);
    }
    return contour;
}

/// The sides of the shadowed space.
struct ShadowSides {
    SurfaceMesh mesh;        ///< two triangles a side
    std::vector<int> layers; ///< a triangle: entered by rays that see it clockwise
};

ShadowSides shadow_sides(const ShadowCasters& casters, const Viewpoint& light, double length) {
    ShadowSides sides;
    for (const ContourEdge& edge : contour_edges(casters, light)) {
        const Vec3 &a = casters.mesh().positions[edge.from], &b = casters.mesh().positions[edge.to];
        const auto first = static_cast<std::uint32_t>(sides.mesh.positions.size());
        for (const Vec3& corner : {a, b, b + light.way_to(b).normalized() * length,
                                   a + light.way_to(a).normalized() * length})
            sides.mesh.positions.push_back(corner);
        sides.mesh.triangles.push_back({first, first + 1, first + 2});
        sides.mesh.triangles.push_back({first, first + 2, first + 3});
        sides.layers.insert(sides.layers.end(), 2, edge.layers);
    }
    return sides;
}

/// mm that sides must be long to end where no line of sight comes. Ends of a side are on the far
/// side of the ball around all that is seen by 20 times its radius, as it may be wide.
double length_of_sides(const MeshView& view) {
    Box3 all;
    for (const Vec3& position : view.mesh().positions) all.extend(position);
    all.extend(view.camera().eye);
    return 20 * all.size();
}

/// Layers between the light and the place where the line of sight of a pixel begins.
class StartLayers {
public:
    StartLayers(const MeshView& view, const ShadowCasters& casters, const Viewpoint& light)
        : camera_(view.camera()), casters_(casters), light_(light) {
        if (camera_.projection == Projection::perspective)
            of_eye_ = casters.layers(camera_.eye, light);
    }
    int at(int x, int y) const {
        if (camera_.projection == Projection::perspective) return of_eye_;
        return casters_.layers(camera_.ray(x + 0.5, y + 0.5).origin, light_);
    }

private:
    const Camera& camera_;
    const ShadowCasters& casters_;
    const Viewpoint& light_;
    int of_eye_ = 0;
};

/// Layers that the sides before each place of a tile add.
void add_sides(const TileItems& standing, const ShadowSides& sides, std::size_t tile,
               const DepthTile& depths, Image& layers) {
    standing.each_item(tile, [&](const ScreenItem& item) {
        const bool clockwise = doubled_area(item.at[0], item.at[1], item.at[2]) > 0;
        const int own = sides.layers[item.triangle];
        const auto entered = static_cast<float>(clockwise ? own : -own);
        scan_triangle(item.at, depths.window(), [&](int x, int y, double nearness) {
            if (nearness > depths.nearness(x, y)) *layers.pixel(x, y) += entered;
        });
    });
}

/// Layers that all sides before the place in each pixel add.
Image added_layers(const MeshView& view, const ShadowSides& sides, const Job& job) {
    const Camera& camera = view.camera();
    const TileGrid grid{camera.width, camera.height};
    const TileItems seen(screen_items(view.mesh(), camera, job), grid, job);
    const TileItems standing(screen_items(sides.mesh, camera, job), grid, job);
    Image layers(camera.width, camera.height, 1);
    parallel_for(grid.count(), job, "shadows", [&](std::size_t tile) {
        DepthTile depths(grid.tile(tile));
        seen.each_item(tile, [&](const ScreenItem& item) { depths.add(item.at, [](int, int) {}); });
        add_sides(standing, sides, tile, depths, layers);
    });
    return layers;
}

} // namespace

Image lit_by_volumes(const MeshView& view, const ShadowCasters& casters, const Viewpoint& light,
                     const Job& job) {
    const ShadowSides sides = shadow_sides(casters, light, length_of_sides(view));
    const Image layers = added_layers(view, sides, job);
    const StartLayers start(view, casters, light);
    return lit_pixels_where(view, light, job, [&](const MeshPlace&, int x, int y) {
        return start.at(x, y) + static_cast<int>(*layers.pixel(x, y)) <= 0;
    });
}

} // namespace keiko
