#include "keiko/compare/outlines/outline_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

FaceFilter faces_named(const OutlineBody& body, std::size_t name) {
    return [&body, name](std::uint32_t face) { return body.placed_names[face] == name; };
}

/// The place of a hit on the material of its face.
Vec3 material_place(const OutlineBody& body, const Hit& hit, std::size_t name, double reach) {
    if (!has(hit.flags, HitFlags::seam)) return hit.position;
    return body.feet.border_foot(hit.position, reach, faces_named(body, name))
        .value_or(hit.position);
}

bool is_ground(const OutlineBody& body, const Hit& hit) {
    return body.ground && hit.face + 1 == body.visible_names.size();
}

} // namespace

double distance_to_same(const OutlineBody& body, const Hit& hit, const OutlineBody& other,
                        double reach) {
    if (is_ground(body, hit))
        return other.ground ? std::abs(hit.position.z - *other.ground) : infinity;
    const std::size_t name = body.visible_names[hit.face];
    const Vec3 place = material_place(body, hit, name, reach);
    const auto foot = other.feet.foot(place, reach, faces_named(other, name));
    return foot ? foot->distance : infinity;
}

double pixel_length(const Camera& camera, const Vec3& place) {
    if (camera.projection == Projection::orthographic) return camera.pixel_size();
    const Vec3 way = place - camera.eye;
    const double depth = way.dot(camera.axes().forward);
    // The plane at distance 1 shows what is square to a ray longer by 1 / cosine along the radius.
    return camera.pixel_size() * depth * depth / way.length();
}

OutlineFinder::OutlineFinder(const OutlineBody& body, const Camera& camera)
    : body_(body), camera_(camera), prepared_(camera) {}

std::vector<Sighting> OutlineFinder::look(std::span<const Vec2> places) const {
    const Rays rays = prepared_.rays(places);
    std::vector<std::optional<Hit>> hits = body_.tracer.nearest(rays);
    std::vector<Sighting> sightings(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t name = hits[i] ? body_.visible_names[hits[i]->face] : 0;
        sightings[i] = {places[i], std::move(hits[i]), name};
    }
    return sightings;
}

double OutlineFinder::facing(const Hit& hit) const {
    const Vec3 view = camera_.projection == Projection::orthographic
                          ? camera_.axes().forward
                          : (hit.position - camera_.eye).normalized();
    return std::abs(view.dot(hit.normal));
}

/// Smooth surface moves by no more than about twice a step in the picture over its cosine, even
/// beside a contour.
bool OutlineFinder::differ(const Sighting& a, const Sighting& b) const {
    if (!a.hit && !b.hit) return false;
    if (!a.hit || !b.hit || a.name != b.name) return true;
    constexpr double discontinuous = 4;
    const double step = (b.place - a.place).length() * pixel_length(camera_, a.hit->position);
    const double cosine = std::max(facing(*a.hit), facing(*b.hit));
    return (b.hit->position - a.hit->position).length() * cosine > discontinuous * step;
}

std::vector<OutlineFinder::Crossing> OutlineFinder::crossings(std::span<const Sighting> grid,
                                                              std::size_t side) const {
    std::vector<Crossing> found;
    const auto add = [&](std::size_t a, std::size_t b) {
        if (differ(grid[a], grid[b])) found.push_back({grid[a], grid[b]});
    };
    for (std::size_t i = 0; i < side; ++i)
        for (std::size_t j = 0; j + 1 < side; ++j) {
            add(i * side + j, i * side + j + 1);
            add(j * side + i, (j + 1) * side + i);
        }
    return found;
}

std::vector<OutlineFinder::Crossing> OutlineFinder::halved(std::vector<Crossing> crossings) const {
    std::vector<Vec2> middles;
    for (const Crossing& c : crossings) middles.push_back((c.a.place + c.b.place) / 2);
    const std::vector<Sighting> seen = look(middles);
    std::vector<Crossing> halves;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        if (differ(crossings[i].a, seen[i]))
            halves.push_back({crossings[i].a, seen[i]});
        else if (differ(seen[i], crossings[i].b))
            halves.push_back({seen[i], crossings[i].b});
    }
    return halves;
}

std::vector<Hit> OutlineFinder::outlines(std::span<const Sighting> grid, std::size_t side) const {
    constexpr int halvings = 11;
    std::vector<Crossing> found = crossings(grid, side);
    for (int i = 0; i < halvings && !found.empty(); ++i) found = halved(std::move(found));
    std::vector<Hit> hits;
    for (const Crossing& c : found)
        for (const Sighting* s : {&c.a, &c.b})
            if (s->hit) hits.push_back(*s->hit);
    return hits;
}

} // namespace keiko
