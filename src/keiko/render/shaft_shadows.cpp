#include "keiko/render/shaft_shadows.h"

#include "keiko/spotlight/point_light.h"

#include <algorithm>
#include <optional>

namespace keiko {
namespace {

struct ApexOf {
    Apex operator()(const CPlane& plane) const { return Apex::at(plane.origin); }
    template <PointLight Light>
    Apex operator()(const Light& light) const {
        return Apex::at(light.position);
    }
    Apex operator()(const Sun& sun) const { return Apex::towards(sun.towards()); }
};

/// Corners of a box around all that a source lights of the rays; none where it lights nothing.
std::vector<Vec3> lit_region(const LightSource& source, std::span<const Segment> eye_rays) {
    Box3 box;
    for (const Segment& ray : eye_rays)
        for (const ParameterInterval& part : in_light(source, ray)) {
            box.extend(ray.at(part.begin));
            box.extend(ray.at(part.end));
        }
    if (box.empty()) return {};
    std::vector<Vec3> corners;
    for (const double x : {box.lower.x, box.upper.x})
        for (const double y : {box.lower.y, box.upper.y})
            for (const double z : {box.lower.z, box.upper.z}) corners.emplace_back(x, y, z);
    return corners;
}

/// Where all of the rays begin, if they do in one place.
std::optional<Vec3> eye_of(std::span<const Segment> rays) {
    const auto from_first = [&](const Segment& ray) { return ray.a == rays.front().a; };
    if (rays.empty() || !std::all_of(rays.begin(), rays.end(), from_first)) return {};
    return rays.front().a;
}

} // namespace

ShaftShadows::ShaftShadows(const LightRig& rig, const Occluders* occluders, const Tracer& tracer,
                           std::span<const Segment> eye_rays) {
    if (!occluders || !rig.medium) return;
    const std::optional<Vec3> eye = eye_of(eye_rays);
    for (const LightSource& source : rig.sources)
        seen_.emplace_back(occluders, tracer, std::visit(ApexOf(), source),
                           lit_region(source, eye_rays), std::vector<Segment>(),
                           std::optional<Vec3>(), eye);
}

VisibleFrom ShaftShadows::visible() const {
    if (seen_.empty()) return {};
    return [this](std::size_t source, const Segment& segment) {
        return seen_[source].intervals(segment);
    };
}

} // namespace keiko
