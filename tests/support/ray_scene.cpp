#include "tests/support/ray_scene.h"

#include "tests/support/brute_force.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace keiko::test {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Parameters on a patch that a ray of this class is aimed at.
Vec2 random_place(Random& random, RayClass kind) {
    Vec2 uv(uniform(random, 0, 1), uniform(random, 0, 1));
    const auto end = [&] { return random() % 2 == 0 ? 0.0 : 1.0; };
    if (kind == RayClass::span_corner) return {end(), end()};
    if (kind == RayClass::span_edge) uv[static_cast<unsigned>(random() % 2)] = end();
    return uv;
}

std::optional<Mark> mark_at(const ExactPatch& patch, const Vec2& uv) {
    const ExactPatch::Point p = patch.at(uv.x, uv.y);
    const Long u = p.du.length(), v = p.dv.length();
    if (!(u > 0 && v > 0 && p.du.cross(p.dv).length() > 1e-6L * u * v)) return std::nullopt;
    return Mark{shortened(p.position), shortened(p.normal()), shortened(p.du / u),
                shortened(p.dv / v)};
}

bool at_rim(const ExactRoot& root) {
    constexpr Long near = 1e-9L;
    for (const Long x : {root.u, root.v})
        if (!(x > near && x < 1 - near)) return true;
    return false;
}

} // namespace

RayScene::RayScene(SurfaceModel model, const TracerOptions& options)
    : model_(std::move(model)), tracer_(model_, options), size_(hull_bounds(model_).size()) {
    for (const Face& face : model_.faces) regions_.emplace_back(model_, face);
    for (std::uint32_t i = 0; i < model_.instances.size(); ++i) {
        const Instance& instance = model_.instances[i];
        const Part& part = model_.parts[instance.part];
        for (std::uint32_t f = part.first_face; f < part.first_face + part.face_count; ++f) {
            const Face& face = model_.faces[f];
            for (std::uint32_t p = 0; p < face.patch_count; ++p) {
                const std::uint32_t index = face.first_patch + p;
                patches_.push_back({i, index, ExactPatch(model_.patch(index), instance.transform)});
            }
        }
    }
}

std::optional<AimedRay> RayScene::aim(Random& random, RayClass kind) const {
    const std::size_t placed = pick(random, patches_.size());
    const Vec2 uv = random_place(random, kind);
    const ExactPatch& patch = patches_[placed].exact;
    const std::optional<Mark> mark = mark_at(patch, uv);
    const double away = size_ * std::pow(10, uniform(random, -1, 2));
    if (!mark) return std::nullopt;
    Ray ray = ray_at(*mark, kind, away, random);
    if (auto result = aimed(ray, kind, placed, uv)) return result;
    // A grazing ray may have been rounded clear of the surface: to one of both sides lies a ray
    // that meets it.
    const Vec3 start = ray.origin;
    for (const double units : {2, -2, 8, -8, 32, -32}) {
        ray.origin = start + mark->normal * (units * epsilon * (start.length() + size_));
        if (auto result = aimed(ray, kind, placed, uv)) return result;
    }
    return std::nullopt;
}

std::optional<AimedRay> RayScene::aimed(const Ray& ray, RayClass kind, std::size_t placed,
                                        const Vec2& uv) const {
    const std::optional<ExactRoot> root = exact_root(patches_[placed].exact, ray, uv);
    if (!root || !(root->t > 0)) return std::nullopt;
    AimedRay result{ray, kind, placed, *root, TrimSide::inside};
    if (at_rim(*root) && !settle_at_rim(result, uv))
        result.side = TrimSide::mixed;
    else if (!at_rim(*root) && !root->on_patch())
        return std::nullopt;
    else
        result.side = side_of(patches_[result.placed], result.root);
    return result;
}

