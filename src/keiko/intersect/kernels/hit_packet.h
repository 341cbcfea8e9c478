#pragma once

#include "keiko/geometry/bezier/bezier_patch.h"
#include "keiko/math/affine.h"

#include <array>
#include <cstdint>

namespace keiko {

/// Up to 8 hits, each on a sub-patch of its own, whose surfaces are evaluated side by side.
struct alignas(64) HitPacket {
    static constexpr std::size_t capacity = 8;
    template <class T>
    using Lanes = std::array<T, capacity>;
    using Vectors = std::array<Lanes<double>, 3>;

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
    Vectors position, du, dv, duu, duv, dvv;
    Vectors normal;          ///< unit, for lanes of `plain`
    Lanes<double> reach;     ///< mm: how far the errors of the parameters may move the position
    Lanes<double> away;      ///< mm: of the position from the origin
    std::uint32_t plain = 0; ///< a bit a lane: far from any pole, so that tangents give the normal
    // What is asked, after what is read a vector at a time.
    std::size_t count = 0; ///< lanes from here on hold numbers of earlier hits
    Lanes<BezierPatchView> sub_patch{};
    Lanes<const Affine*> to_world{}; ///< null: the part's coordinates are the world's
};

} // namespace keiko
