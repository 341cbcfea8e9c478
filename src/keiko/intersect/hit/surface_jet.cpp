#include "keiko/intersect/hit/surface_jet.h"

#include <cmath>

namespace keiko {
namespace {

Vec3 spatial(const Component4& c) {
    return {c[0], c[1], c[2]};
}

} // namespace

SurfaceDerivatives SurfaceJet::derivatives() const {
    SurfaceDerivatives s;
    s.d[0][0] = position;
    s.d[1][0] = du;
    s.d[0][1] = dv;
    s.d[2][0] = duu;
    s.d[1][1] = duv;
    s.d[0][2] = dvv;
    return s;
}

SurfaceJet projected(const HomogeneousJet& jet, bool rational) {
    const double scale = 1 / jet.value[3];
    SurfaceJet s{spatial(jet.value) * scale, spatial(jet.du) * scale,  spatial(jet.dv) * scale,
                 spatial(jet.duu) * scale,   spatial(jet.duv) * scale, spatial(jet.dvv) * scale};
    if (!rational) return s;
    const double wu = jet.du[3] * scale, wv = jet.dv[3] * scale;
    s.du -= s.position * wu;
    s.dv -= s.position * wv;
    s.duu -= s.du * (2 * wu) + s.position * (jet.duu[3] * scale);
    s.dvv -= s.dv * (2 * wv) + s.position * (jet.dvv[3] * scale);
    s.duv -= s.dv * wu + s.du * wv + s.position * (jet.duv[3] * scale);
    return s;
}

std::optional<Vec3> bending_side(const SurfaceJet& j, const Vec3& way) {
    const Vec3 n = j.du.cross(j.dv);
    const double e = j.du.dot(j.du), f = j.du.dot(j.dv), g = j.dv.dot(j.dv);
    const double u = j.du.dot(way), v = j.dv.dot(way), d = e * g - f * f;
    const double a = (g * u - f * v) / d, b = (e * v - f * u) / d;
    const Vec3 second = j.duu * (a * a) + j.duv * (2 * a * b) + j.dvv * (b * b);
    constexpr double sure = 1e-5;
    const double bend = n.dot(second) / n.length();
    if (!(std::abs(bend) > sure * second.length())) return std::nullopt;
    return n * ((bend > 0 ? 1 : -1) / n.length());
}

} // namespace keiko
