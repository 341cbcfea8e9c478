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
    bool by_pole = false;              ///< true where the differentials are not to be relied on
    const LightChart* chart = nullptr; ///< of the first leg
};

/// A way on from a surface.
struct LightPaths::Branch {
    LightWay::Step step;
    Rgb share;
    double eta = 1;                   ///< of what is bent
    const Material* inside = nullptr; ///< where it goes on in
};

/// A landing, whose changes are not known if the way to it met a pole.
struct LightPaths::Arrival {
    LightLanding landing;
    bool by_pole;
};

std::vector<LightLanding> LightPaths::landings(const LightChart& chart, const Vec2& at) const {
    return followed(chart, at, nullptr);
}

std::optional<LightLanding> LightPaths::landing(const LightChart& chart, const Vec2& at,
                                                const LightWay& way) const {
    const std::vector<LightLanding> found = followed(chart, at, &way);
    return found.empty() ? std::nullopt : std::optional(found.front());
}

std::vector<LightLanding> LightPaths::followed(const LightChart& chart, const Vec2& at,
                                               const LightWay* only) const {
    std::vector<Arrival> arrivals;
    follow({.ray = chart.ray(at), .chart = &chart}, only, arrivals);
    std::vector<LightLanding> found;
    for (auto& [landing, by_pole] : arrivals)
        if (!by_pole || differentiate(chart, at, landing)) found.push_back(landing);
    return found;
}

/// Place of a landing by the same way on the same face; nullopt if the ray lands elsewhere.
std::optional<Vec3> LightPaths::position(const LightChart& chart, const Vec2& at,
                                         const LightLanding& like) const {
    std::vector<Arrival> arrivals;
    follow({.ray = chart.ray(at), .chart = &chart}, &like.way, arrivals);
    for (const auto& [landing, by_pole] : arrivals)
        if (landing.face == like.face && landing.instance == like.instance) return landing.position;
    return {};
}

/// Change of a landing for a step of 1, from rays at both sides; nullopt if one goes elsewhere.
std::optional<Vec3> LightPaths::change(const LightChart& chart, const Vec2& at, const Vec2& step,
                                       const LightLanding& like) const {
    const auto before = position(chart, at - step, like), behind = position(chart, at + step, like);
    if (!before || !behind) return {};
    return (*behind - *before) / (2 * step.length());
}

/// Sets the changes of a landing by rays beside it, where the ray's own differentials are lost;
/// false if none go the same way. Differences of two widths cancel the error of second order.
bool LightPaths::differentiate(const LightChart& chart, const Vec2& at,
                               LightLanding& landing) const {
    constexpr double widest = 1e-3; // of the chart: rounding is below 1e-9 of the change
    constexpr double even = 1e-4;   // difference between the widths of which the rest is 1e-8
    constexpr int most_halvings = 6;
    const Vec2 extent = chart.range().extent();
    double width = widest * std::max(extent.x, extent.y);
    for (int halvings = 0; halvings < most_halvings; ++halvings, width /= 2) {
        const auto wide_x = change(chart, at, {width, 0}, landing);
        const auto wide_y = change(chart, at, {0, width}, landing);
        const auto x = change(chart, at, {width / 2, 0}, landing);
        const auto y = change(chart, at, {0, width / 2}, landing);
        if (!wide_x || !wide_y || !x || !y) continue;
        const Vec3 off_x = *x - *wide_x, off_y = *y - *wide_y;
        landing.dx = *x + off_x / 3, landing.dy = *y + off_y / 3;
        const double off = std::max(off_x.length(), off_y.length());
        if (off < even * std::max(landing.dx.length(), landing.dy.length())) return true;
    }
    return false;
}

/// Share of the light that arrives over a leg.
Rgb LightPaths::left_on(const Leg& leg, const Hit& hit) const {
    const double length = (hit.position - leg.ray.origin).length();
    if (leg.inside) return transmittance(leg.inside->glass->absorption * length);
    if (!medium_) return Rgb(1);
    const Vec3 from = leg.chart ? leg.chart->start_in_medium(hit.position) : leg.ray.origin;
    return transmittance(*medium_, {from, hit.position});
}

void LightPaths::follow(const Leg& leg, const LightWay* only, std::vector<Arrival>& found) const {
    const std::optional<Hit> hit = tracer_.nearest(leg.ray);
    if (!hit) return;
    Leg here = leg;
    here.weight *= left_on(leg, *hit);
    here.chart = nullptr;
    if (!here.first) here.first = hit->position;
    const bool ends = only && leg.way.length() == only->length();
    if (!leg.way.is_direct() && !materials_[hit->face].glass && (!only || ends)) {
        const Vec3& d = leg.ray.direction;
        const RayDifferentials rates = leg.ray.differentials.value_or(RayDifferentials());
        found.push_back({{leg.way, hit->instance, hit->face, hit->position,
                          hit->normal.dot(d) > 0 ? -hit->normal : hit->normal, d.normalized(),
                          transfer(leg.ray, *hit, rates.origin_dx, rates.direction_dx),
                          transfer(leg.ray, *hit, rates.origin_dy, rates.direction_dy), *here.first,
                          here.weight},
                         leg.by_pole || !leg.ray.differentials});
    }
    if (!ends && leg.way.length() < spec_.interfaces) go_on(here, *hit, only, found);
}

void LightPaths::go_on(const Leg& leg, const Hit& hit, const LightWay* only,
                       std::vector<Arrival>& found) const {
    constexpr double nearest_pole = 1e-3; // within, 1e-10 of the differentials are lost, and more
    const bool by_pole = leg.by_pole || !(distance_to_pole(hit) > nearest_pole);
    for (const Branch& branch : branches(leg, hit)) {
        const Rgb weight = leg.weight * branch.share;
        if (only ? branch.step != only->at(leg.way.length()) || weight == Rgb(0)
                 : !(max_channel(weight) >= spec_.min_weight))
            continue;
        const std::optional<Ray> ray = branch.step == LightWay::Step::mirrors
                                           ? std::optional(reflect_ray(leg.ray, hit))
                                           : refract_ray(leg.ray, hit, branch.eta);
        if (!ray) continue;
        follow({*ray, weight, leg.way.after(branch.step), branch.inside, leg.first, by_pole}, only,
               found);
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
