#include "keiko/workflow/luminous_panels.h"

#include "keiko/geometry/bezier/bezier.h"
#include "keiko/geometry/model/outward_side.h"
#include "keiko/geometry/model/patch_grid.h"
#include "keiko/maps/surface_maps.h"
#include "keiko/math/bounds.h"
#include "keiko/math/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace keiko {
namespace {

using Triangle = std::array<std::uint32_t, 3>;
using Uv = std::array<Vec2, 3>; ///< corners of a triangle in face parameters

/// A face of a placed model and its triangles, outwards.
class LuminousFace {
public:
    LuminousFace(const SurfaceModel& model, const Face& face, const FaceMesh& mesh)
        : model_(model), grid_(model, face), mesh_(mesh), triangles_(mesh.triangles) {
        for (const Vec2& uv : mesh.uv) corners_.push_back(at(uv).position);
        if (face.reversed)
            for (Triangle& triangle : triangles_) std::swap(triangle[1], triangle[2]);
    }

    std::vector<PolygonLight> panels(const Rgb& luminance) const {
        if (const auto outline = flat_outline()) return {panel(*outline, luminance)};
        return panels_of(triangles_in_uv(), [&](const Uv&) { return luminance; });
    }
    /// Panels whose luminance maps vary: it is their mean over each of smaller triangles.
    std::vector<PolygonLight> panels(const Rgb& luminance, const SurfaceMaps& maps,
                                     const FaceParameters& parameters) const {
        Box3 box;
        for (const Vec3& corner : corners_) box.extend(corner);
        std::vector<Uv> cells;
        for (const Uv& uv : triangles_in_uv()) divide(uv, box.size() * largest_cell, cells);
        return panels_of(cells, [&](const Uv& uv) {
            return luminance * maps.values(place_on(uv, parameters)).emission;
        });
    }

private:
    struct Place {
        Vec3 position{0};
        double area = 0; ///< mm2 by the face's parameters
    };

    static constexpr double largest_cell = 1.0 / 6; ///< of the face's size

    Place at(const Vec2& uv) const {
        const auto [patch, own] = place_at(model_, grid_, uv);
        const SurfaceDerivatives s = evaluate(model_.patch(patch), own, 1);
        const Patch& p = model_.patches[patch];
        const double by_face = p.map_u.derivative(own.x) * p.map_v.derivative(own.y);
        return {s.position(), s.du().cross(s.dv()).length() / std::abs(by_face)};
    }
    std::vector<Uv> triangles_in_uv() const {
        std::vector<Uv> all;
        for (const auto& [a, b, c] : triangles_)
            all.push_back({mesh_.uv[a], mesh_.uv[b], mesh_.uv[c]});
        return all;
    }
    /// Panels of triangles, of a luminance each, that send the flux of the exact surface together.
    template <class LuminanceOf>
    std::vector<PolygonLight> panels_of(const std::vector<Uv>& triangles,
                                        const LuminanceOf& luminance_of) const {
        std::vector<PolygonLight> panels;
        double flat = 0, curved = 0; // mm2
        for (const Uv& uv : triangles) {
            panels.push_back(panel({at(uv[0]).position, at(uv[1]).position, at(uv[2]).position},
                                   luminance_of(uv)));
            flat += polygon_normal(panels.back().corners).length() / 2;
            curved += area_of(uv);
        }
        for (PolygonLight& panel : panels) panel.luminance *= curved / flat;
        return panels;
    }
    /// Halves the sides of a triangle until none is longer than `longest`, in mm.
    void divide(const Uv& uv, double longest, std::vector<Uv>& cells) const {
        double side = 0;
        for (std::size_t i = 0; i < 3; ++i)
            side = std::max(side, (at(uv[i]).position - at(uv[(i + 1) % 3]).position).length());
        if (!(side > longest)) return cells.push_back(uv);
        const auto& [a, b, c] = uv;
        const Vec2 ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
        for (const Uv& part : {Uv{a, ab, ca}, Uv{ab, b, bc}, Uv{ca, bc, c}, Uv{ab, bc, ca}})
            divide(part, longest, cells);
    }
    /// The middle of a triangle, with a footprint of its area.
    MapPlace place_on(const Uv& uv, const FaceParameters& parameters) const {
        const auto [patch, own] = place_at(model_, grid_, (uv[0] + uv[1] + uv[2]) / 3);
        const SurfaceDerivatives s = evaluate(model_.patch(patch), own, 1);
        const Vec3 u = s.du().normalized(), v = s.du().cross(s.dv()).cross(s.du()).normalized();
        const double side = std::sqrt(area_of(uv));
        return {s.position(),
                s.du().cross(s.dv()).normalized() * outward_side(model_, 0, patch, own),
                parameters.at(patch, own, s.du(), s.dv()), u * side, v * side};
    }
    /// Area of the exact surface of a triangle, by the middles of its sides.
    double area_of(const Uv& uv) const {
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i) sum += at((uv[i] + uv[(i + 1) % 3]) / 2).area / 3;
        return sum * std::abs((uv[1] - uv[0]).cross(uv[2] - uv[0])) / 2;
    }
    static PolygonLight panel(std::vector<Vec3> corners, const Rgb& luminance) {
        return {.corners = std::move(corners), .luminance = luminance, .shown = false};
    }

