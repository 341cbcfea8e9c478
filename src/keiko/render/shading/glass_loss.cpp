#include "keiko/render/shading/glass_loss.h"

#include "keiko/light/fog/transmittance.h"
#include "keiko/light/glass/pane.h"
#include "keiko/light/luminance/fresnel.h"
#include "keiko/render/caustics/light_chart.h"
#include "keiko/render/shading/lamp_places.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace keiko {
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
    for (const auto& [place, weight] : lamp_places(source, lamp, point)) {
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
