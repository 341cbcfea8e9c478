#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/model_mesh.h"
#include "keiko/geometry/model/patch_grid.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/radiosity/element_mesh.h"

#include <array>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace keiko {

/// Triangles of a model, bisected where they are wanted smaller. A triangle is cut across its
/// longest side. Before, its neighbour there is cut until that side is the longest of both
/// [Rivara1984]: within a face no corner comes to lie on the side of another triangle. New corners
/// lie on the exact surface.
class ElementSubdivision {
public:
    /// Most triangles that a mesh may have.
    static constexpr std::size_t most_triangles = 100000;

    /// Begins with the triangles of span_mesh() within `deviation` mm, above 0, of all instances.
    /// Faces that are `left_out`, one value a face, have none. Keeps a reference to the model.
    /// Throws FieldError beyond `most_triangles`, and Cancelled.
    ElementSubdivision(const SurfaceModel& model, double deviation,
                       const std::vector<bool>& left_out, const Job& job = {});

    /// The triangles; each is an element of its own until join() has been called.
    const ElementMesh& elements() const { return elements_; }
    /// Makes elements of triangles: the number of its own for each. Both halves of a triangle that
    /// is cut later belong to its element.
    void join(std::vector<std::uint32_t> elements) { elements_.elements = std::move(elements); }
    /// Cuts each triangle, and each that comes of it, as long as it is `wanted`. Returns the
    /// numbers of those that changed or are new, rising. Throws FieldError beyond `most_triangles`,
    /// and if a piece has no area.
    std::vector<std::uint32_t> cut(const std::function<bool(std::uint32_t triangle)>& wanted);
    /// The triangles with a common side, in a fixed order, each pair once.
    std::vector<std::array<std::uint32_t, 2>> neighbours() const;

private:
    using Sides = std::array<std::uint32_t, 2>; ///< triangles at a side; no_index: none

    static std::uint64_t key(std::uint32_t a, std::uint32_t b);
    void add_face(std::uint32_t instance, std::uint32_t face, const FaceMesh& triangles);
    void add_triangle(const std::array<std::uint32_t, 3>& corners, std::uint32_t face,
                      std::uint32_t instance);
    std::uint32_t add_corner(std::uint32_t instance, std::uint32_t face, const Vec2& uv);
    unsigned longest(std::uint32_t triangle) const;
    std::uint32_t across(std::uint32_t triangle, unsigned side) const;
    void replace(std::uint32_t a, std::uint32_t b, std::uint32_t old, std::uint32_t by);
    void bisect(std::uint32_t triangle, std::vector<std::uint32_t>& changed);
    void split(std::uint32_t triangle, unsigned side, std::uint32_t middle,
               std::vector<std::uint32_t>& changed);

    const SurfaceModel& model_;
    std::vector<PatchGrid> grids_; ///< a face
    ElementMesh elements_;
    std::unordered_map<std::uint64_t, Sides> sides_; ///< by their ends
};

} // namespace keiko
