#pragma once

#include "keiko/geometry/bezier/bezier.h"
#include "keiko/geometry/rays/ray.h"
#include "keiko/math/affine.h"

#include <array>
#include <cstdint>
#include <limits>

namespace keiko {

/// A ray as it is traced: its start moved up to the ball around the scene, so that what single
/// precision and cancellation cost stays small against the scene however far off the eye is.
struct TracedRay {
    const Ray* ray = nullptr; ///< as given
    Vec3 start{0};            ///< world, mm
    Vec3 direction{0};        ///< unit
    double t_start = 0;       ///< of the ray, at `start`
    double speed = 1;         ///< mm in one unit of t
    double error = 0;         ///< mm, bound of the distance of `start` to the exact ray
    /// mm from `start`: the part of [t_min, t_max] within the ball, wider by at most `slack`, the
    /// rounding between s and t.
    double low = 0, high = 0, slack = 0;

    /// Parameter of the given ray at a distance of `s` mm from `start`.
    double t_at(double s) const { return t_start + s / speed; }
};

/// Rounding error of the place where a ray meets a sub-patch's frame, for each mm of the way there.
/// Let u = 2^-53 be the unit roundoff. Then start - center costs u, each product of a row 3 u,
/// the unit direction 3 u and its rows 3 u more, the quotients 2 u, the last step 1 u. The sum is
/// 13 u of numbers no larger than the way, times a weight of at most 1.5. 32 u leaves room for
/// products.
constexpr double ray_rounding = 16 * std::numeric_limits<double>::epsilon();

/// Set of lanes of a RayPacket, one bit each.
using LaneMask = std::uint32_t;

/// Up to 16 rays as the kernels read them: TracedRay, field for field.
struct alignas(64) RayPacket {
    static constexpr std::size_t capacity = 16; ///< most rays of a packet
    /// One value of each ray.
    template <class T>
    using Lanes = std::array<T, capacity>;

    std::array<Lanes<double>, 3> start;     ///< x, y, z, world, mm
    std::array<Lanes<double>, 3> direction; ///< x, y, z, unit
    Lanes<double> low, high;                ///< mm from the start; `high` falls as hits are found
    Lanes<double> t_start;                  ///< parameter of the given ray at the start
    Lanes<double> speed;                    ///< mm in one unit of t
    Lanes<double> error;                    ///< mm, bound of the start's distance to the exact ray
    Lanes<double> slack;                    ///< mm, rounding between s and t
    Lanes<double> blur;     ///< mm: `error`, and rounding over any way within the scene
    Lanes<const Ray*> rays; ///< as given
    std::size_t count = 0;  ///< rays in use, in the first lanes
    LaneMask active = 0;    ///< rays that come near the scene
    /// Whether they go through the scene so much together that a packet shares most of its steps.
    bool coherent = false;

    /// Parameter of a lane's given ray at a distance of `s` mm from its start.
    double t_at(std::size_t lane, double s) const { return t_start[lane] + s / speed[lane]; }
    /// One lane as a ray of its own.
    TracedRay ray(std::size_t lane) const {
        return {rays[lane],
                Vec3(start[0][lane], start[1][lane], start[2][lane]),
                Vec3(direction[0][lane], direction[1][lane], direction[2][lane]),
                t_start[lane],
                speed[lane],
                error[lane],
                low[lane],
                high[lane],
                slack[lane]};
    }
};

/// The ball around a scene.
struct SceneBall {
    Vec3 center{0};    ///< world, mm
    double radius = 0; ///< mm
};

/// Up to 8 hits, each on a sub-patch of its own, whose surfaces are evaluated side by side.
struct alignas(64) HitPacket {
    static constexpr std::size_t capacity = 8; ///< most hits of a packet
    /// One value of each hit.
    template <class T>
    using Lanes = std::array<T, capacity>;
    using Vectors = std::array<Lanes<double>, 3>; ///< One vector of each hit: x, y, z.

    /// Vector of one lane.
    static Vec3 at(const Vectors& vectors, std::size_t lane) {
        return {vectors[0][lane], vectors[1][lane], vectors[2][lane]};
    }

    // What is asked.
    Lanes<double> u{}, v{};             ///< on the sub-patch, [0, 1]
    Lanes<double> per_u{}, per_v{};     ///< how fast they run with the patch's own parameters
    Lanes<double> error_u{}, error_v{}; ///< in patch parameters
    Lanes<double> weight{};             ///< of all control points, above 0; 0: they differ
    Vectors center{};                   ///< of the sub-patch, in its part
    // What is there: in the world, by patch parameters.
    Vectors position;        ///< mm
    Vectors du, dv;          ///< first derivatives, mm
    Vectors duu, duv, dvv;   ///< second derivatives, mm
    Vectors normal;          ///< unit, for lanes of `plain`
    Lanes<double> reach;     ///< mm: how far the errors of the parameters may move the position
    Lanes<double> away;      ///< mm: of the position from the origin
    std::uint32_t plain = 0; ///< a bit a lane: far from any pole, so that tangents give the normal
    // What is asked, after what is read a vector at a time.
    std::size_t count = 0;              ///< lanes from here on hold numbers of earlier hits
    Lanes<BezierPatchView> sub_patch{}; ///< control points relative to `center`
    Lanes<const Affine*> to_world{};    ///< null: the part's coordinates are the world's
};

} // namespace keiko
