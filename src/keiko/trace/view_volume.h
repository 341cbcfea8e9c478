#pragma once

#include "keiko/math/bounds.h"
#include "keiko/trace/apex.h"
#include "keiko/trace/border_piece.h"
#include "keiko/trace/silhouette_piece.h"

#include <array>
#include <span>

namespace keiko {

/// The pyramid between an apex and all that it may be asked about (a prism for parallel light):
/// what lies outside hides nothing of it.
class ViewVolume {
public:
    /// `region` holds corners of a convex body around every segment to come.
    /// With `facing` only what lies on its side of the plane through the apex hides anything.
    ViewVolume(const Apex& apex, std::span<const Vec3> region,
               const std::optional<Vec3>& facing = {});

    /// False when the box is proved to lie outside.
    bool may_hold(const Box3& box) const;
    /// The same of a piece, whose parallelogram or control points are tighter than its box.
    bool may_hold(const SilhouettePiece& piece) const;
    bool may_hold(const BorderPiece& border) const;
    /// The same of a curve of degree 5 and all within `error` of it, and of a net; their points are
    /// relative to `center`.
    bool may_hold(const BorderPiece::Curve& curve, const Vec3& center, double error) const;
    bool may_hold(const HomogeneousNet& net, const Vec3& center) const;
    /// World box of the region itself.
    const Box3& region() const { return region_; }

private:
    /// The side where normal.x >= offset.
    struct HalfSpace {
        Vec3 normal{0}, size{0};       ///< `size`: magnitudes of the normal's components
        double offset = 0, length = 1; ///< of the normal
    };
    void add(const Vec3& normal, double offset);

    Box3 region_, hull_;
    std::array<HalfSpace, 7> half_spaces_;
    std::size_t count_ = 0;
};

} // namespace keiko
