#include "keiko/files/model/model_serialization.h"

#include <cmath>

namespace keiko {
namespace {

/// Whether [first, first + count) lies in a list of `size`.
bool in_range(std::uint64_t first, std::uint64_t count, std::size_t size) {
    return first + count <= size;
}

bool valid_degree(int degree) {
    return degree >= 1 && degree <= max_degree;
}

bool sound(const Vec4& p) {
    return std::isfinite(p.x + p.y + p.z + p.w) && p.w > 0;
}
bool sound(const Vec3& p) {
    return std::isfinite(p.x + p.y + p.z) && p.z > 0;
}

bool sound(const ParameterMap& map) {
    return std::isfinite(map.begin) && std::isfinite(map.end) && map.begin < map.end;
}

bool sound(const Patch& p, const SurfaceModel& m) {
    return p.face < m.faces.size() && valid_degree(p.degree_u) && valid_degree(p.degree_v) &&
           sound(p.map_u) && sound(p.map_v) &&
           in_range(p.first_point, (p.degree_u + std::uint64_t{1}) * (p.degree_v + 1u),
                    m.control_points.size());
}

bool sound(const TrimCurve& c, const SurfaceModel& m) {
    return valid_degree(c.degree) && in_range(c.first_point, c.degree + 1u, m.trim_points.size()) &&
           (c.edge == no_index || c.edge < m.edges.size());
}

bool sound(const TrimLoop& l, const SurfaceModel& m) {
    return in_range(l.first_curve, l.curve_count, m.trim_curves.size());
}

bool sound(const Face& f, const SurfaceModel& m) {
    return f.part < m.parts.size() && in_range(f.first_patch, f.patch_count, m.patches.size()) &&
           in_range(f.first_loop, f.loop_count, m.trim_loops.size()) &&
           std::isfinite(f.approximated);
}

bool sound(const IrregularPatch& p, const SurfaceModel& m) {
    return p.face < m.faces.size() && is_finite(p.center) && std::isfinite(p.radius);
}

bool sound(const Repair& r, const SurfaceModel&) {
    return std::isfinite(r.size);
}

bool sound(const Edge& e, const SurfaceModel&) {
    return std::isfinite(e.tolerance);
}

bool sound(const Part& p, const SurfaceModel& m) {
    return in_range(p.first_face, p.face_count, m.faces.size());
}

bool sound(const Instance& i, const SurfaceModel& m) {
    return i.part < m.parts.size() && is_finite(i.transform.translation) &&
           std::isfinite(i.transform.determinant()) && i.transform.determinant() != 0;
}

template <class T, class... Model>
std::optional<std::string> fault_in(const char* kind, const std::vector<T>& values,
                                    const Model&... model) {
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!sound(values[i], model...)) return kind + std::to_string(i) + " is unsound";
    return std::nullopt;
}

} // namespace

std::optional<std::string> structural_fault(const SurfaceModel& m) {
    for (const auto& fault :
         {fault_in("control point ", m.control_points), fault_in("trim point ", m.trim_points),
          fault_in("patch ", m.patches, m), fault_in("trim curve ", m.trim_curves, m),
          fault_in("trim loop ", m.trim_loops, m), fault_in("face ", m.faces, m),
          fault_in("edge ", m.edges, m), fault_in("part ", m.parts, m),
          fault_in("instance ", m.instances, m),
          fault_in("irregular patch ", m.irregular_patches, m), fault_in("repair ", m.repairs, m)})
        if (fault) return fault;
    return std::nullopt;
}

} // namespace keiko
