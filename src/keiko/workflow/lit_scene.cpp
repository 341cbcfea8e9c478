#include "keiko/workflow/lit_scene.h"

#include "keiko/radiosity/reflected_light.h"
#include "keiko/render/shading/direct_lighting.h"

#include <cmath>

namespace keiko {

std::optional<Hit> nearest_along(const Tracer& surfaces, const Vec3& point, const Vec3& normal,
                                 double reach) {
    Ray across;
    across.origin = point;
    across.direction = normal;
    across.t_min = -reach, across.t_max = reach;
    std::optional<Hit> nearest;
    for (const Hit& hit : surfaces.all(across))
        if (!nearest || std::abs(hit.t) < std::abs(nearest->t)) nearest = hit;
    return nearest;
}

LitScene::LitScene(const Scene& scene, const LightRig& rig, TubeModel tubes, const Job& job)
    : scene_(scene),
      rig_(rig),
      tubes_(tubes),
      glass_(scene.seen(), scene.seen_materials(), scene.caustics.has_value()),
      straight_(scene.seen(), scene.seen_materials()),
      matter_(scene.volumes.get(), scene.texels.get()) {
    if (scene.caustics)
        caustics_.emplace(scene.seen(), scene.seen_materials(), rig_, *scene.caustics, job);
}

std::optional<std::size_t> LitScene::source_around(const Vec3& point) const {
    for (std::size_t source = 0; source < rig_.sources.size(); ++source)
        if (within_lamp(rig_.sources[source], point)) return source;
    return std::nullopt;
}

/// The point of a surface that is nearest along the normal, if it is within the rounding of
/// coordinates with a few digits.
LitScene::Place LitScene::place_of(const Vec3& point, const Vec3& normal) const {
    constexpr double meant = 1e-3; // mm
    const auto hit = nearest_along(scene_.seen(), point, normal, meant);
    return hit ? Place{hit->position, hit} : Place{point, {}};
}

/// Takes from the light of each lamp what glass takes.
void LitScene::dim_by_glass(const Place& place, std::span<const LightId> lights,
                            std::vector<Rgb>& lux) const {
    // Caustics land on surfaces alone: a point in the air has the light that passes straight on.
    const GlassLoss& glass = place.hit ? glass_ : straight_;
    for (std::size_t i = 0; i < lights.size(); ++i)
        lux[i] *= glass.left(rig_.sources[lights[i].source], lights[i].lamp, place.position,
                             place.root());
}

/// Takes from the light of each lamp what volumes and texels take.
void LitScene::dim_by_matter(const Place& place, std::span<const LightId> lights,
                             std::vector<Rgb>& lux) const {
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (lux[i] != Rgb(0))
            lux[i] *= matter_.left(rig_.sources[lights[i].source], lights[i].lamp, place.position);
}

/// Light of each source by way of mirrors and glass; empty without.
std::vector<Rgb> LitScene::caustics_at(const Place& place, const Vec3& normal) const {
    if (!caustics_ || !place.hit) return {};
    const Hit& hit = *place.hit;
    constexpr double near = 1e-3; // mm: beams about a point
    return caustics_->at({hit.instance, hit.face, place.position, normal,
                          hit.dpdu.normalized() * near, hit.dpdv.normalized() * near});
}

std::vector<Rgb> LitScene::direct(const Vec3& point, const Vec3& normal) const {
    const Occluders* occluders = scene_.occluders ? &*scene_.occluders : nullptr;
    const DirectLighting lights(rig_, occluders, occluders ? occluders->tracer() : scene_.seen());
    const Place place = place_of(point, normal);
    const PointLighting lit(rig_, place.position, normal, tubes_, lights.lights(),
                            lights.light_visibility(place.position, normal, place.root(),
                                                    lights.lights(), tubes_, false));
    std::vector<Rgb> by_source = caustics_at(place, normal);
    by_source.resize(rig_.sources.size());
    std::vector<Rgb> by_light = lit.illuminance_by_light();
    if (occluders && glass_.any()) dim_by_glass(place, lights.lights(), by_light);
    if (occluders && matter_.any()) dim_by_matter(place, lights.lights(), by_light);
    each_source(lights.lights(),
                [&](std::size_t source, std::span<const int> lamps, std::size_t first) {
                    for (std::size_t i = 0; i < lamps.size(); ++i)
                        by_source[source] += by_light[first + i];
                });
    return by_source;
}

Rgb LitScene::reflected(const Vec3& point, const Vec3& normal) const {
    if (!scene_.reflected) return {};
    const Place place = place_of(point, normal);
    return scene_.reflected->gathered({place.position, normal, place.root()});
}

} // namespace keiko
