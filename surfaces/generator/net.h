#pragma once

#include <gp_XYZ.hxx>

#include <cstddef>
#include <functional>
#include <vector>

namespace keiko::fixtures {

/// A rectangular array of control points in mm: index i runs along u (or s), j along v (or t).
class Net {
public:
    Net(int rows_u, int rows_v)
        : size_u_(rows_u), size_v_(rows_v), points_(static_cast<std::size_t>(rows_u * rows_v)) {}

    int size_u() const { return size_u_; }
    int size_v() const { return size_v_; }
    gp_XYZ& operator()(int i, int j) { return points_[index(i, j)]; }
    const gp_XYZ& operator()(int i, int j) const { return points_[index(i, j)]; }

private:
    std::size_t index(int i, int j) const { return static_cast<std::size_t>(i * size_v_ + j); }

    int size_u_;
    int size_v_;
    std::vector<gp_XYZ> points_;
};

/// The net whose point (i, j) is `design(i, j)`.
inline Net sample_net(int size_u, int size_v, const std::function<gp_XYZ(int, int)>& design) {
    Net net(size_u, size_v);
    for (int i = 0; i < size_u; ++i)
        for (int j = 0; j < size_v; ++j) net(i, j) = design(i, j);
    return net;
}

} // namespace keiko::fixtures
