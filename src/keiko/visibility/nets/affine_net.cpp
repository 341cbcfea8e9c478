#include "keiko/visibility/nets/affine_net.h"

#include "keiko/visibility/nets/scalar_net.h"

namespace keiko {
namespace {

ScalarNet component(const HomogeneousNet& net, unsigned k) {
    Vec4 weights(0);
    weights[k] = 1;
    return weighed(net, weights);
}

} // namespace

AffineNet affine_net(const HomogeneousNet& net) {
    AffineNet f{affine_bounds(net)};
    for (unsigned k = 0; k < 4; ++k) {
        const ScalarNet of = component(net, k);
        const auto bend = [&](bool first_by_x, bool second_by_x) {
            const bool enough = (first_by_x ? of.rows : of.columns) > 1;
            return enough ? derivative_range(derivative(of, first_by_x), second_by_x) : NetRange();
        };
        const NetRange xx = bend(true, true), xy = bend(true, false), yy = bend(false, false);
        f.xx[k] = xx.middle, f.xx_range[k] = xx.half;
        f.xy[k] = xy.middle, f.xy_range[k] = xy.half;
        f.yy[k] = yy.middle, f.yy_range[k] = yy.half;
    }
    return f;
}

} // namespace keiko
