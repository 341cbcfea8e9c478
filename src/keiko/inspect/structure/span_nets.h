#pragma once

#include "keiko/geometry/bezier/space_curve.h"
#include "keiko/inspect/basics/placed_face.h"

#include <array>
#include <cstdint>
#include <vector>

namespace keiko {

/// Control net of a knot span of a face as placed, its control points about its middle.
struct SpanNet {
    const Patch* patch; ///< of the model
    PlacedPatch placed; ///< its control points

    /// Number of control points along u.
    std::size_t count_u() const { return patch->degree_u + std::size_t{1}; }
    /// Number of control points along v.
    std::size_t count_v() const { return patch->degree_v + std::size_t{1}; }
    /// Control point i in u, j in v; homogeneous, about the middle.
    const Vec4& point(std::size_t i, std::size_t j) const {
        return placed.points[i * count_v() + j];
    }
    /// The row of control points along u with index j in v.
    CurvePoints along_u(std::size_t j) const;
    /// The row of control points along v with index i in u.
    CurvePoints along_v(std::size_t i) const;
    /// All rows along u (`in_u`) or v, side by side.
    std::vector<CurvePoints> rows(bool in_u) const;
    /// The edges v = 0, v = 1, u = 0 and u = 1.
    std::array<CurvePoints, 4> edges() const {
        return {along_u(0), along_u(count_v() - 1), along_v(0), along_v(count_u() - 1)};
    }
    /// mm: control points that are nearer to each other are one.
    double coincidence() const { return 16 * placed.rounding; }
    /// A place about the middle in world coordinates.
    Vec3 world(const Vec3& point) const { return point + placed.middle; }
};

/// The nets of all spans that a face reaches into, as its instance places them.
std::vector<SpanNet> span_nets(const SurfaceModel& model, std::uint32_t instance, const Face& face);

/// True if all control points of a row are one, to within `coincidence` mm.
bool is_point(const CurvePoints& row, double coincidence);

} // namespace keiko
