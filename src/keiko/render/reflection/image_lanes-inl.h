// Compiled once for each instruction set by lamp_kernels.cpp.
#if defined(KEIKO_RENDER_IMAGE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_RENDER_IMAGE_LANES_INL_H
#undef KEIKO_RENDER_IMAGE_LANES_INL_H
#else
#define KEIKO_RENDER_IMAGE_LANES_INL_H
#endif

#include "keiko/intersect/kernels/lanes-inl.h"
#include "keiko/light/tubes/c_plane.h"
#include "keiko/render/reflection/reflected_grid.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

using Real = hn::Vec<Wide>;   ///< A number a lane.
using Truth = hn::Mask<Wide>; ///< True or false a lane.

/// One number in all lanes.
inline Real real(double x) {
    return hn::Set(Wide(), x);
}

/// Vectors of space, one a lane: in the world, or in a plane's frame.
struct VectorLanes {
    Real x, y, z; ///< coordinates

    /// Sum, lane by lane.
    VectorLanes operator+(const VectorLanes& o) const {
        return {hn::Add(x, o.x), hn::Add(y, o.y), hn::Add(z, o.z)};
    }
    /// Difference, lane by lane.
    VectorLanes operator-(const VectorLanes& o) const {
        return {hn::Sub(x, o.x), hn::Sub(y, o.y), hn::Sub(z, o.z)};
    }
    /// This and s times another.
    VectorLanes plus(Real s, const VectorLanes& o) const {
        return {hn::MulAdd(s, o.x, x), hn::MulAdd(s, o.y, y), hn::MulAdd(s, o.z, z)};
    }
    VectorLanes plus(double s, const VectorLanes& o) const { return plus(real(s), o); }
    /// s times this.
    VectorLanes scaled(double s) const {
        return {hn::Mul(x, real(s)), hn::Mul(y, real(s)), hn::Mul(z, real(s))};
    }
    /// Squared length.
    Real length2() const { return hn::MulAdd(z, z, hn::MulAdd(y, y, hn::Mul(x, x))); }
    /// Euclidean length.
    Real length() const { return hn::Sqrt(length2()); }
};

/// A ray a lane, with its derivatives by the picture's x and y.
struct RayLanes {
    VectorLanes origin, direction;          ///< world, mm; directions of any length
    VectorLanes origin_dx, origin_dy;       ///< of the origin, mm a pixel
    VectorLanes direction_dx, direction_dy; ///< of the direction, a pixel
};

/// The axes of a plane.
class FrameLanes {
public:
    /// Axes of one plane in all lanes.
    explicit FrameLanes(const CPlaneFrame& frame)
        : origin_(every(frame.origin)),
          u_(every(frame.u)),
          v_(every(frame.v)),
          normal_(every(frame.normal)) {}

    /// Components of a world vector along the plane's axes and its normal.
    VectorLanes vector(const VectorLanes& w) const {
        return {dot(u_, w), dot(v_, w), dot(normal_, w)};
    }
    /// Coordinates of a world point in the plane's frame, mm.
    VectorLanes point(const VectorLanes& p) const { return vector(p - origin_); }
    /// The last component of vector().
    Real height(const VectorLanes& w) const { return dot(normal_, w); }

private:
    static VectorLanes every(const Vec3& a) { return {real(a.x), real(a.y), real(a.z)}; }
    static Real dot(const VectorLanes& a, const VectorLanes& b) {
        return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x)));
    }

    VectorLanes origin_, u_, v_, normal_;
};

/// (|x| + |y|) / 2.
inline Real half_sum(Real x, Real y) {
    return hn::Mul(real(0.5), hn::Add(hn::Abs(x), hn::Abs(y)));
}

/// Intersections of rays with a plane, in its frame, and their images on it.
struct ImageLanes {
    VectorLanes direction, at; ///< `at`: the place, without its height
    Real t;                    ///< parameter of the ray where it meets the plane
    Truth meets;               ///< the plane lies ahead, and the ray is not parallel to it
    VectorLanes dx, dy;        ///< derivatives of the rays where they meet the plane
    Real u_dx, v_dx, u_dy, v_dy, descent_x, descent_y; ///< Footprint

