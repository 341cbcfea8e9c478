#include "tests/integration/closed_model.h"

#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/intersect/subpatch/traced_model.h"

#include "tests/support/ray_class.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <sstream>

namespace keiko::test {
namespace {

bool is_tangential(const std::vector<Hit>& hits) {
    return std::any_of(hits.begin(), hits.end(),
                       [](const Hit& hit) { return has(hit.flags, HitFlags::tangential); });
}

/// Point of a p-curve, by Bernstein sums.
Vec2 point_of(const BezierCurveView& curve, double t) {
    const int degree = static_cast<int>(curve.points.size()) - 1;
    const BernsteinRow row = bernstein_values(degree, t);
    Vec3 sum(0);
    for (std::size_t i = 0; i < curve.points.size(); ++i) sum += curve.points[i] * row[i];
    return {sum.x / sum.z, sum.y / sum.z};
}

/// The face's patch that holds a place of its parameters.
std::optional<std::uint32_t> patch_with(const SurfaceModel& model, const Face& face,
                                        const Vec2& place) {
    for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p) {
        const Patch& patch = model.patches[p];
        Box2 domain;
        domain.extend(Vec2(patch.map_u.begin, patch.map_v.begin));
        domain.extend(Vec2(patch.map_u.end, patch.map_v.end));
        if (domain.padded(1e-9 * domain.size()).contains(place)) return p;
    }
    return std::nullopt;
}

/// Whether the file leaves more open than is sealed.
bool is_open(const SeamGap& gap) {
    return std::any_of(gap.samples.begin(), gap.samples.end(),
                       [&](const SeamGap::Sample& s) { return s.across.length() > gap.width; });
}

/// Whether the line of the ray passes all three sides on one hand.
bool line_meets(const Ray& ray, const std::array<Vec3, 3>& triangle) {
    std::array<double, 3> volumes{};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 from = triangle[i] - ray.origin, to = triangle[(i + 1) % 3] - ray.origin;
        volumes[i] = ray.direction.dot(from.cross(to));
    }
    return std::all_of(volumes.begin(), volumes.end(), [](double v) { return v >= 0; }) ||
           std::all_of(volumes.begin(), volumes.end(), [](double v) { return v <= 0; });
}

bool line_meets(const Ray& ray, const std::array<std::array<Vec3, 3>, 2>& triangles) {
    return line_meets(ray, triangles[0]) || line_meets(ray, triangles[1]);
}

} // namespace

std::string ClosureCounts::text() const {
    std::ostringstream out;
    out << rays << " rays, " << hits << " hits, tangential " << tangential << ", edge-on "
        << edge_on << ", leaks " << leaks << ", doubled " << doubled << ", through steps "
        << through_steps << ", unclear " << unclear << ", out of order " << out_of_order << "; "
        << aimed << " aimed at edges and vertices, lost " << aimed_lost;
    return out.str();
}

ClosedModel::ClosedModel(SurfaceModel model)
    : model_(std::move(model)), tracer_(model_), size_(hull_bounds(model_).size()) {
    for (std::uint32_t i = 0; i < model_.instances.size(); ++i) {
        const Part& part = model_.parts[model_.instances[i].part];
        for (std::uint32_t f = part.first_face; f < part.first_face + part.face_count; ++f)
            for (const TrimLoop& loop : model_.loops_of(model_.faces[f]))
                for (std::uint32_t c = 0; c < loop.curve_count; ++c) {
                    const std::uint32_t edge = model_.trim_curves[loop.first_curve + c].edge;
                    if (edge == no_index || model_.edges[edge].degenerate) continue;
                    borders_.push_back({i, f, loop.first_curve + c});
                }
    }
    const std::vector<SeamGap> gaps = seam_gaps(model_, TracerOptions().join, {});
    for (const SeamGap& gap : gaps) widest_seam_ = std::max(widest_seam_, gap.width);
    for (const BorderCurve& border : borders_) add_strip(border, gaps[border.curve]);
}

