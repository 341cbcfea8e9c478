#pragma once

#include "keiko/inspect/basics/patch_box.h"
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
    /// View of its own control points about the patch's middle, mm, which it must outlive.
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
    /// True if a place, world, mm, lies within three times the negligible length of such a side.
    bool is_at_tip(const Vec3& place) const;

private:
    PlacedPatch placed_;
    int degree_u_, degree_v_;
    FieldTriple field_;
    double negligible_; ///< mm
    std::vector<Vec3> tips_;
};

/// A part of a patch over a box of its parameters, with bounds of its normals.
class NormalCell {
public:
    /// The whole patch.
    explicit NormalCell(const NormalPatch& patch) : box_(patch.view()), field_(patch.field()) {}

    /// Box of the parameters of the patch.
    const Box2& uv() const { return box_.uv(); }
    /// mm, not less than the part's diameter.
    double size() const;
    /// True if all of its normals are proved to be within 90 degrees of one direction: it is
    /// regular and does not turn over.
    bool is_regular() const;
    /// Radians about the mean of its normals within which they are all proved to lie; pi if they
    /// are not proved to be within a right angle of it.
    double cone() const;
    /// A lower bound of n . axis, n being its unit normals and the axis unit; -1 to 1. nullopt if
    /// the normals are not proved to be within 90 degrees of one direction.
    std::optional<double> smallest_sine(const Vec3& axis) const;
    /// Turn of the normals from side to side along u (`by_u`) or v, radians.
    double turn(bool by_u) const;
    /// Extents along u and v, mm.
    std::array<double, 2> extents() const;
    /// Two corners whose normals differ by more than 90 degrees, in the patch's parameters.
    std::optional<std::array<Vec2, 2>> turned_corners() const;
    /// Halves across u or v. The cell is cut where its normals turn more, until that side is at
    /// most `negligible` mm long; a `turned` cell at its longer side.
    std::array<NormalCell, 2> halves(bool turned, double negligible) const;
    /// Halves across u (`by_u`) or v.
    std::array<NormalCell, 2> halves_across(bool by_u) const;

private:
    NormalCell(PatchBox box, FieldTriple field) : box_(std::move(box)), field_(std::move(field)) {}

    Vec3 coefficient(int i, int j) const {
        return {field_[0].at(i, j), field_[1].at(i, j), field_[2].at(i, j)};
    }
    int last(bool by_u) const { return by_u ? field_[0].degree_u() : field_[0].degree_v(); }
    Vec3 sum() const;        ///< of the coefficients
    double rounding() const; ///< of a coefficient's product with a unit vector

    PatchBox box_;
    FieldTriple field_;
};

} // namespace keiko
