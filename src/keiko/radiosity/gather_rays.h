#pragma once

#include "keiko/intersect/traversal/tracer.h"
#include "keiko/radiosity/element_locator.h"
#include "keiko/radiosity/elements.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace keiko {

/// Place of an element that a ray meets.
struct MetElement {
    /// A ray that leaves the scene.
    static constexpr std::uint32_t leaves = no_index;
    /// A ray that meets a face without elements, which reflects nothing.
    static constexpr std::uint32_t is_lost = no_index - 1;

    std::uint32_t face = leaves; ///< of the element, fronts first, then backs; or one of the above
    TrianglePlace place{};       ///< if it is an element
    LightPoint at{};             ///< on it, on the side that the ray meets
    double distance = 0;         ///< mm, from the start of the ray

    /// True for a place of an element.
    bool reflects() const { return face < is_lost; }
};

/// Rays over the hemispheres of points to the exact surfaces of a scene.
class GatherRays {
public:
    /// `elements`: their number. Keeps references to tracer, locator and triangles.
    GatherRays(const Tracer& tracer, const ElementLocator& locator,
               std::span<const SolvedTriangle> triangles, std::size_t elements)
        : tracer_(tracer), locator_(locator), triangles_(triangles), elements_(elements) {}

    /// Place that each ray meets. `rays` in all, spread evenly over the points, each by the cosine
    /// over its hemisphere. `seed`: of their directions.
    std::vector<MetElement> met(std::span<const LightPoint> points, int rays,
                                std::uint64_t seed) const;

private:
    MetElement met_at(const Hit& hit, const Vec3& direction) const;

    const Tracer& tracer_;
    const ElementLocator& locator_;
    std::span<const SolvedTriangle> triangles_;
    std::size_t elements_;
};

} // namespace keiko