Ray ClosedModel::random_ray(Random& random) const {
    const Box3& box = tracer_.bounds();
    const auto inside = [&] {
        return box.lower + box.extent() * Vec3(uniform(random, 0, 1), uniform(random, 0, 1),
                                               uniform(random, 0, 1));
    };
    Ray ray;
    do ray.direction = inside() - inside();
    while (!(ray.direction.length() > 1e-3 * size_));
    ray.direction.normalize();
    ray.origin = inside() - ray.direction * (2 * size_);
    return ray;
}

void ClosedModel::add_strip(const BorderCurve& border, const SeamGap& gap) {
    const Affine& to_world = model_.instances[border.instance].transform;
    for (std::size_t i = 0; i + 1 < gap.samples.size(); ++i) {
        const SeamGap::Sample &a = gap.samples[i], &b = gap.samples[i + 1];
        const Vec3 near_a = to_world.point(a.border), far_a = to_world.point(a.border + a.across);
        const Vec3 near_b = to_world.point(b.border), far_b = to_world.point(b.border + b.across);
        const double middle = (double(i) + 0.5) / double(gap.samples.size() - 1);
        const auto beside = edge_point(border, middle);
        strips_.push_back({{{{near_a, near_b, far_a}, {far_a, near_b, far_b}}},
                           beside ? std::optional(beside->normal) : std::nullopt,
                           is_open(gap)});
    }
}

std::optional<EdgePoint> ClosedModel::random_edge_point(Random& random) const {
    const BorderCurve& border = borders_[pick(random, borders_.size())];
    return edge_point(border, random() % 4 == 0 ? 0 : uniform(random, 0, 1));
}

std::optional<EdgePoint> ClosedModel::edge_point(const BorderCurve& border, double t) const {
    const Face& face = model_.faces[border.face];
    const Vec2 place = point_of(model_.trim_curve(border.curve), t);
    const auto patch = patch_with(model_, face, place);
    if (!patch) return std::nullopt;
    const Patch& maps = model_.patches[*patch];
    const Vec2 uv(std::clamp(maps.map_u.to_patch(place.x), 0.0, 1.0),
                  std::clamp(maps.map_v.to_patch(place.y), 0.0, 1.0));
    const SurfaceDerivatives s = evaluate(model_.patch(*patch), uv, 2);
    const auto normal = unit_normal(s, uv);
    if (!normal) return std::nullopt;
    const Affine& to_world = model_.instances[border.instance].transform;
    return EdgePoint{to_world.point(s.position()), to_world.normal(*normal).normalized()};
}

void ClosedModel::count_parity(const Ray& ray, ClosureCounts& counts) const {
    const std::vector<Hit> hits = tracer_.all(ray);
    ++counts.rays;
    counts.hits += hits.size();
    if (is_tangential(hits))
        ++counts.tangential;
    else if (hits.size() % 2 != 0)
        classify_odd(ray, hits.size(), counts);
    else if (!in_order(hits, ray))
        report("out of order", ray), ++counts.out_of_order;
}

/// Inside and outside are as the file turns the face.
bool ClosedModel::leaves(const Hit& hit, const Ray& ray) const {
    const Patch& patch = model_.patches[hit.patch];
    const double turned = patch.map_u.derivative(hit.uv.x) * patch.map_v.derivative(hit.uv.y);
    bool outward = (turned < 0) == model_.faces[patch.face].reversed;
    if (model_.instances[hit.instance].transform.mirrored()) outward = !outward;
    return (hit.normal.dot(ray.direction) > 0) == outward;
}

/// Never left more often than entered, and as often in the end. Hits closer together than 1e-6 of
/// the size may come in any order.
bool ClosedModel::in_order(const std::vector<Hit>& hits, const Ray& ray) const {
    int depth = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        depth += leaves(hits[i], ray) ? -1 : 1;
        const bool apart = i + 1 == hits.size() || hits[i + 1].t - hits[i].t > 1e-6 * size_;
        if (apart && depth < 0) return false;
    }
    return depth == 0;
}

