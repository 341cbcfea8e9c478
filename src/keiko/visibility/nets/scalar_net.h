#pragma once

#include "keiko/visibility/nets/tangent_planes.h"

#include <array>
#include <vector>

namespace keiko {

/// Bernstein coefficients of one function over [0, 1]^2, u outer, of any degrees.
struct ScalarNet {
    std::size_t rows = 0, columns = 0; ///< degrees in u and v, plus 1
    std::vector<double> c;             ///< rows * columns coefficients

    /// Coefficient i in u, j in v.
    double& at(std::size_t i, std::size_t j) { return c[i * columns + j]; }
    /// Coefficient i in u, j in v.
    double at(std::size_t i, std::size_t j) const { return c[i * columns + j]; }
};

/// Coefficients of sum weights[k] * component k.
ScalarNet weighed(const HomogeneousNet& net, const Vec4& weights);

/// The function over a box of its parameters.
ScalarNet restricted(const ScalarNet& net, const Box2& box);

/// The function over the two halves of [0, 1]^2, cut across the first axis, 0, or the second, 1.
std::array<ScalarNet, 2> halved(const ScalarNet& net, unsigned axis);
/// Net over the two halves of [0, 1]^2, cut likewise.
std::array<HomogeneousNet, 2> halved(const HomogeneousNet& net, unsigned axis);

/// Its derivative by x = 2 u - 1, or by y = 2 v - 1. Requires a degree of at least 1 there.
ScalarNet derivative(const ScalarNet& net, bool by_x);

/// Middle and half width of the values that a net may have.
struct NetRange {
    double middle = 0; ///< of the range
    double half = 0;   ///< half its width, 0 or more

    /// Lower end.
    double low() const { return middle - half; }
    /// Upper end.
    double high() const { return middle + half; }
    /// Largest magnitude.
    double largest() const { return std::abs(middle) + half; }
    /// True if 0 is in the range, its ends included.
    bool holds_zero() const { return std::abs(middle) <= half; }
};
/// Range of the coefficients, which bounds the values on [0, 1]^2; 0 for an empty net.
NetRange range(const ScalarNet& net);

/// Whether a function may have a zero there that is known to within `error` and rounding.
bool may_vanish(const ScalarNet& net, double error = 0);

/// Range of the derivative by x = 2 u - 1, or by y = 2 v - 1; 0 where the degree there is 0.
NetRange derivative_range(const ScalarNet& net, bool by_x);

/// A place and axes that the points of a net are relative to.
struct NetFrame {
    Vec3 center{0};                                                        ///< world, mm
    std::array<Vec3, 3> rows{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}; ///< unit, world

    /// A direction in the axes.
    Vec3 local(const Vec3& v) const { return {rows[0].dot(v), rows[1].dot(v), rows[2].dot(v)}; }
    /// Weights of homogeneous coordinates of the frame that equal `w` for those in world axes
    /// relative to `center`; this turns points and tangent planes alike.
    Vec4 local(const Vec4& w) const {
        const Vec3 v = local(Vec3(w.x, w.y, w.z));
        return {v.x, v.y, v.z, w.w};
    }
};

/// Into the axes of a frame, from world axes.
inline HomogeneousNet turned(HomogeneousNet net, const NetFrame& frame) {
    for (Vec4& p : net.points) p = frame.local(p);
    return net;
}

} // namespace keiko
