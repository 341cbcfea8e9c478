#include "keiko/rig/within_lamp.h"

#include "keiko/spotlight/point_light.h"
#include "keiko/tubes/c_plane_frame.h"

#include <cmath>

namespace keiko {
namespace {

/// Of a tube's radius: points this near to the glass are taken to lie on it.
constexpr double rounding = 1e-9;

struct Holds {
    const Vec3& point;

    bool operator()(const CPlane& plane) const {
        const CPlaneFrame frame(plane);
        const Vec3 at = frame.point(point);
        if (!(at.x > 0 && at.x < frame.length)) return false;
        for (int i = 0; i < frame.lamps; ++i)
            if (std::hypot(at.y - frame.axis(i), at.z) < frame.radius() * (1 - rounding))
                return true;
        return false;
    }
    template <PointLight Light>
    bool operator()(const Light& light) const {
        return light.position == point;
    }
    bool operator()(const Sun&) const { return false; }
};

} // namespace

bool within_lamp(const LightSource& source, const Vec3& point) {
    return std::visit(Holds{point}, source);
}

} // namespace keiko
