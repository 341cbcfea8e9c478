#include "keiko/raster/pixel_facets.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/raster/patch_subdivision.h"
#include "keiko/raster/smooth_shading.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace keiko {
namespace {

/// Corner of a piece on the exact surface.
struct PieceCorner {
    Vec3 position{0}, normal{0};
};

PieceCorner corner_at(const SurfaceModel& model, const PatchPiece& piece, const Vec2& uv) {
    const SurfaceDerivatives s = evaluate(model.patch(piece.patch), uv, 2);
    const Affine& placed = model.instances[piece.instance].transform;
    PieceCorner corner{placed.point(s.position())};
    const auto normal = robust_normal(s, uv);
    if (!normal) return corner;
    const bool reversed = model.faces[model.patches[piece.patch].face].reversed;
    corner.normal = placed.normal(reversed ? -*normal : *normal).normalized();
    return corner;
}

/// Patch parameters where the ray meets a piece, about: on the plane of the half that it meets or
/// comes nearest to. Not beyond the patch, nor farther beside the piece than that is wide.
Vec2 met_parameters(const SurfaceModel& model, const PatchPiece& piece, const Ray& ray) {
    const Affine& placed = model.instances[piece.instance].transform;
    const Vec2 &low = piece.uv.lower, &high = piece.uv.upper, wide = piece.uv.extent();
    const auto met = [&](const Vec2& middle) {
        const std::array uv{low, middle, high};
        std::array<Vec3, 3> places;
        for (std::size_t i = 0; i < 3; ++i)
            places[i] = placed.point(evaluate(model.patch(piece.patch), uv[i], 0).position());
        return std::pair(ray_weights(places, ray), uv);
    };
    const auto least = [](const Vec3& shares) { return std::min({shares.x, shares.y, shares.z}); };
    const auto below = met({high.x, low.y}), above = met({low.x, high.y});
    const auto& [shares, uv] = least(below.first) >= least(above.first) ? below : above;
    Vec2 at = mixed(shares, uv);
    for (unsigned i = 0; i < 2; ++i)
        at[i] =
            std::clamp(at[i], std::max(low[i] - wide[i], 0.0), std::min(high[i] + wide[i], 1.0));
    return at;
}

/// A facet as large as half of the piece, around the place where the ray meets it.
std::array<PieceCorner, 3> facet_of(const SurfaceModel& model, const PatchPiece& piece,
                                    const Ray& ray) {
    const Vec2 middle = met_parameters(model, piece, ray), wide = piece.uv.extent();
    const auto corner = [&](double u, double v) {
        const Vec2 at = middle + Vec2(u * wide.x, v * wide.y);
        return corner_at(model, piece, {std::clamp(at.x, 0.0, 1.0), std::clamp(at.y, 0.0, 1.0)});
    };
    return {corner(-0.5, -0.5), corner(0.5, -0.5), corner(0, 0.5)};
}

} // namespace

PixelFacets pixel_facets(const SurfaceModel& model, const Camera& camera, const Job& job) {
    const std::vector<PatchPiece> pieces = subdivided_pieces(model, camera, job);
    PixelFacets facets{{}, ItemBuffer(camera.width, camera.height)};
    std::vector<std::size_t> shown; // pixels, by triangle
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (pieces[i].instance == no_index) continue;
        const auto triangle = static_cast<std::uint32_t>(shown.size());
        facets.items.shown[i] = triangle;
        facets.mesh.triangles.push_back({3 * triangle, 3 * triangle + 1, 3 * triangle + 2});
        facets.mesh.faces.push_back(model.faces[model.patches[pieces[i].patch].face].id);
        shown.push_back(i);
    }
    facets.mesh.source = model.source;
    facets.mesh.positions.resize(3 * shown.size());
    facets.mesh.normals.resize(3 * shown.size());
    const PreparedCamera eye(camera);
    constexpr std::size_t chunk = 1024;
    parallel_for((shown.size() + chunk - 1) / chunk, job, "facets", [&](std::size_t c) {
        for (std::size_t t = c * chunk; t < std::min(shown.size(), (c + 1) * chunk); ++t) {
            const auto width = static_cast<std::size_t>(camera.width);
            const auto x = static_cast<double>(shown[t] % width);
            const auto y = static_cast<double>(shown[t] / width);
            const auto corners = facet_of(model, pieces[shown[t]], eye.ray(x + 0.5, y + 0.5));
            for (std::size_t k = 0; k < 3; ++k) {
                facets.mesh.positions[3 * t + k] = corners[k].position;
                facets.mesh.normals[3 * t + k] = corners[k].normal;
            }
        }
    });
    return facets;
}

} // namespace keiko
