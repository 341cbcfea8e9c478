#include "keiko/raster/pixel_facets.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/raster/patch_subdivision.h"
#include "keiko/raster/smooth_shading.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

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

/// True for three places that span a plane, beyond rounding. At poles corners coincide.
bool has_area(const Vec3& a, const Vec3& b, const Vec3& c) {
    constexpr double rounding = 1e-9;
    const Vec3 ab = b - a, ac = c - a;
    return ab.cross(ac).length() > rounding * std::max(ab.length2(), ac.length2());
}

/// A triangle of half of a piece.
struct PieceHalf {
    std::array<Vec2, 3> uv; ///< its corners, patch parameters
    Vec3 shares{0};         ///< of them, where the ray meets its plane
    /// Least of the shares; a half without area is met nowhere.
    double least = -std::numeric_limits<double>::infinity();

    PieceHalf(const SurfaceModel& model, const PatchPiece& piece, const Vec2& middle,
              const Ray& ray)
        : uv{piece.uv.lower, middle, piece.uv.upper} {
        const Affine& placed = model.instances[piece.instance].transform;
        std::array<Vec3, 3> places;
        for (std::size_t i = 0; i < 3; ++i)
            places[i] = placed.point(evaluate(model.patch(piece.patch), uv[i], 0).position());
        shares = ray_weights(places, ray);
        if (has_area(places[0], places[1], places[2]))
            least = std::min({shares.x, shares.y, shares.z});
    }
};

/// Patch parameters where the ray meets a piece, about: on the plane of the half that it meets or
/// comes nearest to. Not beyond the patch, nor farther beside the piece than that is wide.
Vec2 met_parameters(const SurfaceModel& model, const PatchPiece& piece, const Ray& ray) {
    const Vec2 &low = piece.uv.lower, &high = piece.uv.upper, wide = piece.uv.extent();
    const PieceHalf below(model, piece, {high.x, low.y}, ray);
    const PieceHalf above(model, piece, {low.x, high.y}, ray);
    const PieceHalf& met = below.least >= above.least ? below : above;
    Vec2 at = mixed(met.shares, met.uv);
    for (unsigned i = 0; i < 2; ++i)
        at[i] =
            std::clamp(at[i], std::max(low[i] - wide[i], 0.0), std::min(high[i] + wide[i], 1.0));
    return at;
}

/// Corners around a place of a patch, of two base corners and a tip; none beyond the patch.
std::array<PieceCorner, 3> facet_around(const SurfaceModel& model, const PatchPiece& piece,
                                        const Vec2& middle, const Vec2& base_to_tip) {
    const auto corner = [&](double u, double v) {
        const Vec2 at = middle + Vec2(u * base_to_tip.x, v * base_to_tip.y);
        return corner_at(model, piece, {std::clamp(at.x, 0.0, 1.0), std::clamp(at.y, 0.0, 1.0)});
    };
    return {corner(-0.5, -0.5), corner(0.5, -0.5), corner(0, 0.5)};
}

/// A facet as large as half of the piece, around the place where the ray meets it. Where corners
/// coincide on a collapsed side of the patch it is moved beside that, its tip there.
std::array<PieceCorner, 3> facet_of(const SurfaceModel& model, const PatchPiece& piece,
                                    const Ray& ray) {
    Vec2 middle = met_parameters(model, piece, ray), wide = piece.uv.extent();
    const auto facet = facet_around(model, piece, middle, wide);
    if (has_area(facet[0].position, facet[1].position, facet[2].position)) return facet;
    for (unsigned i = 0; i < 2; ++i) {
        wide[i] = std::min(wide[i], 0.5); // not from one side of the patch to the other
        middle[i] = std::clamp(middle[i], wide[i] / 2, 1 - wide[i] / 2);
    }
    return facet_around(model, piece, middle, middle.y < 0.5 ? -wide : wide);
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
