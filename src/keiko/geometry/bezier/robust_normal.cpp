#include "keiko/geometry/bezier/robust_normal.h"

#include "keiko/geometry/bezier/differential_geometry.h"

namespace keiko {

std::optional<Vec3> robust_normal(SurfaceDerivatives s, const Vec2& uv) {
    constexpr double gone = 1e-8;
    const double mixed = s.duv().length();
    if (s.du().length() < gone * mixed) s.d[1][0] = s.d[2][0] = Vec3(0);
    if (s.dv().length() < gone * mixed) s.d[0][1] = s.d[0][2] = Vec3(0);
    return unit_normal(s, uv);
}

} // namespace keiko
