#include "keiko/inspect/basics/placed_face.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace keiko {

std::string placed_face_name(const SurfaceModel& model, std::uint32_t instance,
                             std::uint32_t face) {
    std::string text = model.describe(model.faces[face]);
    if (model.instances.size() < 2) return text;
    const std::string number = "instance " + std::to_string(instance + 1);
    const std::string& name = model.instances[instance].name;
    if (name.empty()) return text + " of " + number;
    const bool only = std::count_if(model.instances.begin(), model.instances.end(),
                                    [&](const Instance& i) { return i.name == name; }) == 1;
    return text + " of " + name + (only ? "" : ", " + number);
}

std::string faces_at_seam(const SurfaceModel& model, const PlacedFace& a, const PlacedFace& b) {
    std::string text = placed_face_name(model, a.instance, a.face);
    text += between_faces;
    return text + placed_face_name(model, b.instance, b.face);
}

std::string line_inside_face(const SurfaceModel& model, const PlacedFace& of, bool constant_u,
                             double at) {
    std::array<char, 48> place{};
    std::snprintf(place.data(), place.size(), ", inside at %c = %.6g", constant_u ? 'u' : 'v', at);
    return placed_face_name(model, of.instance, of.face) + place.data();
}

SurfaceDerivatives placed_derivatives(const SurfaceModel& model, std::uint32_t instance,
                                      std::uint32_t patch, const Vec2& uv) {
    SurfaceDerivatives s = evaluate(model.patch(patch), uv, 3);
    const Affine& placed = model.instances[instance].transform;
    for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t l = 0; k + l < 4; ++l) s.d[k][l] = placed.vector(s.d[k][l]);
    s.d[0][0] += placed.translation;
    return s;
}

PlacedPatch::PlacedPatch(const SurfaceModel& model, std::uint32_t patch, const Affine& placed)
    : index(patch) {
    double weight = 0;
    for (const Vec4& p : model.patch(patch).points) {
        points.push_back(placed.homogeneous(p));
        const Vec4& q = points.back();
        box.extend(euclidean(q));
        weight = std::max(weight, q.w);
    }
    middle = box.center();
    for (Vec4& p : points) p -= Vec4(middle.x * p.w, middle.y * p.w, middle.z * p.w, 0);
    constexpr double relative_rounding = 2.5e-16;
    const double reach = std::max({std::abs(middle.x), std::abs(middle.y), std::abs(middle.z)});
    rounding = relative_rounding * (reach + box.extent().length()) * weight;
}

} // namespace keiko
