#include "keiko/render/caustics/light_path.h"

#include "keiko/intersect/hit/local_surface.h"
#include "keiko/intersect/hit/reflect_ray.h"
#include "keiko/intersect/hit/refract_ray.h"
#include "keiko/light/fog/transmittance.h"
#include "keiko/light/glass/pane.h"

#include <algorithm>
#include <cmath>

namespace keiko {

/// Light on its way to the next surface.
struct LightPaths::Leg {
    Ray ray;
    Rgb weight{1};
    LightWay way{};
    const Material* inside = nullptr;  ///< solid glass that it is in
    std::optional<Vec3> first{};       ///< place of the first surface
    const LightChart* chart = nullptr; ///< of the first leg
};

/// A way on from a surface.
struct LightPaths::Branch {
    LightWay::Step step;
    Rgb share;
    double eta = 1;                   ///< of what is bent
    const Material* inside = nullptr; ///< where it goes on in
};

std::vector<LightLanding> LightPaths::landings(const LightChart& chart, const Vec2& at) const {
    std::vector<LightLanding> found;
    follow({.ray = chart.ray(at), .chart = &chart}, nullptr, found);
    return found;
}

std::optional<LightLanding> LightPaths::landing(const LightChart& chart, const Vec2& at,
                                                const LightWay& way) const {
    std::vector<LightLanding> found;
    follow({.ray = chart.ray(at), .chart = &chart}, &way, found);
    return found.empty() ? std::nullopt : std::optional(found.front());
}

/// Share of the light that arrives over a leg.
Rgb LightPaths::left_on(const Leg& leg, const Hit& hit) const {
    const double length = (hit.position - leg.ray.origin).length();
    if (leg.inside) return transmittance(leg.inside->glass->absorption * length);
    if (!medium_) return Rgb(1);
    const Vec3 from = leg.chart ? leg.chart->start_in_medium(hit.position) : leg.ray.origin;
    return transmittance(*medium_, {from, hit.position});
}

void LightPaths::follow(const Leg& leg, const LightWay* only,
                        std::vector<LightLanding>& found) const {
    const std::optional<Hit> hit = tracer_.nearest(leg.ray);
    if (!hit || !leg.ray.differentials) return;
    Leg here = leg;
    here.weight *= left_on(leg, *hit);
    here.chart = nullptr;
    if (!here.first) here.first = hit->position;
    const bool ends = only && leg.way.length() == only->length();
    if (!leg.way.is_direct() && !materials_[hit->face].glass && (!only || ends)) {
        const Vec3& d = leg.ray.direction;
        const RayDifferentials& rates = *leg.ray.differentials;
        found.push_back({leg.way, hit->instance, hit->face, hit->position,
                         hit->normal.dot(d) > 0 ? -hit->normal : hit->normal, d.normalized(),
                         transfer(leg.ray, *hit, rates.origin_dx, rates.direction_dx),
                         transfer(leg.ray, *hit, rates.origin_dy, rates.direction_dy), *here.first,
                         here.weight});
    }
    if (!ends && leg.way.length() < spec_.interfaces) go_on(here, *hit, only, found);
}

void LightPaths::go_on(const Leg& leg, const Hit& hit, const LightWay* only,
                       std::vector<LightLanding>& found) const {
    for (const Branch& branch : branches(leg, hit)) {
        const Rgb weight = leg.weight * branch.share;
        if (only ? branch.step != only->at(leg.way.length()) || weight == Rgb(0)
                 : !(max_channel(weight) >= spec_.min_weight))
            continue;
        const std::optional<Ray> ray = branch.step == LightWay::Step::mirrors
                                           ? std::optional(reflect_ray(leg.ray, hit))
                                           : refract_ray(leg.ray, hit, branch.eta);
        if (!ray) continue;
        follow({*ray, weight, leg.way.after(branch.step), branch.inside, leg.first}, only, found);
    }
}

std::vector<LightPaths::Branch> LightPaths::branches(const Leg& leg, const Hit& hit) const {
    using enum LightWay::Step;
    const Material& material = materials_[hit.face];
    if (material.roughness) return {};
    const double cosine = std::abs(hit.normal.dot(leg.ray.direction)) / leg.ray.direction.length();
    if (!material.glass) return {{mirrors, border_of(material)(cosine), 1, leg.inside}};
    const auto& [absorption, pane] = *material.glass;
    if (pane > 0) {
        const auto [mirrored, passed] =
            pane_shares(cosine, material.refractive_index, absorption, pane);
        return {{mirrors, mirrored, 1, leg.inside}, {passes, passed, 1, leg.inside}};
    }
    // By the way of the light, as for rays of the camera.
    const double n = leg.inside ? 1 / leg.inside->refractive_index : material.refractive_index;
    const double share = fresnel_dielectric(cosine, n);
    return {{mirrors, Rgb(share), 1, leg.inside},
            {bends, Rgb(1 - share), 1 / n, leg.inside ? nullptr : &material}};
}

std::vector<bool> casting_faces(std::span<const Material> materials, double min_weight) {
    const auto mirrored = [](const Material& material) {
        if (!material.glass) return border_of(material)(1);
        const auto& [absorption, pane] = *material.glass;
        return pane_shares(1, material.refractive_index, absorption, pane).mirrored;
    };
    std::vector<bool> casting;
    for (const Material& material : materials) {
        const bool solid = material.glass && material.glass->pane == 0;
        casting.push_back(!material.roughness &&
                          (solid || max_channel(mirrored(material)) >= min_weight));
    }
    return casting;
}

} // namespace keiko
