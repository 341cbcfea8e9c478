#include "keiko/render/shadows.h"

#include "keiko/render/source_region.h"

namespace keiko {

IntervalSet SeenPast::intervals(const Segment& segment) const {
    if (!occluders_) return IntervalSet::whole();
    if (!view_) view_.emplace(*occluders_, tracer_, apex_, region_);
    return view_->intervals(segment.a, segment.b).intervals;
}

SeenPast ShadowedRig::seen_from(const Vec3& point, const std::optional<Root>& root,
                                const LightSource& source) const {
    return {occluders_, tracer_, Apex::at(point, root),
            occluders_ ? source_region(source, point) : std::vector<Vec3>()};
}

Rgb ShadowedRig::from_source(std::size_t source, const Vec3& point, const Vec3& normal,
                             const std::optional<Root>& root, TubeModel model,
                             const ClearCoat* coat) const {
    const LightSource& light = rig_.sources[source];
    return illuminance_from(light, rig_.medium, point, normal, seen_from(point, root, light), model,
                            coat);
}

Rgb ShadowedRig::illuminance(const Vec3& point, const Vec3& normal, const std::optional<Root>& root,
                             TubeModel model, const ClearCoat* coat) const {
    Rgb sum;
    for (std::size_t i = 0; i < rig_.sources.size(); ++i)
        sum += from_source(i, point, normal, root, model, coat);
    return sum;
}

} // namespace keiko
