#include "keiko/radiosity/gather_rays.h"

#include "keiko/radiosity/hemisphere_directions.h"

#include <algorithm>

namespace keiko {

MetElement GatherRays::met_at(const Hit& hit, const Vec3& direction) const {
    const auto place = locator_.at(hit.instance, hit.patch, hit.uv);
    if (!place) return {MetElement::is_lost, {}, {}, 0};
    const bool before_normal = hit.normal.dot(direction) < 0;
    const bool front = before_normal == locator_.front_is_normal(hit.instance, hit.patch);
    const std::uint32_t element = triangles_[place->triangle].element;
    return {front ? element : element + static_cast<std::uint32_t>(elements_),
            *place,
            {hit.position, before_normal ? hit.normal : -hit.normal, hit.root},
            hit.t};
}

std::vector<MetElement> GatherRays::met(std::span<const LightPoint> points, int rays,
                                        std::uint64_t seed) const {
    constexpr std::size_t at_once = 1024;
    const HemisphereDirections directions(seed);
    const auto count = static_cast<std::size_t>(rays);
    std::vector<MetElement> met(count);
    Rays block;
    for (std::size_t begin = 0; begin < count; begin += at_once) {
        check_stop();
        block.assign(std::min(at_once, count - begin), Ray());
        for (std::size_t i = 0; i < block.size(); ++i) {
            const LightPoint& point = points[(begin + i) * points.size() / count];
            block[i].origin = point.position;
            block[i].direction =
                directions.direction(static_cast<std::uint32_t>(begin + i), point.normal);
            block[i].excluded = point.root;
        }
        const FirstHits found = tracer_.first_hits(block);
        for (std::size_t i = 0; i < block.size(); ++i)
            if (const Hit* hit = found[i]) met[begin + i] = met_at(*hit, block[i].direction);
    }
    return met;
}

} // namespace keiko
