#include "keiko/light/rig/primitive_lights.h"

namespace keiko {
namespace {

struct Lights {
    const Rgb& luminance;

    /// A sphere has a form of its own.
    std::vector<LightSource> operator()(const EllipsoidShape& shape) const {
        const Vec3 &u = shape.u, &v = shape.v, &w = shape.w;
        const double r = u.x;
        if (r > 0 && u == Vec3(r, 0, 0) && v == Vec3(0, r, 0) && w == Vec3(0, 0, r))
            return {SphereLight{shape.center, r, luminance}};
        return {EllipsoidLight{shape.center, u, v, w, luminance}};
    }
    std::vector<LightSource> operator()(const FrustumShape& shape) const {
        const FrustumLight side{shape.from, shape.to, shape.radius, shape.to_radius, luminance};
        std::vector<LightSource> lights{side};
        if (shape.open) return lights;
        if (side.radius > 0)
            lights.emplace_back(DiscLight{side.from, -side.along(), side.radius, luminance});
        if (side.to_radius > 0)
            lights.emplace_back(DiscLight{side.to, side.along(), side.to_radius, luminance});
        return lights;
    }
    std::vector<LightSource> operator()(const DiscShape& shape) const {
        return {DiscLight{shape.center, shape.normal, shape.radius, luminance}};
    }
    std::vector<LightSource> operator()(const PlaneShape& shape) const { return {panel(shape)}; }
    std::vector<LightSource> operator()(const BoxShape& shape) const {
        std::vector<LightSource> lights;
        for (const PlaneShape& face : shape.faces()) lights.push_back(panel(face));
        return lights;
    }

    std::vector<LightSource> operator()(const PolygonShape& shape) const {
        return {PolygonLight{shape.corners, luminance}};
    }

private:
    PolygonLight panel(const PlaneShape& face) const {
        const auto& [origin, u, v] = face;
        return {{origin, origin + u, origin + u + v, origin + v}, luminance};
    }
};

} // namespace

std::vector<LightSource> lights_of(const PrimitiveShape& shape, const Rgb& luminance) {
    return std::visit(Lights{luminance}, shape);
}

} // namespace keiko
