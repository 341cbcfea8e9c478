#pragma once

#include "keiko/base/export.h"
#include "keiko/light/tubes/c_plane.h"
#include "keiko/math/jet.h"
#include "keiko/scene/camera.h"

#include <cmath>
#include <string_view>

namespace KEIKO_API keiko {

/// Kind of curves that are inspected on a surface.
enum class LineLook {
    reflection, ///< where the mirrored camera ray meets a line of the C-plane
    highlight,  ///< where the surface's normal meets it [BeierChen1994]; independent of the
                ///< viewpoint
    isophote    ///< where the normal keeps an angle to the C-plane's normal
};
/// "reflection", "highlight", "isophote"
std::string_view name_of(LineLook look);

/// Viewpoint of a body: a point, or a direction for orthographic cameras.
struct LineEye {
    Vec3 point{0};         ///< world, mm; unless parallel
    Vec3 direction{0};     ///< unit, of all view rays; 0: from the point
    bool parallel = false; ///< True for orthographic cameras.

    /// Viewpoint of a camera.
    explicit LineEye(const Camera& camera);
    /// Direction from the viewpoint towards a place; of any length.
    Vec3 towards(const Vec3& place) const { return parallel ? direction : place - point; }
};

/// A quotient of two smooth functions of a place and its normal; the normal need not be unit.
template <class T>
struct LineRatio {
    T above{}, below{}; ///< numerator and denominator
    T ahead{}; ///< above 0 where the ray, or the normal towards the eye, runs to the C-plane

    /// 0 on the line of the level, and smooth where the quotient has poles.
    T residual(double level) const { return above - below * level; }
};

/// The function on the surface whose level sets are the lines of one C-plane. It is the coordinate
/// v, mm from the plane's corner, at which the reflected ray or the normal meets the plane. For
/// isophotes it is the cosine of the angle between the normal and the plane's. See
/// docs/theory/reflection-lines.md.
class LineField {
public:
    /// Field of one C-plane for a body about the point `body`.
    LineField(LineLook look, const LineEye& eye, const CPlane& plane, const Vec3& body);

    /// Kind of its curves.
    LineLook look() const { return look_; }
    /// The C-plane.
    const CPlaneFrame& plane() const { return plane_; }
    /// The viewpoint.
    const LineEye& eye() const { return eye_; }

    /// The quotient for numbers, jets and models alike. `shift` moves the origin of v. `weight`: by
    /// which the place is multiplied, above 0; a number or, as it may vary, a T.
    template <class T, class Weight = double>
    LineRatio<T> ratio(const Triple<T>& place, const Triple<T>& normal, double shift = 0,
                       const Weight& weight = 1) const {
        using std::sqrt;
        if (look_ == LineLook::isophote)
            return {dot(normal, towards_lamps_) - sqrt(length2(normal)) * shift,
                    sqrt(length2(normal)), T(1.0)};
        const Triple<T> view = towards(place, weight);
        const bool mirror = look_ == LineLook::reflection;
        const Triple<T> ray =
            mirror ? view * length2(normal) - normal * (dot(view, normal) * 2.0) : normal;
        const Triple<T> from_corner = from(plane_.origin, place, weight);
        const T across = dot(ray, plane_.v), down = dot(ray, plane_.normal);
        const T height = dot(from_corner, plane_.normal);
        return {(dot(from_corner, plane_.v) - T(weight * shift)) * down - height * across,
                down * weight, mirror ? -height * down : height * down * dot(view, normal)};
    }

    /// Reflection of the C-plane at one place of the surface.
    struct Image {
        double value = 0;   ///< the field: v in mm, or a cosine
        double along = 0;   ///< mm along the lamps from the corner; 0 for isophotes
        double reach = 0;   ///< mm from the surface to the C-plane along the ray; 0 for isophotes
        bool faces = false; ///< the ray runs from the surface's visible side to the plane
    };
    /// Reflection at the place; the normal, of any length, is turned towards the viewpoint.
    Image image(const Vec3& place, const Vec3& normal) const;

    /// Seam angle in degrees that would move the field's value by `change` at a place with this
    /// image: the unit in which the limit of seams is given.
    double normal_turn(const Image& image, double change) const;

    /// Largest rate at which the field's value moves when the normal at a place turns. For lines of
    /// lamps it is in mm a radian: 2 D where a reflected ray of length D meets the C-plane at a
    /// right angle. For isophotes it is a cosine a radian.
    double turn_gain(const Vec3& place, const Vec3& normal) const;

private:
    /// A place, times its weight, from another one.
    template <class T, class Weight>
    static Triple<T> from(const Vec3& origin, const Triple<T>& place, const Weight& weight) {
        return {place.x - T(weight * origin.x), place.y - T(weight * origin.y),
                place.z - T(weight * origin.z)};
    }
    /// The camera ray to a place, times its weight unless it is parallel.
    template <class T, class Weight>
    Triple<T> towards(const Triple<T>& place, const Weight& weight) const {
        const Vec3& d = eye_.direction;
        return eye_.parallel ? Triple<T>{T(d.x), T(d.y), T(d.z)} : from(eye_.point, place, weight);
    }

    LineLook look_;
    LineEye eye_;
    CPlaneFrame plane_;
    Vec3 towards_lamps_; ///< unit normal of the C-plane, from the body to it
};

} // namespace keiko
