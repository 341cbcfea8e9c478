#include "keiko/render/shading/glass_loss.h"

#include "keiko/light/fog/transmittance.h"
#include "keiko/light/glass/pane.h"
#include "keiko/light/luminance/fresnel.h"
#include "keiko/render/caustics/light_chart.h"
#include "keiko/render/shading/direct_lighting.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

namespace keiko {
namespace {

/// A place that light comes from, and its part of the lamp's light.
struct LitPlace {
    Vec3 place;
    double weight;
};

/// The middles of the cells of a grid in the segment, rectangle or box of 2, 4 or 8 corners, those
/// of the last coordinate side by side; or the one corner.
std::vector<LitPlace> grid_of(std::vector<Vec3> places) {
    constexpr std::array<std::size_t, 4> cells_a_side{1, 8, 4, 2};
    const std::size_t side =
        cells_a_side.at(static_cast<std::size_t>(std::countr_zero(places.size())));
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
    std::vector<LitPlace> lit;
    lit.reserve(places.size());
    for (const Vec3& place : places) lit.push_back({place, 1});
    return lit;
}

/// 16 places in each triangle of a fan over a polygon, by their solid angles from a point.
std::vector<LitPlace> fan_of(std::span<const Vec3> corners, const Vec3& point) {
    constexpr int side = 4;
    std::vector<LitPlace> lit;
    for (std::size_t c = 1; c + 1 < corners.size(); ++c) {
        const Vec3 u = corners[c] - corners[0], v = corners[c + 1] - corners[0];
        for (int row = 0; row < side; ++row)
            for (int cell = 0; cell < 2 * (side - row) - 1; ++cell) {
                // Cells of a row point to either side in turn.
                const double third = cell % 2 == 0 ? 1 / 3.0 : 2 / 3.0;
                const int column = cell / 2;
                const Vec3 place =
                    corners[0] + u * ((column + third) / side) + v * ((row + third) / side);
                const Vec3 way = place - point;
                const double r = way.length();
                lit.push_back({place, std::abs(u.cross(v).dot(way)) / (r * r * r)});
            }
    }
    return lit;
}

std::vector<LitPlace> places_of(const PreparedSource& source, int lamp, const Vec3& point) {
    std::vector<Vec3> corners = lamp_corners(source, lamp, point, TubeModel::preview);
    return std::holds_alternative<SkyLight>(source.kind()) ? fan_of(corners, point)
                                                           : grid_of(std::move(corners));
}

} // namespace

GlassLoss::GlassLoss(const Tracer& tracer, std::span<const Material> materials, bool caustics)
    : tracer_(tracer),
      materials_(materials),
      any_(std::any_of(materials.begin(), materials.end(),
                       [](const Material& material) { return material.glass.has_value(); })),
      caustics_(caustics) {}

Rgb GlassLoss::left(const PreparedSource& source, int lamp, const Vec3& point,
                    const std::optional<Root>& root) const {
    Rgb sum;
    double weights = 0;
    const bool bent = caustics_ && casts_caustics(source);
    for (const auto& [place, weight] : places_of(source, lamp, point)) {
        sum += left_along(point, root, place - point, bent) * weight;
        weights += weight;
    }
    return weights > 0 ? sum / weights : Rgb(1);
}

Rgb GlassLoss::left_along(const Vec3& point, const std::optional<Root>& root, const Vec3& towards,
                          bool bent) const {
    Ray way;
    way.origin = point, way.direction = towards, way.t_max = 1, way.excluded = root;
    const double length = towards.length();
    const std::vector<Hit> hits = tracer_.all(way);
    std::vector<const Hit*> solid;
    Rgb left(1);
    for (const Hit& hit : hits) {
        const Material& material = materials_[hit.face];
        if (!material.glass) continue;
        const double cosine = std::abs(hit.normal.dot(towards)) / length;
        const auto& [absorption, pane] = *material.glass;
        if (pane > 0) {
            left *= pane_shares(cosine, material.refractive_index, absorption, pane).passed;
            continue;
        }
        if (bent) return {};
        left *= 1 - fresnel_dielectric(cosine, material.refractive_index);
        solid.push_back(&hit);
    }
    return left * left_inside(solid, length);
}

/// With an odd number the way begins in glass: a lit place stands in a block, and a lamp does not.
Rgb GlassLoss::left_inside(std::span<const Hit* const> solid, double length) const {
    Rgb left(1);
    double entered = 0;
    for (std::size_t i = 0; i < solid.size(); ++i) {
        const bool leaves = (solid.size() - i) % 2 == 1;
        if (leaves)
            left *= transmittance(materials_[solid[i]->face].glass->absorption *
                                  ((solid[i]->t - entered) * length));
        entered = solid[i]->t;
    }
    return left;
}

} // namespace keiko