/// A ray that crosses all neighbours at a shared border in the same sense cannot slip through
/// between them: whichever patch holds the exact root, it must be found. Otherwise (a crease viewed
/// edge-on) the root must be on the patch whose root it is.
bool RayScene::settle_at_rim(AimedRay& aimed, const Vec2& uv) const {
    const ExactRoot own = aimed.root;
    if (own.on_patch()) return true;
    const bool corner = (uv.x == 0 || uv.x == 1) && (uv.y == 0 || uv.y == 1);
    const std::vector<std::size_t> around = neighbours(aimed.placed, uv);
    bool same_sense = around.size() + 1 >= (corner ? 4u : 2u);
    for (const std::size_t n : around) {
        const PlacedPatch& next = patches_[n];
        const Vec2 face = model_.face_parameters(patches_[aimed.placed].patch, uv);
        const Patch& patch = model_.patches[next.patch];
        const Vec2 there(patch.map_u.to_patch(face.x), patch.map_v.to_patch(face.y));
        const std::optional<ExactRoot> root = exact_root(next.exact, aimed.ray, there);
        same_sense = same_sense && root && (root->sine > 0) == (own.sine > 0);
        if (!root || !root->on_patch()) continue;
        aimed.root = *root;
        aimed.placed = n;
        return true;
    }
    return same_sense;
}

std::vector<std::size_t> RayScene::neighbours(std::size_t placed, const Vec2& uv) const {
    const PlacedPatch& own = patches_[placed];
    const Patch& patch = model_.patches[own.patch];
    const Vec2 place = model_.face_parameters(own.patch, uv);
    std::vector<std::size_t> result;
    for (std::size_t n = 0; n < patches_.size(); ++n) {
        const Patch& other = model_.patches[patches_[n].patch];
        if (n == placed || patches_[n].instance != own.instance || other.face != patch.face)
            continue;
        Box2 domain;
        domain.extend(Vec2(other.map_u.begin, other.map_v.begin));
        domain.extend(Vec2(other.map_u.end, other.map_v.end));
        if (domain.padded(1e-12 * domain.size()).contains(place)) result.push_back(n);
    }
    return result;
}

/// The band beside a trim curve is the edge's own tolerance plus the possible error of a hit. That
/// error is rounding of some units in the last place of the coordinates across the ray. The angle
/// stretches it along the surface, as it does the tolerance.
TrimSide RayScene::side_of(const PlacedPatch& placed, const ExactRoot& root) const {
    const Patch& patch = model_.patches[placed.patch];
    const TrimRegion& region = regions_[patch.face];
    if (region.untrimmed()) return TrimSide::inside;
    const Vec2 uv(std::clamp(static_cast<double>(root.u), 0.0, 1.0),
                  std::clamp(static_cast<double>(root.v), 0.0, 1.0));
    const ExactPatch::Point p = placed.exact.at(root.u, root.v);
    const ParameterMetric metric(shortened(p.du) / patch.map_u.derivative(uv.x),
                                 shortened(p.dv) / patch.map_v.derivative(uv.y));
    const double sine = std::abs(static_cast<double>(root.sine));
    double band = 1e-11 * size_ + 64 * epsilon * (size_ + shortened(root.position).length()) / sine;
    const Face& face = model_.faces[patch.face];
    for (const TrimLoop& loop : model_.loops_of(face))
        for (const TrimCurve& curve : model_.curves_of(loop))
            if (curve.edge != no_index)
                band =
                    std::max(band, 1.01 * model_.edges[curve.edge].tolerance / sine + 1e-9 * size_);
    const Vec2 place = model_.face_parameters(placed.patch, uv);
    if (region.nearest_curve(place, metric, band)) return TrimSide::mixed;
    return region.contains(place) ? TrimSide::inside : TrimSide::outside;
}

/// The hit's own bound, and the reference's: the rays are taken as their doubles are, so their
/// construction has no rounding to be allowed for.
bool RayScene::covers(const Hit& hit, const PlacedPatch& placed, const ExactRoot& root) const {
    return hit.instance == placed.instance &&
           (lengthened(hit.position) - root.position).length() <=
               static_cast<Long>(hit.position_bound) + root.error;
}

