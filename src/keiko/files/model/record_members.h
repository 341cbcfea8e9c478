#pragma once

#include "keiko/geometry/model/surface_model.h"

#include <concepts>
#include <tuple>

namespace keiko {

template <class T, class Of>
concept Is = std::same_as<std::remove_const_t<T>, Of>;

// The members of each record of a SurfaceModel in the order in which they are written. One list
// serves reading and writing, so that the two cannot differ.

auto members(Is<Vec2> auto& v) {
    return std::tie(v.x, v.y);
}
auto members(Is<Vec3> auto& v) {
    return std::tie(v.x, v.y, v.z);
}
auto members(Is<Vec4> auto& v) {
    return std::tie(v.x, v.y, v.z, v.w);
}
auto members(Is<Rgb> auto& c) {
    return std::tie(c.r, c.g, c.b);
}
auto members(Is<Affine> auto& a) {
    return std::tie(a.rows[0], a.rows[1], a.rows[2], a.translation);
}
auto members(Is<ParameterMap> auto& m) {
    return std::tie(m.kind, m.begin, m.end);
}
auto members(Is<Patch> auto& p) {
    return std::tie(p.face, p.first_point, p.degree_u, p.degree_v, p.map_u, p.map_v);
}
auto members(Is<TrimCurve> auto& c) {
    return std::tie(c.first_point, c.degree, c.edge);
}
auto members(Is<TrimLoop> auto& l) {
    return std::tie(l.first_curve, l.curve_count);
}
auto members(Is<Face> auto& f) {
    return std::tie(f.id, f.name, f.layer, f.color, f.surface_kind, f.part, f.first_patch,
                    f.patch_count, f.first_loop, f.loop_count, f.reversed, f.approximated, f.line);
}
auto members(Is<Edge> auto& e) {
    return std::tie(e.tolerance, e.use_count, e.degenerate);
}
auto members(Is<Part> auto& p) {
    return std::tie(p.name, p.first_face, p.face_count);
}
auto members(Is<Instance> auto& i) {
    return std::tie(i.part, i.name, i.transform);
}
auto members(Is<LostFace> auto& f) {
    return std::tie(f.id, f.name, f.reason);
}
auto members(Is<IrregularPatch> auto& p) {
    return std::tie(p.face, p.center, p.radius);
}
auto members(Is<Repair> auto& r) {
    return std::tie(r.face, r.kind, r.count, r.size, r.detail);
}
auto members(Is<Diagnostic> auto& d) {
    return std::tie(d.severity, d.entity, d.message);
}
auto members(Is<SurfaceModel> auto& m) {
    return std::tie(m.source, m.format, m.unit, m.control_points, m.trim_points, m.patches,
                    m.trim_curves, m.trim_loops, m.faces, m.edges, m.parts, m.instances,
                    m.lost_faces, m.irregular_patches, m.repairs, m.diagnostics);
}

} // namespace keiko