    /// The sides that only one triangle has, by their first corner, if each begins but one.
    std::optional<std::map<std::uint32_t, std::uint32_t>> border() const {
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
        for (const Triangle& triangle : triangles_)
            for (std::size_t i = 0; i < 3; ++i) ++sides[{triangle[i], triangle[(i + 1) % 3]}];
        std::map<std::uint32_t, std::uint32_t> next;
        for (const auto& [side, count] : sides)
            if (!sides.contains({side.second, side.first}))
                if (!next.emplace(side).second) return std::nullopt;
        return next;
    }
    bool is_flat() const {
        constexpr double rounding = 1e-9; // of the face's size
        Vec3 normal(0);
        double size = 0;
        for (const auto& [a, b, c] : triangles_)
            normal += (corners_[b] - corners_[a]).cross(corners_[c] - corners_[a]);
        for (const Vec3& at : corners_) size = std::max(size, (at - corners_[0]).length());
        normal.normalize();
        return std::all_of(corners_.begin(), corners_.end(), [&](const Vec3& at) {
            return std::abs(normal.dot(at - corners_[0])) <= rounding * size;
        });
    }
    /// The outline of a flat face without holes, if it has at most as many corners as panels may.
    std::optional<std::vector<Vec3>> flat_outline() const {
        constexpr std::size_t most = 1000;
        const auto next = border();
        if (!next || next->size() < 3 || next->size() > most || !is_flat()) return std::nullopt;
        std::vector<Vec3> outline;
        std::uint32_t corner = next->begin()->first;
        do {
            outline.push_back(corners_[corner]);
            const auto found = next->find(corner);
            if (found == next->end()) return std::nullopt;
            corner = found->second;
        } while (corner != next->begin()->first && outline.size() <= next->size());
        if (outline.size() != next->size()) return std::nullopt;
        return outline;
    }

    const SurfaceModel& model_;
    PatchGrid grid_;
    const FaceMesh& mesh_;
    std::vector<Triangle> triangles_;
    std::vector<Vec3> corners_;
};

} // namespace

std::vector<PolygonLight> luminous_panels(const SurfaceModel& placed, const Face& face,
                                          const FaceMesh& mesh, const Material& material,
                                          const FaceParameters& parameters) {
    const LuminousFace luminous(placed, face, mesh);
    std::vector<PolygonLight> panels =
        has_emission_map(material)
            ? luminous.panels(material.emits, SurfaceMaps(material.maps), parameters)
            : luminous.panels(material.emits);
    for (PolygonLight& panel : panels) panel.two_sided = material.emits_both_ways;
    return panels;
}

} // namespace keiko
