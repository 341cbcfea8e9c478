#include "keiko/geometry/model/ground_plane.h"

#include <algorithm>

namespace keiko {

SurfaceModel ground_plane(double z, const Box3& body) {
    constexpr double least = 1e5, times = 100;
    const double reach = std::max(least, times * body.size());
    const Vec3 middle = body.center();
    SurfaceModel model;
    model.source = model.format = "ground";
    for (const double x : {-reach, reach})
        for (const double y : {-reach, reach})
            model.control_points.emplace_back(middle.x + x, middle.y + y, z, 1);
    const ParameterMap map{ParameterMap::Kind::affine, 0, 1};
    model.patches.push_back({0, 0, 1, 1, map, map});
    Face face;
    face.id = 1;
    face.name = "ground";
    face.surface_kind = "plane";
    face.patch_count = 1;
    model.faces.push_back(face);
    model.parts.push_back({"ground", 0, 1});
    model.instances.push_back({0, "ground", {}});
    return model;
}

} // namespace keiko
