#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/bezier/bezier.h"
#include "keiko/inspect/basics/patch_lines.h"
#include "keiko/inspect/combs/section_plane.h"

#include <functional>
#include <optional>
#include <vector>

namespace KEIKO_API keiko {

/// Curvature of a curve on a surface at one place.
struct CurveBend {
    double curvature = 0; ///< 1/mm, of the section itself, or of an iso-curve's normal section
    double normal_curvature = 0; ///< 1/mm, of the surface along the curve
    /// Unit vector to which the curve bends where its curvature is positive: the surface's normal,
    /// or the normalised part of it in the plane of a section.
    Vec3 towards{0};
};

/// Reverses the side to which the curvature refers.
inline void turn_over(CurveBend& bend) {
    bend.curvature = -bend.curvature, bend.towards = -bend.towards;
}

/// The curvature of a curve at a place of the surface with the unit normal `outward`, along u' and
/// v' of `direction`: the normal curvature II / I.
std::optional<CurveBend> normal_bend(const SurfaceDerivatives& s, const Vec3& outward,
                                     const Vec2& direction);

/// The curvature of the curve in which a plane with the unit normal `plane` cuts the surface. It is
/// k / cos (Meusnier), with k the normal curvature along the curve and the angle between the
/// surface's normal and the plane. nullopt if the plane is almost tangent to the surface.
std::optional<CurveBend> section_bend(const SurfaceDerivatives& s, const Vec3& outward,
                                      const Vec3& plane);

/// The curve's own curvature in a plane that is tangent to the surface all along it, where the
/// surface is as flat as the plane. `direction` is its direction in u and v, `turning` the
/// derivative of that along it. `towards` is to the left, viewed from the side that the plane's
/// unit normal points to. nullopt if the direction is 0.
std::optional<CurveBend> touching_bend(const SurfaceDerivatives& s, const Vec3& plane,
                                       const Vec2& direction, const Vec2& turning);

/// A point of a curve, and how the curve bends there.
struct CombSample {
    Vec3 place{0};    ///< world, mm, on the exact surface
    double along = 0; ///< mm from the beginning of the curve, over its chords
    CurveBend bend;   ///< with respect to the face's outward normal
};

/// The part of a curve on one patch; curvatures may jump from one piece to the next.
struct CombPiece {
    std::uint32_t instance = 0, face = 0, patch = 0; ///< into the model's arrays
    bool on_border = false; ///< of the patch or the face: its neighbour there has the curve as well
    /// True if the plane is tangent to the surface all along. The curvature is then the curve's
    /// own, positive to the left of the direction of the samples, viewed from the side that the
    /// plane's normal points to.
    bool touching = false;
    std::vector<CombSample> samples{}; ///< from end to end
};

/// Options of comb_curves.
struct CombOptions {
    std::vector<SectionPlane> planes; ///< of the sections
    int iso_curves = 0;        ///< of each face in either direction, uniform over its parameters
    double chord_error = 0.01; ///< mm
    /// Largest deviation of a curvature from the straight line between two samples, as a share of
    /// the curve's largest curvature, which counts as at least 1 / the body's size.
    double tolerance = 0.01;
    double join = 0.5; ///< mm, over which sections continue from face to face
};

/// Curvature of a curve at a place of it on a patch; nullopt if it cannot be computed.
using BendAt = std::function<std::optional<CurveBend>(const SurfaceDerivatives&, const Vec2& uv,
                                                      const Vec3& normal)>;

/// Options of comb_samples.
struct CombSampling {
    double tolerance = 0.01;   ///< as CombOptions::tolerance
    double chord_error = 0.01; ///< mm: distance from poles to which combs extend
    double size = 1;           ///< of the body, mm
};

/// A line's comb: samples at its points and between them, until straight lines between samples are
/// accurate enough. `view` is of the patch's own points.
std::vector<CombSample> comb_samples(const BezierPatchView& view, const ZeroFunction& zeros,
                                     const PatchLine& line, const BendAt& bend,
                                     const CombSampling& sampling);

} // namespace keiko
