#pragma once

#include "keiko/inspect/overlaps/face_sheet.h"
#include "keiko/math/bounds.h"

#include <array>
#include <memory>
#include <vector>

namespace keiko {

/// A piece of a sheet with the hull of its points, and its halves, which are made on first use.
class SheetCell {
public:
    /// The piece of a sheet over a box of (s, t) in its domain. Keeps a reference to the sheet.
    SheetCell(const FaceSheet& sheet, const Box2& box);

    /// In (s, t).
    const Box2& box() const { return box_; }
    /// False if trims have removed all of its patches.
    bool has_patches() const { return !points_.empty(); }
    /// Holds the piece; mm about the sheet's origin.
    const Box3& hull() const { return hull_; }
    /// mm: the diagonal of the hull.
    double size() const { return hull_.size(); }
    /// Its part of a patch; nullptr if it reaches into several.
    const FaceSheet::Part* only_part() const {
        return parts_.size() == 1 ? parts_.data() : nullptr;
    }
    /// Its parts of patches.
    const std::vector<FaceSheet::Part>& parts() const { return parts_; }
    /// True if a plane keeps the two pieces more than `distance` mm apart.
    bool is_apart(const SheetCell& other, double distance) const;
    /// The axis, s (0) or t (1), in which it turns more, or is longer.
    unsigned longer_axis() const;
    /// Its two halves along an axis.
    std::array<SheetCell*, 2> halves(unsigned axis);

private:
    const FaceSheet& sheet_;
    Box2 box_;
    std::vector<FaceSheet::Part> parts_;
    std::vector<Vec3> points_; ///< whose convex hull holds the piece
    Box3 hull_;
    Vec3 normal_{0};                                                  ///< mean, unit, or 0
    std::array<std::array<std::unique_ptr<SheetCell>, 2>, 2> halves_; ///< by axis
};

} // namespace keiko
