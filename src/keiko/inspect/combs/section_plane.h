#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/bernstein/bernstein_field.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/inspect/basics/line_cells.h"
#include "keiko/inspect/basics/placed_face.h"

#include <array>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// The points p with normal . p = height; the normal is unit, the height mm.
struct SectionPlane {
    std::string name;     ///< as requested, "y=120"
    Vec3 normal{0, 1, 0}; ///< unit
    double height = 0;    ///< mm from the origin along the normal
};

/// "x=MM", "y=MM", "z=MM" or "A,B,C=MM": a direction and the height along it. Throws Error for
/// others.
SectionPlane section_plane(const std::string& text);

/// The least and the largest height of a body's control points along a unit direction, mm.
std::array<double, 2> heights(const SurfaceModel& model, const Vec3& along);

/// Curves in which a plane meets a patch: zeros of a polynomial of its parameters.
struct MeetingField {
    BernsteinField field;        ///< the polynomial
    std::vector<LineCell> cells; ///< that hold its zeros
    bool touching = false; ///< the plane is tangent along them; only zeros in the plane are curves
    bool on_side = false;  ///< along a side of the patch, where the next patch has them too
    bool by_u = false;     ///< of a slope: the parameter of its derivative; valid for the curve
                           ///< where it is steep
};

/// All of a patch that a plane meets.
struct PlaneMeeting {
    BernsteinField height;            ///< over the plane, mm, times the weight
    double tolerance = 0;             ///< of that height: places within it lie in the plane
    std::vector<MeetingField> fields; ///< of all curves
    bool within = false;              ///< all of the patch lies in the plane
    std::vector<Vec2> doubtful;       ///< places where the plane touches the patch, or may
    BernsteinField bend_u, bend_v;    ///< of the height, twice by u and by v; where it has slopes

    /// True if the slope by u, not that by v, represents the curve along which the plane touches at
    /// a place. The other slope has zeros that cross it where it runs along v.
    bool steep_by_u(const Vec2& at) const;
};

/// Curves in which a plane meets a patch. `view` is of the patch's own points. Places within
/// `tolerance` mm of the plane lie in it.
PlaneMeeting plane_meeting(const PlacedPatch& patch, const BezierPatchView& view,
                           const SectionPlane& plane, double tolerance);

} // namespace keiko
