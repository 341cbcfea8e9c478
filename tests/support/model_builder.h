#pragma once

#include "keiko/geometry/bezier/nurbs.h"
#include "keiko/geometry/model/surface_model.h"

#include <utility>
#include <vector>

namespace keiko::test {

/// Puts a SurfaceModel together by hand, face after face, all in one part.
class ModelBuilder {
public:
    ModelBuilder() {
        model_.format = "test";
        model_.parts.push_back({"part", 0, 0});
    }

    /// A face of one Bezier patch over `domain`; points u outer, weight 1. Without loops.
    std::uint32_t patch(int degree_u, int degree_v, const std::vector<Vec3>& points,
                        const Box2& domain = {Vec2(0), Vec2(1)}) {
        std::vector<Vec4> homogeneous;
        for (const Vec3& p : points) homogeneous.emplace_back(p.x, p.y, p.z, 1);
        return rational_patch(degree_u, degree_v, homogeneous, domain);
    }

    std::uint32_t rational_patch(int degree_u, int degree_v, const std::vector<Vec4>& points,
                                 const Box2& domain = {Vec2(0), Vec2(1)}) {
        begin_face();
        add_patch(degree_u, degree_v, points, domain);
        return last_face();
    }

    /// A flat rectangle from `origin` along `u` and `v`.
    std::uint32_t plane(const Vec3& origin, const Vec3& u, const Vec3& v) {
        return patch(1, 1, {origin, origin + v, origin + u, origin + u + v});
    }

    /// A face of every knot span of a B-spline surface. Without loops.
    std::uint32_t nurbs(const NurbsSurface& surface) {
        begin_face();
        for (const BezierPatchSpan& s : bezier_spans(surface))
            add_patch(surface.degree_u, surface.degree_v, s.points,
                      {Vec2(s.u_begin, s.v_begin), Vec2(s.u_end, s.v_end)});
        return last_face();
    }

    /// Adds a loop to the last face: its p-curves in order, each by its homogeneous points.
    void loop(const std::vector<std::vector<Vec3>>& curves, std::uint32_t edge = no_index) {
        model_.faces.back().loop_count += 1;
        model_.trim_loops.push_back({static_cast<std::uint32_t>(model_.trim_curves.size()),
                                     static_cast<std::uint32_t>(curves.size())});
        for (const auto& points : curves) {
            model_.trim_curves.push_back({static_cast<std::uint32_t>(model_.trim_points.size()),
                                          static_cast<std::uint16_t>(points.size() - 1), edge});
            model_.trim_points.insert(model_.trim_points.end(), points.begin(), points.end());
        }
    }

    /// Adds a loop of straight p-curves through the corners.
    void polygon(const std::vector<Vec2>& corners) {
        std::vector<std::vector<Vec3>> curves;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
            curves.push_back({Vec3(a.x, a.y, 1), Vec3(b.x, b.y, 1)});
        }
        loop(curves);
    }

    void instance(const Affine& transform) { model_.instances.push_back({0, "", transform}); }

    /// The model; placed once as it is unless instances were added.
    SurfaceModel build() const {
        SurfaceModel result = model_;
        result.parts[0].face_count = static_cast<std::uint32_t>(result.faces.size());
        if (result.instances.empty()) result.instances.push_back({0, "", {}});
        return result;
    }

private:
    void begin_face() {
        Face face;
        face.id = static_cast<std::uint32_t>(model_.faces.size() + 1);
        face.surface_kind = "b-spline";
        face.first_patch = static_cast<std::uint32_t>(model_.patches.size());
        face.first_loop = static_cast<std::uint32_t>(model_.trim_loops.size());
        model_.faces.push_back(face);
    }

    std::uint32_t last_face() const { return static_cast<std::uint32_t>(model_.faces.size() - 1); }

    void add_patch(int degree_u, int degree_v, const std::vector<Vec4>& points,
                   const Box2& domain) {
        model_.faces.back().patch_count += 1;
        using Kind = ParameterMap::Kind;
        model_.patches.push_back({last_face(),
                                  static_cast<std::uint32_t>(model_.control_points.size()),
                                  static_cast<std::uint16_t>(degree_u),
                                  static_cast<std::uint16_t>(degree_v),
                                  {Kind::affine, domain.lower.x, domain.upper.x},
                                  {Kind::affine, domain.lower.y, domain.upper.y}});
        model_.control_points.insert(model_.control_points.end(), points.begin(), points.end());
    }

    SurfaceModel model_;
};

} // namespace keiko::test
