#pragma once

#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/inspect/seams/seam_sides.h"

#include <optional>
#include <vector>

namespace keiko {

/// A straight piece of the polyline of a side of a seam; world, mm.
struct SideChord {
    std::uint32_t side = 0;      ///< into the sides of its face
    double t_from = 0, t_to = 0; ///< parameters of the border
    Vec3 from{0};                ///< its begin
    Vec3 to{0};                  ///< its end

    /// mm.
    double length() const { return (to - from).length(); }
    /// Parameter of the border at a share of it, 0 at `from` and 1 at `to`.
    double t(double share) const { return t_from + share * (t_to - t_from); }
    /// Box around it.
    Box3 box() const {
        Box3 box;
        box.extend(from);
        box.extend(to);
        return box;
    }
};

/// The chords of a side, which has this number, within 0.002 mm of it.
std::vector<SideChord> chords_of(const SeamSide& side, std::uint32_t number);

/// The part of `chord` that runs beside `other`: from each of its places the foot of the
/// perpendicular on the line of `other` lies on `other`, at most `reach` mm away. Shares of
/// `chord`; nullopt if there is none, or if the chords diverge by more than `parallel_borders`.
std::optional<ParameterInterval> part_beside(const SideChord& chord, const SideChord& other,
                                             double reach);

/// Places of two sides of seams that face each other over the material of one face.
struct StripPlace {
    BoundaryFrame near, far;    ///< of the borders; world
    double t_far = 0;           ///< parameter of the far border
    std::uint32_t side_far = 0; ///< into the sides of the face

    /// mm, straight across.
    double width() const { return (far.position - near.position).length(); }
};

/// Sides of seams of one placed face, and the material between them.
class FaceStrips {
public:
    /// Keeps references to the model and the sides.
    FaceStrips(const SurfaceModel& model, const PlacedFace& face,
               const std::vector<SeamSide>& sides);

    /// The sides of the face.
    const std::vector<SeamSide>& sides() const { return sides_; }
    /// The chords of all sides, side after side.
    const std::vector<SideChord>& chords() const { return chords_; }
    /// Indices of the chords that a box overlaps.
    std::vector<std::uint32_t> near(const Box3& box) const { return tree_.overlapping(box); }
    /// The place of the side of chord `to` that faces a place of a border within `reach` mm;
    /// nullopt if there is none, or no material between them.
    std::optional<StripPlace> across(const SurfaceCurve& border, double t, const SideChord& to,
                                     double reach) const;
    /// The nearest such place of any side that runs parallel there and stops a way over the
    /// surface: of a border, or inside the face if it does not lead on.
    std::optional<StripPlace> nearest(const SurfaceCurve& border, double t, double reach) const;

private:
    std::vector<Box3> list_chords();
    bool is_material_between(const StripPlace& at, const Vec2& begin, const Vec2& end) const;

    const SurfaceModel& model_;
    const std::vector<SeamSide>& sides_;
    PlacedFace face_;
    std::vector<SideChord> chords_;
    BoxTree tree_;
    KnottedFace surface_;
};

/// The parameter of the other side of a seam that faces a place of a side.
double parameter_beyond(const SeamSide& side, double t, const Vec3& place);

} // namespace keiko
