#include "keiko/trace/surface_jet.h"

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

} // namespace keiko
