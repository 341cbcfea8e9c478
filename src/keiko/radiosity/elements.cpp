#include "keiko/radiosity/elements.h"

#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/radiosity/hemisphere_directions.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {

Elements::Elements(const SurfaceModel& model, const ElementMesh& mesh)
    : model_(model), mesh_(mesh), triangles_(mesh.size()) {
    grids_.reserve(model.faces.size());
    for (const Face& face : model.faces) grids_.emplace_back(model, face);
    std::uint32_t count = 0;
    for (const std::uint32_t element : mesh.elements) count = std::max(count, element + 1);
    first_.resize(count + 1);
    areas_.resize(count);
    for (const std::uint32_t element : mesh.elements) ++first_[element + 1];
    for (std::size_t e = 0; e < count; ++e) first_[e + 1] += first_[e];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t t = 0; t < mesh.size(); ++t) {
        triangles_[next[mesh.elements[t]]++] = t;
        areas_[mesh.elements[t]] += mesh.area(t);
    }
}

std::span<const std::uint32_t> Elements::triangles(std::size_t element) const {
    return std::span(triangles_).subspan(first_[element], first_[element + 1] - first_[element]);
}

double Elements::extent(std::size_t element) const {
    const auto all = triangles(element);
    if (all.size() == 1) return mesh_.longest_side(all[0]);
    Box3 box;
    for (const std::uint32_t t : all)
        for (std::size_t i = 0; i < 3; ++i) box.extend(mesh_.corner(t, i));
    return box.extent().length();
}

LightPoint Elements::point_of_triangle(std::uint32_t triangle, const Vec3& shares) const {
    const auto& [a, b, c] = mesh_.mesh.triangles[triangle];
    const Vec2 uv = mesh_.uv[a] * shares.x + mesh_.uv[b] * shares.y + mesh_.uv[c] * shares.z;
    const PatchPlace place = place_at(model_, grids_[mesh_.mesh.faces[triangle]], uv);
    const Affine& placed = model_.instances[mesh_.instances[triangle]].transform;
    const SurfaceDerivatives s = evaluate(model_.patch(place.patch), place.uv, 2);
    const Vec3 flat = mesh_.normal(triangle).normalized();
    Vec3 normal = flat; // of a pole without one
    if (const auto own = robust_normal(s, place.uv)) normal = placed.normal(*own).normalized();
    constexpr double certain = 1e-9; // patch parameters are exact here
    return {placed.point(s.position()), normal.dot(flat) < 0 ? -normal : normal,
            Root{mesh_.instances[triangle], place.patch,
                 Box2{place.uv - Vec2(certain), place.uv + Vec2(certain)}}};
}

LightPoint Elements::point(std::size_t element, const Vec2& place) const {
    const auto all = triangles(element);
    double left = place.x * areas_[element];
    std::size_t i = 0;
    for (; i + 1 < all.size() && left > mesh_.area(all[i]); ++i) left -= mesh_.area(all[i]);
    const double away = std::sqrt(std::clamp(left / mesh_.area(all[i]), 0.0, 1.0));
    return point_of_triangle(all[i], {1 - away, away * (1 - place.y), away * place.y});
}

std::vector<ElementPoint> Elements::spread(std::size_t element, double small) const {
    const auto all = triangles(element);
    std::vector<ElementPoint> points;
    if (extent(element) < small) return {{point(element, Vec2(0.5)), 1}};
    if (all.size() == 1) { // the middles of its quarters
        constexpr double two_thirds = 2.0 / 3, sixth = 1.0 / 6, quarter = 0.25;
        for (const Vec3& shares : {Vec3(1.0 / 3), Vec3(two_thirds, sixth, sixth),
                                   Vec3(sixth, two_thirds, sixth), Vec3(sixth, sixth, two_thirds)})
            points.push_back({point_of_triangle(all[0], shares), quarter});
        return points;
    }
    constexpr std::size_t most_middles = 6;
    if (all.size() <= most_middles) {
        for (const std::uint32_t t : all)
            points.push_back(
                {point_of_triangle(t, Vec3(1.0 / 3)), mesh_.area(t) / areas_[element]});
        return points;
    }
    constexpr int count = 4;
    const HemisphereDirections places(element);
    for (std::uint32_t i = 0; i < count; ++i)
        points.push_back({point(element, places.place(i)), 1.0 / count});
    return points;
}

} // namespace keiko
