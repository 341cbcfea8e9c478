#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/math/vec.h"
#include "keiko/radiosity/solved_triangle.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace keiko {

/// A place of a triangle: its number, and the shares of its corners.
struct TrianglePlace {
    std::uint32_t triangle = 0;
    Vec3 shares{0}; ///< none below 0; they sum to 1
};

/// Finds the triangles of elements at places of surfaces, by a grid over the parameters of each
/// face.
class ElementLocator {
public:
    /// `uv`: face parameters of the corners. Numbers of corners, instances and faces must be in
    /// range. Keeps references to model, corners and triangles.
    ElementLocator(const SurfaceModel& model, std::span<const Vec2> uv,
                   std::span<const SolvedTriangle> triangles);

    /// The triangle at the parameters of a patch; beside all triangles of its face, as chords of a
    /// border leave room, one near it. nullopt on a face without triangles.
    std::optional<TrianglePlace> at(std::uint32_t instance, std::uint32_t patch,
                                    const Vec2& uv) const;
    /// True if the front of elements is the side that du x dv points to.
    bool front_is_normal(std::uint32_t instance, std::uint32_t patch) const;

private:
    /// A grid over the triangles of a placed face.
    struct Grid {
        Box2 box;                         ///< face parameters of its corners
        std::size_t cells = 1;            ///< along both sides
        std::vector<std::size_t> first;   ///< of a cell, into `found`
        std::vector<std::uint32_t> found; ///< triangles, by cell
    };
    std::uint64_t key(std::uint32_t instance, std::uint32_t face) const;
    Grid grid_of(std::span<const std::uint32_t> triangles) const;
    Vec3 shares_at(std::uint32_t triangle, const Vec2& uv) const;

    const SurfaceModel& model_;
    std::span<const Vec2> uv_;
    std::span<const SolvedTriangle> triangles_;
    std::unordered_map<std::uint64_t, Grid> grids_;
};

} // namespace keiko
