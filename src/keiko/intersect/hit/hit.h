#pragma once

#include "keiko/base/export.h"
#include "keiko/base/memory.h"
#include "keiko/geometry/bezier/bezier.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/geometry/rays/ray.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Second derivatives of the surface by patch parameters, world, mm.
struct SecondDerivatives {
    Vec3 duu{0}, duv{0}, dvv{0}; ///< by patch parameters, mm
};

/// How a hit was found and what is special about it; a bit set.
enum class HitFlags : std::uint32_t {
    none = 0,       ///< a root that was proved unique
    tangential = 1, ///< the ray touches; two roots may have been taken for one
    seam = 2,       ///< beyond a trimmed border, before the neighbour's: see SeamGap
    clipped = 4     ///< finished by clipping, not by the uniqueness proof
};
/// The union of two sets.
constexpr HitFlags operator|(HitFlags a, HitFlags b) {
    return static_cast<HitFlags>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
/// True if the set holds the flag.
constexpr bool has(HitFlags set, HitFlags flag) {
    return (static_cast<std::uint32_t>(set) & static_cast<std::uint32_t>(flag)) != 0;
}

/// Intersection of a ray with the surface. All vectors are in world coordinates, mm.
struct Hit {
    double t = std::numeric_limits<double>::infinity(); ///< parameter of the ray
    std::uint32_t instance = 0, face = 0, patch = 0;    ///< into the model's arrays
    Vec2 uv{0};                                         ///< patch parameters, [0, 1]^2
    Vec3 position{0};                                   ///< on the surface
    Vec3 normal{0};        ///< unit, along dpdu x dpdv (of the mirrored tangents, if mirrored)
    Vec3 dpdu{0}, dpdv{0}; ///< world, mm, by patch parameters
    std::optional<SecondDerivatives> second; ///< on request
    double position_bound = 0;         ///< mm, bound of the distance to the exact intersection
    HitFlags flags = HitFlags::none;   ///< what is special about it
    std::optional<std::uint32_t> seam; ///< edge index, for seam hits

    Root root; ///< certified box of this root, to exclude it from secondary rays
};

/// Array of hits.
using Hits = std::vector<Hit, DefaultInitAllocator<Hit>>;

/// Position and derivatives by patch parameters. Requires `second`.
inline SurfaceDerivatives derivatives_of(const Hit& hit) {
    SurfaceDerivatives s;
    s.d[0][0] = hit.position;
    s.d[1][0] = hit.dpdu, s.d[0][1] = hit.dpdv;
    s.d[2][0] = hit.second->duu, s.d[1][1] = hit.second->duv, s.d[0][2] = hit.second->dvv;
    return s;
}

/// How many hits were found in which way.
struct HitStatistics {
    std::uint64_t unique = 0;     ///< proved to be the only root of their sub-patch
    std::uint64_t clipped = 0;    ///< finished by clipping
    std::uint64_t tangential = 0; ///< the ray touches, finished by clipping or not

    /// Number of all hits.
    std::uint64_t sum() const { return unique + clipped + tangential; }
    /// Counts one more hit.
    void count(const Hit& hit);
    HitStatistics& operator+=(const HitStatistics& other); ///< Adds the counts of another.
    bool operator==(const HitStatistics&) const = default;
};

/// "1234 hits: 98.10 % unique, 1.80 % clipped, 0.10 % tangential"
std::string path_text(const HitStatistics& counts);

/// A root on a sub-patch that passed every test, with nothing evaluated there yet: what a search
/// finds. Tracer::evaluate makes a Hit of it.
struct Crossing {
    double t = std::numeric_limits<double>::infinity(); ///< of the ray; infinite: no hit
    std::uint32_t sub_patch = no_index;                 ///< index among the placed sub-patches
    std::uint32_t seam = no_index;                      ///< edge index, for seam hits
    Vec2 uv{0};                                         ///< of the sub-patch's own [0, 1]^2
    Vec2 error{0};                   ///< bounds of the distance to the exact root
    HitFlags flags = HitFlags::none; ///< what is special about it

    /// True if there is a crossing.
    explicit operator bool() const { return sub_patch != no_index; }
    /// Order of hits along a ray, total so that it does not depend on who was found first.
    bool before(const Crossing& other) const {
        return t < other.t || (t == other.t && sub_patch < other.sub_patch);
    }
};

} // namespace keiko
