#include "keiko/render/shading/glass_loss.h"

#include "keiko/light/fog/transmittance.h"
#include "keiko/light/glass/pane.h"
#include "keiko/light/luminance/fresnel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

namespace keiko {
namespace {

/// The middles of the cells of a grid in the segment, rectangle or box of 2, 4 or 8 corners, those
/// of the last coordinate side by side; or the middle of any other number.
std::vector<Vec3> places_amid(std::span<const Vec3> corners) {
    constexpr std::array<std::size_t, 4> cells_a_side{1, 8, 4, 2};
    if (!std::has_single_bit(corners.size()) || corners.size() > 8) {
        Vec3 middle(0);
        for (const Vec3& corner : corners) middle += corner / static_cast<double>(corners.size());
        return {middle};
    }
    const std::size_t side =
        cells_a_side.at(static_cast<std::size_t>(std::countr_zero(corners.size())));
    std::vector<Vec3> places(corners.begin(), corners.end());
    for (std::size_t filled = 1; places.size() > filled; filled *= side) {
        std::vector<Vec3> between;
        for (std::size_t group = 0; group < places.size(); group += 2 * filled)
            for (std::size_t cell = 0; cell < side; ++cell) {
                const double share = (static_cast<double>(cell) + 0.5) / static_cast<double>(side);
                for (std::size_t i = group; i < group + filled; ++i)
                    between.push_back(places[i] + (places[i + filled] - places[i]) * share);
            }
        places = std::move(between);
    }
    return places;
}

} // namespace

GlassLoss::GlassLoss(const Tracer& tracer, std::span<const Material> materials)
    : tracer_(tracer),
      materials_(materials),
      any_(std::any_of(materials.begin(), materials.end(),
                       [](const Material& material) { return material.glass.has_value(); })) {}

Rgb GlassLoss::left(const Vec3& point, const std::optional<Root>& root,
                    std::span<const Vec3> corners) const {
    if (corners.empty()) return Rgb(1);
    Ray way;
    way.origin = point, way.t_max = 1, way.excluded = root;
    Rgb sum;
    const std::vector<Vec3> places = places_amid(corners);
    for (const Vec3& place : places) {
        way.direction = place - point;
        sum += left_along(way);
    }
    return sum / static_cast<double>(places.size());
}

Rgb GlassLoss::left_along(const Ray& way) const {
    Rgb left(1);
    std::optional<double> entered;
    const double length = way.direction.length();
    for (const Hit& hit : tracer_.all(way)) {
        const Material& material = materials_[hit.face];
        if (!material.glass) continue;
        const double cosine = std::abs(hit.normal.dot(way.direction)) / length;
        const auto& [absorption, pane] = *material.glass;
        if (pane > 0) {
            left *= pane_shares(cosine, material.refractive_index, absorption, pane).passed;
            continue;
        }
        left *= 1 - fresnel_dielectric(cosine, material.refractive_index);
        if (entered) left *= transmittance(absorption * ((hit.t - *entered) * length));
        entered = entered ? std::nullopt : std::optional(hit.t);
    }
    return left;
}

} // namespace keiko
