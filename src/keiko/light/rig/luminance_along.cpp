#include "keiko/light/rig/luminance_along.h"

#include "keiko/light/fog/transmittance.h"
#include "keiko/light/sky/sky_scattering.h"
#include "keiko/light/spotlight/point_light.h"

#include <algorithm>

namespace keiko {

namespace {

struct InLight {
    const Segment& ray;

    /// A lamp's own glow in the medium is left out: it is spread widely enough for `ambient` to
    /// represent it.
    IntervalSet operator()(const CPlane&) const { return {}; }
    template <ExtendedLight Light>
    IntervalSet operator()(const Light&) const {
        return {};
    }
    /// An open sky has no shafts, and is added by itself.
    IntervalSet operator()(const SkyLight&) const { return {}; }
    template <PointLight Light>
    IntervalSet operator()(const Light& light) const {
        return light.shaft ? in_beam(light, ray) : IntervalSet();
    }
    IntervalSet operator()(const Sun& sun) const {
        IntervalSet lit;
        if (!sun.shaft) return lit;
        for (const Window& window : sun.windows)
            lit = lit.unite(in_window_beam(window, sun.direction.normalized(), ray));
        return lit;
    }
};

/// The parts of `parts` of a segment that are visible from a source.
IntervalSet seen_of(const IntervalSet& parts, const Segment& segment, std::size_t source,
                    const VisibleFrom& visible_from) {
    if (!visible_from) return parts;
    std::vector<ParameterInterval> seen;
    for (const ParameterInterval& part : parts)
        for (const ParameterInterval& piece :
             visible_from(source, {segment.at(part.begin), segment.at(part.end)}))
            seen.push_back(
                {part.begin + piece.begin * part.length(), part.begin + piece.end * part.length()});
    return IntervalSet(std::move(seen));
}

PointEmitter emitter_of(const Spotlight& light, const Segment& ray) {
    const auto* edge = std::get_if<EdgeProfile>(&light.profile);
    const bool plain = std::holds_alternative<std::monostate>(light.pattern) && !light.hue;
    PointEmitter emitter{light.position, BeamIntensity(light)};
    if (plain && edge && edge->edge == BeamEdge::sharp) emitter.even = light.intensity;
    emitter.kinks = intensity_kinks(light, ray);
    return emitter;
}

PointEmitter emitter_of(const Luminaire& luminaire, const Segment& ray) {
    PointEmitter emitter{luminaire.position, LuminaireIntensity(luminaire)};
    emitter.kinks = intensity_kinks(luminaire, ray);
    return emitter;
}

PointEmitter emitter_of(const PointSource& light, const Segment&) {
    PointEmitter emitter{light.position,
                         [&light](const Vec3& point) { return intensity_towards(light, point); }};
    if (light.distribution == PointDistribution::uniform) emitter.even = light.intensity;
    return emitter;
}

/// Light of one source that the medium scatters into the camera ray.
struct Inscatter {
    const AttenuatedRay& ray;
    const IntervalSet& lit;
    double tolerance;

    Rgb operator()(const CPlane&) const { return {}; }
    template <ExtendedLight Light>
    Rgb operator()(const Light&) const {
        return {};
    }
    Rgb operator()(const SkyLight&) const { return {}; }
    template <PointLight Light>
    Rgb operator()(const Light& light) const {
        return scattered_light(ray, lit, emitter_of(light, ray.ray()), tolerance);
    }
    /// If windows are behind each other the light counts once, from the first of them.
    Rgb operator()(const Sun& sun) const {
        Rgb sum;
        IntervalSet left = lit;
        for (const Window& window : sun.windows) {
            const ParallelBeam beam{sun.direction.normalized(), sun.illuminance, window};
            const IntervalSet own = in_window_beam(window, beam.direction, ray.ray());
            sum += scattered_light(ray, left.intersect(own), beam, tolerance);
            left = left.intersect(own.complement());
        }
        return sum;
    }
};

} // namespace

IntervalSet in_light(const LightSource& source, const Segment& camera_ray) {
    return std::visit(InLight{camera_ray}, source);
}

Rgb luminance_along(const LightRig& rig, const Segment& camera_ray, const Rgb& surface,
                    const VisibleFrom& visible_from, double tolerance) {
    if (!rig.medium) return surface;
    const AttenuatedRay dimmed(*rig.medium, camera_ray);
    const Rgb depth = dimmed.depth_to(1);
    Rgb sum = surface * transmittance(depth) + ambient_inscatter(*rig.medium, depth);
    for (std::size_t i = 0; i < rig.sources.size(); ++i) {
        const auto* sky = std::get_if<SkyLight>(&rig.sources[i]);
        if (sky && sky->windows.empty()) sum += scattered_light(dimmed, *sky, tolerance);
        const IntervalSet beam = in_light(rig.sources[i], camera_ray);
        if (beam.empty()) continue;
        const IntervalSet lit = seen_of(beam, camera_ray, i, visible_from);
        sum += std::visit(Inscatter{dimmed, lit, tolerance}, rig.sources[i]);
    }
    return sum;
}

namespace {

/// Optical depth from a source to a place; nullopt for a source that does not light the medium.
struct DepthTo {
    const Medium& medium;
    const Vec3& place;

    std::optional<Rgb> operator()(const CPlane&) const { return std::nullopt; }
    template <ExtendedLight Light>
    std::optional<Rgb> operator()(const Light&) const {
        return std::nullopt;
    }
    std::optional<Rgb> operator()(const SkyLight&) const { return std::nullopt; }
    template <PointLight Light>
    std::optional<Rgb> operator()(const Light& light) const {
        if (!light.shaft) return std::nullopt;
        return optical_depth(medium, {light.position, place});
    }
    std::optional<Rgb> operator()(const Sun& sun) const {
        if (!sun.shaft || sun.windows.empty()) return std::nullopt;
        return Rgb(0);
    }
};

} // namespace

double scatterings_by_way_of(const LightRig& rig, const Vec3& place, const Vec3& eye) {
    double most = 0;
    if (!rig.medium) return most;
    const Rgb to_eye = optical_depth(*rig.medium, {place, eye});
    for (const LightSource& source : rig.sources)
        if (const auto depth = std::visit(DepthTo{*rig.medium, place}, source))
            most = std::max(most, max_channel((*depth + to_eye) * rig.medium->albedo));
    return most;
}

} // namespace keiko
