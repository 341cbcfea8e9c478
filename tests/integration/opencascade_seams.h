#pragma once

#include "keiko/math/vec.h"

#include <memory>
#include <optional>
#include <vector>

class TopoDS_Shape;

namespace keiko::test {

/// A place of a border, and how another border faces it, as OpenCASCADE has both.
struct PeerSeamPlace {
    std::size_t border_a = 0, border_b = 0; ///< into OpenCascadeSeams
    double t = 0, s = 0;                    ///< parameters of their p-curves
    Vec3 place{0}, foot{0};                 ///< on either border, mm
    double gap = 0;                         ///< mm
    double slip = 0;             ///< mm along border b by which the foot is not square to it
    double from_end = 0;         ///< mm of either point from the nearer end of its border
    double turn = 0;             ///< degrees between the borders, 0 to 90
    std::optional<double> angle; ///< degrees, 0 smooth to 180 folded back; needs both normals
    double curvature_a = 0, curvature_b = 0; ///< 1/mm, across the seam, normals on one side
    bool is_shared = false;                  ///< both borders are uses of one edge of the file
};

/// Seams of a CAD file measured by OpenCASCADE alone: by BRepAdaptor_Surface along the p-curves
/// of its edges. Nothing of Keiko's geometry takes part.
class OpenCascadeSeams {
public:
    explicit OpenCascadeSeams(const TopoDS_Shape& shape);
    ~OpenCascadeSeams();

    std::size_t border_count() const;
    /// The face of a border, in the order of the shape.
    std::size_t face_of(std::size_t border) const;
    std::size_t face_count() const;

    /// Nearest points of borders that face a border: those of other faces within `reach` mm, and
    /// the other use of an edge that closes its own face. One of each, at `count` uniform steps of
    /// each of the border's smooth pieces.
    std::vector<PeerSeamPlace> sample(std::size_t border, int count, double reach) const;
    /// Nearest points as `sample` finds them, at the place of the border that is nearest to a
    /// point.
    std::vector<PeerSeamPlace> at(std::size_t border, const Vec3& point, double reach) const;
    /// mm, of a point from a border; of one outside the border's box from that.
    double distance(std::size_t border, const Vec3& point) const;

private:
    std::vector<PeerSeamPlace> facing(std::size_t border, double t, double reach) const;

    struct Borders;
    std::unique_ptr<Borders> borders_;
};

} // namespace keiko::test
