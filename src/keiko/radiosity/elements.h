#pragma once

#include "keiko/geometry/model/patch_grid.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/geometry/rays/ray.h"
#include "keiko/radiosity/element_mesh.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// A point that light arrives at, from the side of its normal.
struct LightPoint {
    Vec3 position{0}, normal{0, 0, 1}; ///< world, mm; unit
    std::optional<Root> root{};        ///< of a point on a surface: what its rays leave out
};

/// A point of an element with the part of the element's area that it stands for.
struct ElementPoint {
    LightPoint at;    ///< on the exact surface, with the normal of the front
    double share = 0; ///< of the element's area, above 0
};

/// The elements of a mesh on the exact surfaces of its model.
class Elements {
public:
    /// Reads ElementMesh::elements. Keeps references to both.
    Elements(const SurfaceModel& model, const ElementMesh& mesh);

    /// Number of elements. Their faces are numbered from 0: all fronts, then all backs.
    std::size_t size() const { return first_.size() - 1; }
    /// The triangles.
    const ElementMesh& mesh() const { return mesh_; }
    /// The triangles of an element, rising.
    std::span<const std::uint32_t> triangles(std::size_t element) const;
    /// Area of an element in its triangles, mm2.
    double area(std::size_t element) const { return areas_[element]; }
    /// Diagonal of the box of an element, or the longest side of its only triangle, mm.
    double extent(std::size_t element) const;
    /// The point of an element at a place of the unit square. Equal areas of the square are equal
    /// areas of the element.
    LightPoint point(std::size_t element, const Vec2& place) const;
    /// Points spread over an element, two to six of them, or one if its extent is below `small` mm;
    /// shares sum to 1.
    std::vector<ElementPoint> spread(std::size_t element, double small) const;
    /// The point of a triangle with these shares of its corners.
    LightPoint point_of_triangle(std::uint32_t triangle, const Vec3& shares) const;

private:
    const SurfaceModel& model_;
    const ElementMesh& mesh_;
    std::vector<PatchGrid> grids_;         ///< a face
    std::vector<std::uint32_t> triangles_; ///< by element
    std::vector<std::size_t> first_;       ///< of an element, into triangles_
    std::vector<double> areas_;            ///< an element
};

} // namespace keiko
