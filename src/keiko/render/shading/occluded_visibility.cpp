#include "keiko/render/shading/occluded_visibility.h"

#include "keiko/base/job.h"
#include "keiko/light/areas/area_irradiance.h"
#include "keiko/light/spotlight/point_light.h"
#include "keiko/math/box_corners.h"

namespace keiko {
namespace {

std::vector<IntervalSet> seen_by(const VisibilityQuery& view, std::span<const Segment> segments) {
    std::vector<IntervalSet> seen;
    seen.reserve(segments.size());
    for (VisibleIntervals& parts : view.intervals(segments))
        seen.push_back(std::move(parts.intervals));
    return seen;
}

struct ViewpointOf {
    Viewpoint operator()(const CPlane& plane) const { return Viewpoint::at(plane.origin); }
    template <PointLight Light>
    Viewpoint operator()(const Light& light) const {
        return Viewpoint::at(light.position);
    }
    Viewpoint operator()(const Sun& sun) const { return Viewpoint::towards(sun.towards()); }
    Viewpoint operator()(const PolygonLight& light) const {
        return Viewpoint::at(light.corners.front());
    }
    Viewpoint operator()(const SphereLight& light) const { return Viewpoint::at(light.center); }
    Viewpoint operator()(const ContourLight& light) const {
        return Viewpoint::at(sphere_around(light).center);
    }
    template <CurvedLight Light>
    Viewpoint operator()(const Light& light) const {
        return Viewpoint::at(sphere_around(light).center);
    }
    Viewpoint operator()(const LineLight& light) const { return Viewpoint::at(light.a); }
    Viewpoint operator()(const SkyLight&) const { return Viewpoint::towards({0, 0, 1}); }
};

/// Parts of the rays that a source lights without occlusion, as luminance_along queries them.
std::vector<Segment> lit_parts(const LightSource& source, std::span<const Segment> camera_rays) {
    std::vector<Segment> parts;
    for (const Segment& ray : camera_rays)
        for (const ParameterInterval& part : in_light(source, ray))
            parts.push_back({ray.at(part.begin), ray.at(part.end)});
    return parts;
}

/// Corners of a box around segments; empty without any.
std::vector<Vec3> region_of(std::span<const Segment> segments) {
    Box3 box;
    for (const Segment& segment : segments) {
        box.extend(segment.a);
        box.extend(segment.b);
    }
    return box.empty() ? std::vector<Vec3>() : corners_of(box);
}

/// Origin of a pencil of planes, unless it is the camera's eye.
struct PencilLight {
    std::optional<Vec3> operator()(const CPlane&) const { return std::nullopt; }
    template <PointLight Light>
    std::optional<Vec3> operator()(const Light& light) const {
        return light.shaft ? std::optional(light.position) : std::nullopt;
    }
    std::optional<Vec3> operator()(const Sun&) const { return std::nullopt; }
    std::optional<Vec3> operator()(const SkyLight&) const { return std::nullopt; }
    template <ExtendedLight Light>
    std::optional<Vec3> operator()(const Light&) const {
        return std::nullopt;
    }
};

} // namespace

const VisibilityQuery& OccludedVisibility::view() const {
    if (!view_) view_.emplace(*occluders_, tracer_, viewpoint_, region_, facing_);
    return *view_;
}

IntervalSet OccludedVisibility::intervals(const Segment& segment) const {
    check_stop();
    if (!occluders_) return IntervalSet::whole();
    const auto place = place_in_row(segment);
    if (!place) return view().intervals(segment).intervals;
    if (of_row_.empty()) of_row_ = pencil_ ? pencil_->intervals(row_) : seen_by(view(), row_);
    return of_row_[*place];
}

/// Searches on from the segment that was found last.
std::optional<std::size_t> OccludedVisibility::place_in_row(const Segment& segment) const {
    for (std::size_t i = 0; i < row_.size(); ++i) {
        const std::size_t place = (next_ + i) % row_.size();
        if (row_[place] != segment) continue;
        next_ = place + 1;
        return place;
    }
    return std::nullopt;
}

std::vector<IntervalSet> OccludedVisibility::intervals(std::span<const Segment> segments) const {
    check_stop();
    if (!occluders_) return std::vector<IntervalSet>(segments.size(), IntervalSet::whole());
    return seen_by(view(), segments);
}

std::vector<std::optional<bool>> OccludedVisibility::classify_prisms(
    std::span<const Prism> prisms) const {
    if (!occluders_) return std::vector<std::optional<bool>>(prisms.size(), true);
    return view().classify_prisms(prisms);
}

std::vector<CriticalSlice> OccludedVisibility::turns(const Prism& prism,
                                                     const TurnRule& rule) const {
    if (!occluders_) return {};
    return view().turns(prism, rule);
}

std::vector<std::optional<EpipolarShadows>> shaft_pencils(const LightRig& rig,
                                                          const Occluders* occluders,
                                                          const Tracer& tracer, const Vec3& eye,
                                                          const Job& job) {
    std::vector<std::optional<EpipolarShadows>> pencils;
    if (!occluders || !rig.medium) return pencils;
    for (const LightSource& source : rig.sources) {
        const std::optional<Vec3> light = std::visit(PencilLight(), source);
        pencils.emplace_back();
        if (light && *light != eye) pencils.back().emplace(*occluders, tracer, *light, eye, job);
    }
    return pencils;
}

VolumetricShadows::VolumetricShadows(const LightRig& rig, const Occluders* occluders,
                                     const Tracer& tracer, std::span<const Segment> camera_rays,
                                     std::span<const std::optional<EpipolarShadows>> pencils) {
    if (!occluders || !rig.medium) return;
    for (std::size_t i = 0; i < rig.sources.size(); ++i) {
        const LightSource& source = rig.sources[i];
        const bool in_pencil = !pencils.empty() && pencils[i];
        std::vector<Segment> parts = lit_parts(source, camera_rays);
        std::vector<Vec3> region = region_of(parts);
        seen_.emplace_back(occluders, tracer, std::visit(ViewpointOf(), source), std::move(region),
                           std::move(parts), std::optional<Vec3>(),
                           in_pencil ? &*pencils[i] : nullptr);
    }
}

VisibleFrom VolumetricShadows::visible() const {
    if (seen_.empty()) return {};
    return [this](std::size_t source, const Segment& segment) {
        return seen_[source].intervals(segment);
    };
}

} // namespace keiko
