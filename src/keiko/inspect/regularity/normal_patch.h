#pragma once

#include "keiko/inspect/basics/patch_fields.h"
#include "keiko/inspect/basics/placed_face.h"

#include <optional>
#include <vector>

namespace keiko {

/// The normals of a placed patch of a face.
class NormalPatch {
public:
    /// `negligible` in mm: a side up to this length is a point.
    NormalPatch(const SurfaceModel& model, std::uint32_t patch, const Affine& placed,
                double negligible);

    std::uint32_t index() const { return placed_.index; } ///< into SurfaceModel::patches
    BezierPatchView view() const { return {degree_u_, degree_v_, placed_.points}; }
    const Box3& box() const { return placed_.box; } ///< world, of the control points
    /// normal_field() without the sides along which it is 0.
    const FieldTriple& field() const { return field_; }
    /// World, mm.
    Vec3 position(const Vec2& uv) const;
    /// Unit normal along du x dv, its limit at collapsed sides; nullopt if it is 0 to within
    /// rounding.
    std::optional<Vec3> normal(const Vec2& uv) const;
    /// The sides that are points: world, mm.
    const std::vector<Vec3>& tips() const { return tips_; }

private:
    PlacedPatch placed_;
    int degree_u_, degree_v_;
    FieldTriple field_;
    std::vector<Vec3> tips_;
};

} // namespace keiko
