#include "keiko/inspect/basics/level_function.h"

namespace keiko {
namespace {

Triple<double> triple(const Vec3& w) {
    return {w.x, w.y, w.z};
}

} // namespace

double LevelFunction::operator()(const Vec2& uv) const {
    const SurfaceDerivatives s = evaluate(patch_, uv, 1);
    return field_.ratio(triple(s.position()), triple(s.du().cross(s.dv())), level_).above;
}

} // namespace keiko
