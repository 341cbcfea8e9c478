#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/rays/ray.h"
#include "keiko/light/tubes/c_plane.h"
#include "keiko/math/bounds.h"
#include "keiko/scene/camera.h"
#include "keiko/scene/symmetry.h"

#include <optional>
#include <span>

namespace KEIKO_API keiko {

/// Orthonormal coordinates of a plane for lamps: u along them, v across, mm.
struct PlaneFrame {
    Vec3 origin{0};              ///< world, mm
    Vec3 u{1, 0, 0}, v{0, 1, 0}; ///< unit, at right angles

    /// Unit normal, towards the side of positive heights.
    Vec3 normal() const { return u.cross(v); }
    /// Point of the world at a place of the plane, mm.
    Vec3 at(const Vec2& place) const { return origin + u * place.x + v * place.y; }
    /// Place of the foot of a point, and its height above the plane.
    Vec2 place(const Vec3& point) const {
        return {(point - origin).dot(u), (point - origin).dot(v)};
    }
    /// Height of a point above the plane, mm.
    double height(const Vec3& point) const { return (point - origin).dot(normal()); }
    /// The frame turned about its origin from u towards v.
    PlaneFrame turned(double radians) const;
};

/// The frame of a C-plane's corner, u and v.
PlaneFrame frame_of(const CPlane& plane);

/// Intersection of a ray with a plane.
struct PlaneHit {
    Vec2 place{0};     ///< mm, in the plane's coordinates
    double t = 0;      ///< parameter of the ray
    double cosine = 0; ///< of the angle of incidence, above 0
    /// Change of u and v with the picture's x and y, per pixel, if the ray has differentials.
    struct Gradients {
        Vec2 u{0}, v{0}; ///< by the picture's x and y, mm a pixel
    };
    std::optional<Gradients> gradients; ///< nullopt without differentials
};

/// Intersection of a ray with the plane; nullopt for rays that point away from the plane or along
/// it.
std::optional<PlaneHit> meet(const PlaneFrame& frame, const Ray& ray);

/// Place where the segment from a to b crosses the plane, if it does.
std::optional<Vec2> crossing(const PlaneFrame& frame, const Vec3& a, const Vec3& b);

/// True if a plane for lamps is its own mirror image, with u and v along the mirror or square to
/// it.
bool is_own_image(const PlaneFrame& frame, const MirrorPlane& mirror);
/// The image of a frame.
PlaneFrame image_of(const PlaneFrame& frame, const MirrorPlane& mirror);
/// The smallest symmetric rectangle that holds another, on a frame that is its own image.
Box2 symmetric_extent(const PlaneFrame& frame, const Box2& extent, const MirrorPlane& mirror);

/// True if a camera's picture of a symmetric scene is its own mirror image: its eye lies on the
/// mirror, and so do its axes except one.
bool is_own_image(const Camera& camera, const MirrorPlane& mirror);

} // namespace keiko
