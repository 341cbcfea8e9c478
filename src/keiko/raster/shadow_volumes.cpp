#include "keiko/raster/shadow_volumes.h"

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
    /// The plane of a light and an edge, not unit.
    struct Plane {
        Vec3 normal, edge;

        bool is_above(const Vec3& place) const { return normal.dot(place - edge) > 0; }
    };

    SurfaceMesh mesh;          ///< two triangles for each part of a side
    std::vector<int> layers;   ///< a triangle: entered by rays that see it clockwise
    std::vector<Plane> planes; ///< a triangle: that of its edge
};

/// Adds the side behind the part of an edge from `a` to `b`. It is divided until the far ends of
/// its quadrangles are about as far away as their corners: a light beside a long edge sees that
/// under nearly 180 degrees.
void add_side(const Vec3& a, const Vec3& b, int layers, const Viewpoint& light, double length,
              const ShadowSides::Plane& plane, ShadowSides& sides) {
    constexpr double widest = 0.5; // cosine of 60 degrees
    const Vec3 to_a = light.way_to(a), to_b = light.way_to(b);
    const double near = to_a.length(), far = to_b.length();
    if (to_a.dot(to_b) < widest * near * far) {
        // Half of the angle is on either side of this place.
        const Vec3 middle = (a * far + b * near) / (near + far);
        add_side(a, middle, layers, light, length, plane, sides);
        return add_side(middle, b, layers, light, length, plane, sides);
    }
    const auto first = static_cast<std::uint32_t>(sides.mesh.positions.size());
    for (const Vec3& corner : {a, b, b + to_b / far * length, a + to_a / near * length})
        sides.mesh.positions.push_back(corner);
    sides.mesh.triangles.push_back({first, first + 1, first + 2});
    sides.mesh.triangles.push_back({first, first + 2, first + 3});
    sides.layers.insert(sides.layers.end(), 2, layers);
    sides.planes.insert(sides.planes.end(), 2, plane);
}

ShadowSides shadow_sides(const ShadowCasters& casters, const Viewpoint& light, double length) {
    ShadowSides sides;
    const std::vector<Vec3>& places = casters.mesh().positions;
    for (const ContourEdge& edge : contour_edges(casters, light)) {
        const Vec3 &a = places[edge.from], &b = places[edge.to];
        add_side(a, b, edge.layers, light, length, {light.way_to(a).cross(b - a), a}, sides);
    }
    return sides;
}

/// mm that sides must be long to end where no line of sight comes. Their ends are chords of up to
/// 60 degrees around the light, and so 0.86 times as far away.
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

/// A line of sight, from the eye to the place that a pixel shows.
struct Sight {
    Vec3 begin{0}, end{0}; ///< both the same where a pixel shows nothing
};

/// Lines of sight of the pixels of a tile, row by row.
std::vector<Sight> sights_of(const MeshView& view, const PixelBox& tile) {
    std::vector<Sight> sights;
    for (int y = tile.first_y; y <= tile.last_y; ++y)
        for (int x = tile.first_x; x <= tile.last_x; ++x) {
            sights.emplace_back();
            if (const auto place = view.at(x, y))
                sights.back() = {view.camera().ray(x + 0.5, y + 0.5).origin, place->position};
        }
    return sights;
}

/// Layers that the sides before each place of a tile add. The depths of rounded sides would not
/// do: beside a facet at a flat angle to the light, a little depth is many pixels.
void add_sides(const TileItems& standing, const ShadowSides& sides, std::size_t number,
               const PixelBox& tile, const MeshView& view, Image& layers) {
    const std::vector<Sight> sights = sights_of(view, tile);
    const int width = tile.last_x - tile.first_x + 1;
    standing.each_item(number, [&](const ScreenItem& item) {
        const bool clockwise = doubled_area(item.at[0], item.at[1], item.at[2]) > 0;
        const int own = sides.layers[item.triangle];
        const auto entered = static_cast<float>(clockwise ? own : -own);
        const ShadowSides::Plane& plane = sides.planes[item.triangle];
        scan_triangle(item.at, tile, [&](int x, int y, double) {
            const Sight& sight =
                sights[static_cast<std::size_t>((y - tile.first_y) * width + x - tile.first_x)];
            if (plane.is_above(sight.begin) != plane.is_above(sight.end))
                *layers.pixel(x, y) += entered;
        });
    });
}

/// Layers that all sides before the place in each pixel add.
Image added_layers(const MeshView& view, const ShadowSides& sides, const Job& job) {
    const Camera& camera = view.camera();
    const TileGrid grid{camera.width, camera.height};
    const TileItems standing(screen_items(sides.mesh, camera, job), grid, job);
    Image layers(camera.width, camera.height, 1);
    parallel_for(grid.count(), job, "shadows", [&](std::size_t tile) {
        add_sides(standing, sides, tile, grid.tile(tile), view, layers);
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