    /// Images of rays on a plane. Numbers of rays that do not meet it may be infinite or undefined.
    ImageLanes(const FrameLanes& frame, const RayLanes& rays)
        : direction(frame.vector(rays.direction)) {
        constexpr double parallel = 1e-12; // as in c_plane_lookup.cpp
        const VectorLanes from = frame.point(rays.origin);
        const Real per_z = hn::Div(real(1), direction.z);
        t = hn::Neg(hn::Div(from.z, direction.z));
        at = from.plus(t, direction);
        meets = hn::And(hn::Gt(t, real(0)),
                        hn::Gt(hn::Abs(direction.z), hn::Mul(real(parallel), direction.length())));
        dx = frame.vector(rays.origin_dx.plus(t, rays.direction_dx));
        dy = frame.vector(rays.origin_dy.plus(t, rays.direction_dy));
        const Real slope_u = hn::Mul(direction.x, per_z), slope_v = hn::Mul(direction.y, per_z);
        descent_x = hn::Mul(frame.height(rays.direction_dx), per_z);
        descent_y = hn::Mul(frame.height(rays.direction_dy), per_z);
        u_dx = hn::NegMulAdd(slope_u, dx.z, dx.x), v_dx = hn::NegMulAdd(slope_v, dx.z, dx.y);
        u_dy = hn::NegMulAdd(slope_u, dy.z, dy.x), v_dy = hn::NegMulAdd(slope_v, dy.z, dy.y);
    }
    /// Footprint::reach() along the lamps.
    Real reach_along() const { return widened(half_sum(u_dx, u_dy)); }
    /// Footprint::widened().
    Real widened(Real length) const {
        const Real least = hn::Sub(real(1), half_sum(descent_x, descent_y));
        return hn::IfThenElse(hn::Gt(least, real(0)), hn::Div(length, least), hn::Inf(Wide()));
    }
    /// True if no derivative moves the place in the plane.
    Truth is_point() const {
        const auto none = [](Real a, Real b) {
            return hn::And(hn::Eq(a, real(0)), hn::Eq(b, real(0)));
        };
        return hn::And(none(u_dx, v_dx), none(u_dy, v_dy));
    }
};

/// Room of an end of tubes, as in end_coverage.h.
inline Real end_room(const CPlaneFrame& frame, const VectorLanes& d) {
    return hn::Div(hn::Mul(real(frame.radius()), hn::Abs(d.x)), hn::Abs(d.z));
}

/// Vectors that begin at a number of the rays, for a vector of places from one on.
inline VectorLanes load_space(const ReflectedRays& rays, std::size_t number, std::size_t place) {
    const Wide d;
    return {hn::LoadU(d, rays.at(number, place)), hn::LoadU(d, rays.at(number + 1, place)),
            hn::LoadU(d, rays.at(number + 2, place))};
}

/// Rays of a vector of places from one on, with their derivatives.
inline RayLanes load_rays(const ReflectedRays& rays, std::size_t place) {
    const auto get = [&](std::size_t number) { return load_space(rays, number, place); };
    return {get(ReflectedRays::origin),       get(ReflectedRays::direction),
            get(ReflectedRays::origin_dx),    get(ReflectedRays::origin_dy),
            get(ReflectedRays::direction_dx), get(ReflectedRays::direction_dy)};
}

/// PixelRays, a pixel a lane.
struct PixelLanes {
    RayLanes centre, left, right, above, below; ///< of the pixels and their neighbours

    /// Rays of the pixels from a place on; rows of the picture are `width` long.
    PixelLanes(const ReflectedRays& rays, std::size_t place, std::size_t width)
        : centre(load_rays(rays, place)),
          left(load_rays(rays, place - 1)),
          right(load_rays(rays, place + 1)),
          above(load_rays(rays, place - width)),
          below(load_rays(rays, place + width)) {}
};

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
