// Where the light that an Integrator finds at a surface comes from: what is mirrored there, and
// what passes glass (docs/theory/glass.md).
#include "keiko/light/glass/pane.h"
#include "keiko/light/luminance/fresnel.h"
#include "keiko/render/shading/integrator.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace keiko {
namespace {

/// Odd ways, which do not run along the edges of upright boxes.
const std::array<Vec3, 3> ways_out{{{0.31, 0.52, 0.8}, {-0.73, 0.19, -0.66}, {0.48, -0.87, 0.11}}};

} // namespace

std::set<const Paint*> Integrator::glass_left_by(const Ray& ray) const {
    std::set<const Paint*> left;
    for (const Hit& hit : scene_.tracer.all(ray)) {
        const Paint& paint = paints_[paint_of_face_[hit.face]];
        if (!paint.glass() || paint.glass()->pane > 0) continue;
        if (!left.insert(&paint).second) left.erase(&paint);
    }
    return left;
}

const Paint* Integrator::glass_around(const Vec3& place) const {
    if (!glass_.any()) return nullptr;
    std::set<const Paint*> around;
    for (const Vec3& way : ways_out) {
        Ray ray;
        ray.origin = place, ray.direction = way;
        std::set<const Paint*> left = glass_left_by(ray);
        if (&way != ways_out.data())
            std::erase_if(left, [&](const Paint* paint) { return !around.contains(paint); });
        around = std::move(left);
    }
    return around.empty() ? nullptr : *std::min_element(around.begin(), around.end());
}

std::vector<const Paint*> Integrator::glass_around(std::span<const Ray> rays) const {
    std::vector<const Paint*> around(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const bool from_last = i > 0 && rays[i].origin == rays[i - 1].origin;
        around[i] = from_last ? around[i - 1] : glass_around(rays[i].origin);
    }
    return around;
}

Integrator::Onward Integrator::onward(const PathState& path, const PathVertex& met,
                                      const MappedPaint* mapped) const {
    const Paint& paint = paints_[paint_of_face_[met.hit->face]];
    const double cosine = met.incidence.cosine;
    Onward onward;
    if (!paint.glass())
        onward.mirrored = mirrored(path, met.incidence.mirrored);
    else
        onward = paint.glass()->pane > 0 ? through_pane(path, paint, cosine)
                                         : through_solid(path, paint, cosine);
    if (!mapped) return onward;
    if (onward.mirrored) onward.mirrored = kept(*onward.mirrored, mapped->paint.gloss_share());
    if (onward.passed) onward.passed = kept(*onward.passed, mapped->paint.passed_share());
    return onward;
}

Integrator::Onward Integrator::through_pane(const PathState& path, const Paint& paint,
                                            double cosine) const {
    const auto& [absorption, thickness] = *paint.glass();
    const PaneShares shares = pane_shares(cosine, paint.refractive_index(), absorption, thickness);
    return {mirrored(path, shares.mirrored), passed(path, shares.passed)};
}

Integrator::Onward Integrator::through_solid(const PathState& path, const Paint& paint,
                                             double cosine) const {
    // By the way of the ray and not by the sense of the normal, which files often have wrong.
    const bool leaves = path.inside != nullptr;
    const double n = leaves ? 1 / path.inside->refractive_index() : paint.refractive_index();
    const double share = fresnel_dielectric(cosine, n);
    if (share == 1 && leaves) return {totally_mirrored(path), {}};
    Onward onward{mirrored(path, Rgb(share)), passed(path, Rgb(1 - share)), 1 / n};
    if (onward.passed) {
        onward.passed->straight = false;
        onward.passed->inside = leaves ? nullptr : &paint;
    }
    return onward;
}

std::optional<Integrator::PathState> Integrator::mirrored(PathState path, const Rgb& share) const {
    if (path.mirrors >= options_.max_depth) return {};
    ++path.mirrors;
    path.straight = false;
    return onto(path, share, 1);
}

/// It loses nothing, and would end a way through a block too soon if it counted as a mirror.
std::optional<Integrator::PathState> Integrator::totally_mirrored(PathState path) const {
    if (path.crossings >= options_.max_crossings) return {};
    ++path.crossings;
    return onto(path, Rgb(1), 1);
}

std::optional<Integrator::PathState> Integrator::passed(PathState path, const Rgb& share) const {
    if (path.crossings >= options_.max_crossings) return {};
    ++path.crossings;
    return onto(path, share, 2);
}

std::optional<Integrator::PathState> Integrator::onto(PathState path, const Rgb& share,
                                                      std::uint64_t child) const {
    constexpr auto last = std::numeric_limits<decltype(path.branch)>::max();
    if (path.branch > (last - child) / 2) return {}; // after 64 surfaces
    path.branch = 2 * path.branch + child;
    return kept(path, share);
}

std::optional<Integrator::PathState> Integrator::kept(PathState path, const Rgb& share) const {
    path.weight *= share;
    const double weight = max_channel(path.weight);
    return weight > 0 && weight >= options_.min_weight ? std::optional(path) : std::nullopt;
}

} // namespace keiko
