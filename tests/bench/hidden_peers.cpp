#include "tests/bench/hidden_peers.h"

#include "keiko/raster/light_pyramid.h"
#include "keiko/raster/lit_pixels.h"
#include "keiko/raster/shadow_casters.h"
#include "keiko/raster/smooth_shading.h"

#include <algorithm>
#include <array>
#include <limits>

namespace keiko::bench {
namespace {

/// The parts of an edge that triangles hide.
IntervalSet hidden_parts(const LightPyramid& before, const SurfaceMesh& mesh,
                         const std::vector<Box3>& boxes) {
    std::vector<ParameterInterval> parts;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!before.meets(boxes[t])) continue;
        const auto& [a, b, c] = mesh.triangles[t];
        ParameterInterval part{1, 0};
        for (const Vec3& shares :
             before.shadow_of({mesh.positions[a], mesh.positions[b], mesh.positions[c]}))
            part = {std::min(part.begin, shares.y), std::max(part.end, shares.y)};
        if (part.begin < part.end) parts.push_back(part);
    }
    return IntervalSet(std::move(parts));
}

/// Parts of [0, 1] that are left.
IntervalSet rest_of(const IntervalSet& hidden) {
    std::vector<ParameterInterval> rest;
    double begin = 0;
    for (const ParameterInterval& part : hidden) {
        rest.push_back({begin, part.begin});
        begin = part.end;
    }
    rest.push_back({begin, 1});
    std::erase_if(rest, [](const ParameterInterval& part) { return !(part.begin < part.end); });
    return IntervalSet(std::move(rest));
}

} // namespace

std::vector<IntervalSet> visible_edges(const SurfaceMesh& mesh, const Camera& camera) {
    const Viewpoint eye = eye_of(camera);
    std::vector<Box3> boxes(mesh.triangles.size());
    Box3 all;
    for (std::size_t t = 0; t < boxes.size(); ++t) {
        for (const std::uint32_t corner : mesh.triangles[t])
            boxes[t].extend(mesh.positions[corner]);
        all.extend(boxes[t]);
    }
    std::vector<IntervalSet> visible;
    for (const auto& corners : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::array ends{mesh.positions[corners[i]], mesh.positions[corners[(i + 1) % 3]]};
            const LightPyramid before(ends, eye, 1e-9 * all.size());
            visible.push_back(before.lights() ? rest_of(hidden_parts(before, mesh, boxes))
                                              : IntervalSet());
        }
    return visible;
}

ItemBuffer cast_triangles(const SurfaceMesh& mesh, const Camera& camera) {
    const PreparedCamera prepared(camera);
    ItemBuffer seen(camera.width, camera.height);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const Ray ray = prepared.ray(x + 0.5, y + 0.5);
            double first = std::numeric_limits<double>::infinity();
            for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
                const auto& [a, b, c] = mesh.triangles[t];
                const std::array corners{mesh.positions[a], mesh.positions[b], mesh.positions[c]};
                const Vec3 shares = ray_weights(corners, ray);
                if (!(std::min({shares.x, shares.y, shares.z}) >= 0)) continue;
                const double at = (mixed(shares, corners) - ray.origin).dot(ray.direction);
                if (at > 0 && at < first) first = at, seen.shown[seen.index(x, y)] = t;
            }
        }
    return seen;
}

} // namespace keiko::bench
