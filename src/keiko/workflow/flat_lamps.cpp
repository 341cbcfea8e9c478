#include "keiko/workflow/flat_lamps.h"

#include "keiko/math/bounds.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

std::vector<Vec3> control_points(const SurfaceModel& model, const Face& face) {
    std::vector<Vec3> points;
    for (std::uint32_t i = face.first_patch; i < face.first_patch + face.patch_count; ++i)
        for (const Vec4& p : model.patch(i).points) points.push_back(Vec3(p.x, p.y, p.z) / p.w);
    return points;
}

/// True if the control points of a face lie in a plane.
bool is_flat(const SurfaceModel& model, const Face& face) {
    constexpr double rounding = 1e-9; // of the size
    const std::vector<Vec3> points = control_points(model, face);
    Vec3 longest(0), normal(0);
    for (const Vec3& at : points)
        if ((at - points[0]).length2() > longest.length2()) longest = at - points[0];
    for (const Vec3& at : points)
        if (const Vec3 area = longest.cross(at - points[0]); area.length2() > normal.length2())
            normal = area;
    normal.normalize();
    return std::all_of(points.begin(), points.end(), [&](const Vec3& at) {
        return std::abs(normal.dot(at - points[0])) <= rounding * longest.length();
    });
}

} // namespace

bool is_flat(const SurfaceModel& model) {
    return std::all_of(model.faces.begin(), model.faces.end(),
                       [&](const Face& face) { return is_flat(model, face); });
}

bool hide_nothing(const std::vector<PolygonLight>& panels) {
    constexpr double rounding = 1e-9; // of the size
    Box3 box;
    for (const PolygonLight& panel : panels)
        for (const Vec3& corner : panel.corners) box.extend(corner);
    return std::all_of(panels.begin(), panels.end(), [&](const PolygonLight& panel) {
        const Vec3 normal = panel.normal();
        for (const PolygonLight& other : panels)
            for (const Vec3& corner : other.corners)
                if (const double before = normal.dot(corner - panel.corners[0]);
                    (panel.two_sided ? std::abs(before) : before) > rounding * box.size())
                    return false;
        return true;
    });
}

} // namespace keiko
