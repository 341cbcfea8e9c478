// Compiled once for each instruction set by sub_patch_kernels.cpp.
#if defined(KEIKO_INTERSECT_FRAME_RAYS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef KEIKO_INTERSECT_FRAME_RAYS_INL_H
#undef KEIKO_INTERSECT_FRAME_RAYS_INL_H
#else
#define KEIKO_INTERSECT_FRAME_RAYS_INL_H
#endif

#include "keiko/intersect/kernels/lanes-inl.h"
#include "keiko/intersect/kernels/sub_patch_jet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace keiko::HWY_NAMESPACE {

/// Boxes of a sub-patch's [-1, 1]^2, one a lane.
template <class V>
struct Boxes {
    V x, y;           ///< middle
    V half_x, half_y; ///< half size, negative for an empty box
};

/// Two planes through each ray, as functions of a sub-patch's homogeneous components: the ray meets
/// the sub-patch where both vanish.
template <class V>
struct PlanePairs {
    std::array<std::array<V, 4>, 2> weights; ///< of the four components, for each plane
    std::array<V, 2> bend;                   ///< bounds of |xx| + 2 |xy| + |yy| over the sub-patch
    std::array<V, 2> noise;                  ///< bounds of the functions' errors
};

/// Rays in a sub-patch's frame, for any angle between them.
template <class D>
class FrameRays {
    using V = hn::Vec<D>;

public:
    /// Rays of the vector of lanes that begins at `lane`, in the frame of a sub-patch.
    FrameRays(const RayPacket& rays, std::size_t lane, const PackedSubPatch& sub_patch) {
        const Space<V> start = load(d_, rays.start, lane);
        const Space<V> along = load(d_, rays.direction, lane);
        const Space<V> center{number(sub_patch.center[0]), number(sub_patch.center[1]),
                              number(sub_patch.center[2])};
        const Space<V> to_center = difference(center, start);
        foot_s_ = product(to_center, along);
        foot_ = in_frame(sub_patch, difference(scaled(along, foot_s_), to_center));
        direction_ = in_frame(sub_patch, along);
        // The rounding of the foot point is that of the way there, and of the rows' turning it. The
        // sub-patch's own blur has room for the way from there to a root, no longer than the
        // sub-patch.
        const V way = hn::Add(hn::Abs(foot_s_), hn::Sqrt(square(to_center)));
        blur_ = hn::Add(hn::Add(hn::Load(d_, rays.error.data() + lane), number(sub_patch.blur)),
                        hn::Mul(number(2 * ray_rounding), way));
    }

    /// One plane holds the frame's normal, the other lies as flat over the sub-patch as the ray.
    PlanePairs<V> planes(const PackedSubPatch& sub_patch) const {
        const auto& [x, y, z] = direction_;
        const V over = hn::Sqrt(hn::Add(hn::Mul(x, x), hn::Mul(y, y)));
        const V length = hn::Sqrt(square(direction_));
        // A ray along the normal has no direction over the sub-patch; any will do.
        const auto slanted = hn::Gt(over, number(0));
        const V turn_x = hn::IfThenElse(slanted, hn::Div(x, over), number(1));
        const V turn_y = hn::IfThenElse(slanted, hn::Div(y, over), number(0));
        const V rise = hn::Div(z, length);
        PlanePairs<V> planes;
        set_plane(planes, sub_patch, 0,
                  {hn::Mul(turn_x, rise), hn::Mul(turn_y, rise), hn::Neg(hn::Div(over, length))});
        set_plane(planes, sub_patch, 1, {hn::Neg(turn_y), turn_x, number(0)});
        return planes;
    }

    /// The part of the sub-patch that each ray can meet, by the two strips around the place where
    /// it meets the frame's plane; a negative half width where there is none.
    Boxes<V> reachable(const PackedSubPatch& sub_patch) const {
        // Lower rays meet the plane too far off, or not at all.
        constexpr double lowest = 1e-3;
        const V length = hn::Sqrt(square(direction_));
        const auto meets = hn::Gt(hn::Abs(direction_[2]), hn::Mul(number(lowest), length));
        Boxes<V> boxes;
        set_range(sub_patch, 0, meets, boxes.x, boxes.half_x);
        set_range(sub_patch, 1, meets, boxes.y, boxes.half_y);
        return boxes;
    }

    /// Distance along the ray of the place with these components, which is near it.
    V s_at(const std::array<V, 4>& components) const {
        const Space<V> place{hn::Div(components[0], components[3]),
                             hn::Div(components[1], components[3]),
                             hn::Div(components[2], components[3])};
        const V beyond = product(difference(place, foot_), direction_);
        return hn::Add(foot_s_, hn::Div(beyond, square(direction_)));
    }

private:
    static V number(double x) { return hn::Set(d_, x); }

    static Space<V> in_frame(const PackedSubPatch& sub_patch, const Space<V>& v) {
        const auto row = [&](std::size_t r) {
            return product({number(sub_patch.rows[r][0]), number(sub_patch.rows[r][1]),
                            number(sub_patch.rows[r][2])},
                           v);
        };
        return {row(0), row(1), row(2)};
    }

    void set_plane(PlanePairs<V>& planes, const PackedSubPatch& sub_patch, std::size_t which,
                   const Space<V>& normal) const {
        const V constant = hn::Neg(product(normal, foot_));
        V bend = number(0), noise = number(0);
        for (std::size_t k = 0; k < 3; ++k) {
            const V share = hn::Abs(normal[k]);
            bend = hn::MulAdd(share, number(sub_patch.bend[k]), bend);
            const V blur =
                hn::Mul(number(sub_patch.row_length[k] * (1 + sub_patch.value[3])), blur_);
            noise = hn::MulAdd(share, blur, noise);
        }
        planes.weights[which] = {normal[0], normal[1], normal[2], constant};
        // The constant is that of every place of the ray, so that of a root on the sub-patch: below
        // 2, as the sub-patch's own blur takes it to be.
        planes.bend[which] = hn::MulAdd(hn::Abs(constant), number(sub_patch.bend[3]), bend);
        planes.noise[which] = noise;
    }

    void set_range(const PackedSubPatch& sub_patch, std::size_t k, hn::Mask<D> meets, V& middle,
                   V& half) const {
        const V turn = hn::Div(direction_[k], direction_[2]), steep = hn::Abs(turn);
        const V place = hn::NegMulAdd(foot_[2], turn, foot_[k]);
        const V blur = hn::Mul(blur_, hn::MulAdd(steep, number(sub_patch.row_length[2]),
                                                 number(sub_patch.row_length[k])));
        V strip = hn::MulAdd(steep, number(sub_patch.value[2]), number(sub_patch.value[k]));
        strip = hn::Add(hn::MulAdd(hn::Abs(place), number(sub_patch.value[3]), strip), blur);
        strip = hn::Mul(strip, number(1 + 1e-9));
        const V low = hn::IfThenElse(meets, hn::Max(number(-1), hn::Sub(place, strip)), number(-1));
        const V high = hn::IfThenElse(meets, hn::Min(number(1), hn::Add(place, strip)), number(1));
        middle = hn::Mul(number(0.5), hn::Add(low, high));
        // What the middle's rounding may leave out.
        half = hn::MulAdd(number(0.5), hn::Sub(high, low), number(1e-15));
    }

    static constexpr D d_{};
    Space<V> foot_;      ///< the place of the ray nearest to the frame's centre
    Space<V> direction_; ///< for one mm
    V foot_s_;           ///< mm along the ray from its start
    V blur_;             ///< mm, bound of the distance of ray and surface to the exact ones
};

} // namespace keiko::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