/// Every hit within its bound of the ray, by rising t, and the nearest the first of them.
bool RayScene::sound(const Ray& ray, const std::vector<Hit>& hits) const {
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const LongVec3 position = lengthened(hits[i].position);
        const Long reference =
            8 * long_epsilon * ((position - lengthened(ray.origin)).length() + position.length());
        if (!(off_line(ray, position) <= static_cast<Long>(hits[i].position_bound) + reference))
            return false;
        if (i > 0 && !(hits[i - 1].t <= hits[i].t)) return false;
    }
    const std::optional<Hit> nearest = tracer_.nearest(ray);
    if (tracer_.any(ray) != !hits.empty() || nearest.has_value() != !hits.empty()) return false;
    if (!nearest || nearest->t == hits.front().t) return true;
    // The first of two hits of a seam may have been taken for the second.
    const Hit& first = hits.front();
    const bool seam = has(first.flags, HitFlags::seam) || has(nearest->flags, HitFlags::seam);
    return seam || (nearest->position - first.position).length() <=
                       nearest->position_bound + first.position_bound;
}

Verdict RayScene::judge(const AimedRay& aimed) const {
    const std::vector<Hit> hits = tracer_.all(aimed.ray);
    if (!sound(aimed.ray, hits)) return Verdict::wrong;
    const PlacedPatch& placed = patches_[aimed.placed];
    const bool covered = std::any_of(
        hits.begin(), hits.end(), [&](const Hit& hit) { return covers(hit, placed, aimed.root); });
    if (aimed.side == TrimSide::mixed) return Verdict::found;
    if (aimed.side == TrimSide::outside) {
        const bool there = std::any_of(hits.begin(), hits.end(), [&](const Hit& hit) {
            return hit.patch == placed.patch && covers(hit, placed, aimed.root);
        });
        return there ? Verdict::wrong : Verdict::found;
    }
    if (covered) return Verdict::found;
    const bool touches = std::any_of(hits.begin(), hits.end(), [](const Hit& hit) {
        return has(hit.flags, HitFlags::tangential);
    });
    return touches ? Verdict::undecided : Verdict::lost;
}

std::string RayScene::describe(const AimedRay& aimed) const {
    const std::vector<Hit> hits = tracer_.all(aimed.ray);
    const auto off = [&](const Hit& hit) {
        return (lengthened(hit.position) - aimed.root.position).length();
    };
    const auto nearest = std::min_element(
        hits.begin(), hits.end(), [&](const Hit& a, const Hit& b) { return off(a) < off(b); });
    char text[256];
    std::snprintf(text, sizeof text,
                  "patch %u uv (%.17Lg, %.17Lg), sine %.3Lg, t %.17Lg, reference within %.2Lg; "
                  "%zu hits",
                  patches_[aimed.placed].patch, aimed.root.u, aimed.root.v, aimed.root.sine,
                  aimed.root.t, aimed.root.error, hits.size());
    std::string result = text;
    if (nearest == hits.end()) return result;
    std::snprintf(
        text, sizeof text,
        ", closest on patch %u uv (%.17g, %.17g), flags %u, off by %.3Lg, its bound %.3g, "
        "off the ray by %.3Lg",
        nearest->patch, nearest->uv.x, nearest->uv.y, static_cast<unsigned>(nearest->flags),
        off(*nearest), nearest->position_bound, off_line(aimed.ray, lengthened(nearest->position)));
    return result + text;
}

Verdict RayScene::judge_by_brute_force(const Ray& ray) const {
    const std::vector<Hit> hits = tracer_.all(ray);
    for (const PlacedPatch& placed : patches_) {
        if (!model_.instances[placed.instance].transform.is_identity()) continue;
        for (const Vec2& uv : brute_force_roots(model_.patch(placed.patch), ray)) {
            const std::optional<ExactRoot> root = exact_root(placed.exact, ray, uv);
            if (!root || !root->on_patch() || root->t < static_cast<Long>(ray.t_min)) continue;
            if (side_of(placed, *root) != TrimSide::inside) continue;
            if (std::none_of(hits.begin(), hits.end(),
                             [&](const Hit& hit) { return covers(hit, placed, *root); }))
                return Verdict::lost;
        }
    }
    return Verdict::found;
}

} // namespace keiko::test
