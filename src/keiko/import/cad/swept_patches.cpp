#include "keiko/import/cad/swept_patches.h"

namespace keiko::cad {
namespace {

/// Homogeneous image of a homogeneous profile point turned by a homogeneous point of the unit
/// circle: the part along the axis stays, the part across it turns.
Vec4 turned(const Axis& axis, const Vec4& point, const Vec3& circle) {
    const Vec3 from_origin = Vec3(point.x, point.y, point.z) - axis.origin * point.w;
    const Vec3 along = axis.direction * from_origin.dot(axis.direction);
    const Vec3 across = from_origin - along;
    const Vec3 quarter_turn = axis.direction.cross(across) * (axis.left_handed ? -1.0 : 1.0);
    const Vec3 p =
        (axis.origin * point.w + along) * circle.z + across * circle.x + quarter_turn * circle.y;
    return {p.x, p.y, p.z, point.w * circle.z};
}

Vec4 shifted(const Vec4& point, const Vec3& offset) {
    return {point.x + offset.x * point.w, point.y + offset.y * point.w,
            point.z + offset.z * point.w, point.w};
}

} // namespace

std::vector<SurfacePatch> revolved(const Axis& axis, double begin, double end,
                                   const std::vector<CurveSpan<Vec4>>& profile) {
    std::vector<SurfacePatch> patches;
    for (const UnitArc& arc : circle_arcs(begin, end))
        for (const CurveSpan<Vec4>& span : profile) {
            SurfacePatch patch{arc.map, span.map, 2, static_cast<int>(span.points.size()) - 1, {}};
            for (const Vec3& circle : arc.points)
                for (const Vec4& point : span.points)
                    patch.points.push_back(turned(axis, point, circle));
            patches.push_back(std::move(patch));
        }
    return patches;
}

std::vector<SurfacePatch> extruded(const Vec3& direction, double begin, double end,
                                   const std::vector<CurveSpan<Vec4>>& profile) {
    const ParameterMap map_v{ParameterMap::Kind::affine, begin, end};
    std::vector<SurfacePatch> patches;
    for (const CurveSpan<Vec4>& span : profile) {
        SurfacePatch patch{span.map, map_v, static_cast<int>(span.points.size()) - 1, 1, {}};
        for (const Vec4& point : span.points) {
            patch.points.push_back(shifted(point, direction * begin));
            patch.points.push_back(shifted(point, direction * end));
        }
        patches.push_back(std::move(patch));
    }
    return patches;
}

} // namespace keiko::cad
