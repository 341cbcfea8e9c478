#pragma once

#include "keiko/geometry/rays/contour_arc.h"
#include "keiko/math/interval_set.h"
#include "keiko/math/vec.h"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace keiko {

/// One face beside a border curve.
struct BorderSide {
    /// Outer tangent plane at a parameter of the curve: weights of homogeneous coordinates.
    std::function<Vec4(double)> plane;
    /// Whether the face lies where the cross product of its outer normal and the curve's direction
    /// points: 1, else -1.
    int sense = 1;
};

/// A curve in space that ends one face or joins two at an edge.
struct BorderCurve {
    /// Place and derivative at a parameter of 0 to 1, in the axes of the planes.
    struct Point {
        Vec3 place{0}, along{0};
    };
    std::function<Point(double)> at;
    std::vector<double> kinks; ///< parameters in (0, 1) where it is not smooth, rising
    BorderSide own;
    std::optional<BorderSide> other;
    bool turns_at_begin = true, turns_at_end = true; ///< the border goes on with another direction
};

/// A border of a luminous body in pieces of conic sections, which from any point are arcs of the
/// outlines of its faces.
class ContourBorder {
public:
    /// Pieces are halved, twelve times at most, until they leave the curve by at most `deviation`,
    /// mm, at two places of each, and the faces turn little from node to node.
    ContourBorder(BorderCurve curve, double deviation);

    /// Arcs from a point in the axes of the curve. A face that turns its back and again its front
    /// to it between two nodes is not found to.
    void append_arcs(const Vec3& point, std::vector<ContourArc>& arcs) const;

private:
    static constexpr std::size_t nodes = 5; ///< along a piece, evenly
    using Planes = std::array<Vec4, nodes>;
    using Heights = std::array<double, nodes>; ///< of the viewpoint over them

    struct Piece {
        ParameterInterval part;      ///< of the curve
        std::array<Vec4, 3> control; ///< homogeneous
        Planes own, other;           ///< `other` without meaning where there is none
        bool turns_at_begin, turns_at_end;
    };
    Planes planes_along(const BorderSide& side, const ParameterInterval& part) const;
    void add_pieces(const ParameterInterval& part, double deviation, int depth);
    bool fits(const Piece& piece, double deviation) const;
    static Heights heights_over(const Planes& planes, const Vec3& point);
    /// Shares of a piece at which the viewpoint sees a face edge-on.
    std::vector<double> edge_on(const Piece& piece, const BorderSide& side, const Heights& heights,
                                const Vec3& point) const;
    /// Place at which the viewpoint passes from one side of a face to the other.
    struct Change {
        double t; ///< parameter of a piece's conic section
        bool of_own;
    };
    /// Changes along a piece in rising order, and its end.
    std::vector<Change> changes(const Piece& piece, const Vec3& point, const Heights& over_own,
                                const Heights& over_other) const;
    void append_arcs(const Piece& piece, const Vec3& point, std::vector<ContourArc>& arcs) const;

    BorderCurve curve_;
    std::vector<Piece> pieces_;
};

} // namespace keiko
