#include "keiko/radiosity/element_subdivision.h"

#include "keiko/base/error.h"
#include "keiko/raster/span_mesh.h"

#include <algorithm>
#include <tuple>

namespace keiko {

ElementSubdivision::ElementSubdivision(const SurfaceModel& model, double deviation,
                                       const std::vector<bool>& left_out, const Job& job)
    : model_(model) {
    const ModelMesh meshes = span_mesh(model, deviation, job);
    grids_.reserve(model.faces.size());
    for (const Face& face : model.faces) grids_.emplace_back(model, face);
    for (std::uint32_t i = 0; i < model.instances.size(); ++i) {
        const Part& part = model.parts[model.instances[i].part];
        for (std::uint32_t f = part.first_face; f < part.first_face + part.face_count; ++f)
            if (!left_out[f]) add_face(i, f, meshes[f]);
    }
    elements_.mesh.deviation = deviation;
    if (elements_.size() > most_triangles)
        throw FieldError("deviation", "needs " + std::to_string(elements_.size()) +
                                          " triangles, of at most " +
                                          std::to_string(most_triangles) + "; take a larger one");
}

std::uint64_t ElementSubdivision::key(std::uint32_t a, std::uint32_t b) {
    return (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
}

std::uint32_t ElementSubdivision::add_corner(std::uint32_t instance, std::uint32_t face,
                                             const Vec2& uv) {
    const PatchPlace place = place_at(model_, grids_[face], uv);
    const Vec3 position = evaluate(model_.patch(place.patch), place.uv, 0).position();
    elements_.mesh.positions.push_back(model_.instances[instance].transform.point(position));
    elements_.uv.push_back(uv);
    return static_cast<std::uint32_t>(elements_.uv.size() - 1);
}

void ElementSubdivision::add_face(std::uint32_t instance, std::uint32_t face,
                                  const FaceMesh& triangles) {
    const auto first = static_cast<std::uint32_t>(elements_.uv.size());
    for (const Vec2& uv : triangles.uv) add_corner(instance, face, uv);
    const bool turned =
        model_.faces[face].reversed != model_.instances[instance].transform.mirrored();
    for (auto [a, b, c] : triangles.triangles) {
        if (turned) std::swap(b, c);
        add_triangle({first + a, first + b, first + c}, face, instance);
    }
}

/// Triangles without area, as at poles, are none.
void ElementSubdivision::add_triangle(const std::array<std::uint32_t, 3>& corners,
                                      std::uint32_t face, std::uint32_t instance) {
    constexpr double rounding = 1e-12;
    const auto number = static_cast<std::uint32_t>(elements_.size());
    elements_.mesh.triangles.push_back(corners);
    const double side = elements_.longest_side(number);
    if (!(elements_.area(number) > rounding * side * side)) {
        elements_.mesh.triangles.pop_back();
        return;
    }
    elements_.mesh.faces.push_back(face);
    elements_.instances.push_back(instance);
    elements_.elements.push_back(number);
    for (unsigned i = 0; i < 3; ++i) replace(corners[i], corners[(i + 1) % 3], no_index, number);
}

/// The longest side, from corner i to the next. Of equal ones that of the first corners, so that
/// both triangles at a side agree.
unsigned ElementSubdivision::longest(std::uint32_t triangle) const {
    const auto& corners = elements_.mesh.triangles[triangle];
    const auto rank = [&](unsigned i) {
        const std::uint32_t a = corners[i], b = corners[(i + 1) % 3];
        const auto& [low, high] = std::minmax(a, b);
        const Vec3 way = elements_.mesh.positions[high] - elements_.mesh.positions[low];
        return std::make_tuple(way.length2(), key(a, b));
    };
    unsigned found = 0;
    for (const unsigned i : {1U, 2U})
        if (rank(i) > rank(found)) found = i;
    return found;
}

std::uint32_t ElementSubdivision::across(std::uint32_t triangle, unsigned side) const {
    const auto& corners = elements_.mesh.triangles[triangle];
    const Sides& at = sides_.at(key(corners[side], corners[(side + 1) % 3]));
    if (at[0] == triangle) return at[1];
    return at[1] == triangle ? at[0] : no_index;
}

/// Puts one triangle in the place of another, or of none, at a side. A third one there, as some
/// trims make, has no neighbour.
void ElementSubdivision::replace(std::uint32_t a, std::uint32_t b, std::uint32_t old,
                                 std::uint32_t by) {
    Sides& at = sides_.try_emplace(key(a, b), Sides{no_index, no_index}).first->second;
    if (at[0] == old)
        at[0] = by;
    else if (at[1] == old)
        at[1] = by;
}

void ElementSubdivision::bisect(std::uint32_t triangle, std::vector<std::uint32_t>& changed) {
    const unsigned side = longest(triangle);
    std::uint32_t other = across(triangle, side);
    while (other != no_index && across(other, longest(other)) != triangle) {
        bisect(other, changed);
        other = across(triangle, side);
    }
    const auto corners = elements_.mesh.triangles[triangle];
    const Vec2 uv = (elements_.uv[corners[side]] + elements_.uv[corners[(side + 1) % 3]]) / 2;
    const std::uint32_t middle =
        add_corner(elements_.instances[triangle], elements_.mesh.faces[triangle], uv);
    const unsigned of_other = other != no_index ? longest(other) : 0;
    split(triangle, side, middle, changed);
    if (other != no_index) split(other, of_other, middle, changed);
}

/// Makes two of a triangle: one keeps its number.
void ElementSubdivision::split(std::uint32_t triangle, unsigned side, std::uint32_t middle,
                               std::vector<std::uint32_t>& changed) {
    if (elements_.size() >= most_triangles)
        throw FieldError("element", "needs more than " + std::to_string(most_triangles) +
                                        " triangles; take a larger one");
    const auto corners = elements_.mesh.triangles[triangle];
    const std::uint32_t a = corners[side], b = corners[(side + 1) % 3], c = corners[(side + 2) % 3];
    const auto added = static_cast<std::uint32_t>(elements_.size());
    elements_.mesh.triangles[triangle] = {a, middle, c};
    elements_.mesh.triangles.push_back({middle, b, c});
    elements_.mesh.faces.push_back(elements_.mesh.faces[triangle]);
    elements_.instances.push_back(elements_.instances[triangle]);
    elements_.elements.push_back(elements_.elements[triangle]);
    replace(a, middle, no_index, triangle);
    replace(middle, b, no_index, added);
    replace(b, c, triangle, added);
    replace(middle, c, no_index, triangle);
    replace(middle, c, no_index, added);
    if (!(std::min(elements_.area(triangle), elements_.area(added)) > 0))
        throw FieldError("element", "leaves triangles without area; take a larger one");
    changed.insert(changed.end(), {triangle, added});
}

std::vector<std::uint32_t> ElementSubdivision::cut(
    const std::function<bool(std::uint32_t)>& wanted) {
    std::vector<std::uint32_t> changed;
    for (std::uint32_t t = 0; t < elements_.size(); ++t)
        while (wanted(t)) bisect(t, changed);
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    return changed;
}

std::vector<std::array<std::uint32_t, 2>> ElementSubdivision::neighbours() const {
    std::vector<std::array<std::uint32_t, 2>> pairs;
    for (std::uint32_t t = 0; t < elements_.size(); ++t)
        for (unsigned side = 0; side < 3; ++side)
            if (const std::uint32_t other = across(t, side); other != no_index && t < other)
                pairs.push_back({t, other});
    return pairs;
}

} // namespace keiko