std::array<std::size_t, 4> ClosedModel::hits_beside(const Ray& ray, double away) const {
    const Vec3 helper = std::abs(ray.direction.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 a = ray.direction.cross(helper).normalized(), b = ray.direction.cross(a);
    std::array<std::size_t, 4> hits{};
    const std::array<Vec3, 4> sides{a, -a, b, -b};
    for (std::size_t i = 0; i < 4; ++i) {
        Ray beside = ray;
        beside.origin += sides[i] * away;
        hits[i] = tracer_.all(beside).size();
    }
    return hits;
}

bool ClosedModel::passes_step(const Ray& ray) const {
    return std::any_of(strips_.begin(), strips_.end(),
                       [&](const Strip& strip) { return line_meets(ray, strip.triangles); });
}

/// Through what is not sealed against such a ray.
bool ClosedModel::passes_opening(const Ray& ray) const {
    constexpr double lowest = 1 / seam_depth; // sine of the angle to the face
    return std::any_of(strips_.begin(), strips_.end(), [&](const Strip& strip) {
        const bool low = strip.normal && std::abs(strip.normal->dot(ray.direction)) < lowest;
        return (strip.open || low) && line_meets(ray, strip.triangles);
    });
}

/// By four parallel rays around it. Where the ray passes an edge seen edge-on, they are crossed an
/// even number of times, but not all the same number: what lies within the seam is
/// there or not. Where the ray slips through a seam, all of them have the hit that it lacks.
void ClosedModel::classify_odd(const Ray& ray, std::size_t hits, ClosureCounts& counts) const {
    const double rounding = 1e-7 * size_;
    for (const double away : {widest_seam_ / 8, widest_seam_, 4 * widest_seam_}) {
        const auto beside = hits_beside(ray, away + rounding);
        const bool even =
            std::all_of(beside.begin(), beside.end(), [](std::size_t n) { return n % 2 == 0; });
        const auto [least, most] = std::minmax_element(beside.begin(), beside.end());
        if (even && *least != *most) {
            ++counts.edge_on;
            return;
        }
    }
    const auto beside = hits_beside(ray, 4 * widest_seam_ + rounding);
    const auto all = [&](std::size_t n) {
        return std::count(beside.begin(), beside.end(), n) == 4;
    };
    if (passes_opening(ray))
        report("through an opening", ray), ++counts.through_steps;
    else if (all(hits + 1))
        report("leak", ray), ++counts.leaks;
    else if (all(hits - 1) && passes_step(ray))
        report("through a step", ray), ++counts.through_steps;
    else if (all(hits - 1))
        report("doubled hit", ray), ++counts.doubled;
    else
        report("unclear", ray), ++counts.unclear;
}

void ClosedModel::count_aimed(const EdgePoint& point, Random& random, ClosureCounts& counts) const {
    constexpr double flattest = 0.05; // sine of the angle to the surface
    Ray ray;
    do ray.direction = random_direction(random);
    while (!(std::abs(ray.direction.dot(point.normal)) > flattest));
    ray.origin = point.position - ray.direction * (2 * size_);
    const std::vector<Hit> hits = tracer_.all(ray);
    ++counts.aimed;
    // The hit may be on the neighbour's side of the edge, or of another edge that ends here. A ray
    // through the point meets a surface that passes it within d mm no farther off than d over the
    // sine of the angle between them. The neighbour may be met at a lower angle than the face that
    // was aimed at. What all() takes for one crossing is up to two widths apart.
    if (std::any_of(hits.begin(), hits.end(), [&](const Hit& hit) {
            const double sine = std::min(flattest, std::abs(hit.normal.dot(ray.direction)));
            return (hit.position - point.position).length() * sine <=
                   2 * widest_seam_ + 1e-9 * size_;
        }))
        return;
    ++counts.aimed_lost;
    report("lost at an edge", ray);
}

void ClosedModel::report(const char* what, const Ray& ray) const {
    std::cout << what << ": " << exact_text(ray) << "\n";
}

} // namespace keiko::test
