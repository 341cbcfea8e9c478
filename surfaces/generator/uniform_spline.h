#pragma once

#include "net.h"

namespace keiko::fixtures {

/// A tensor product B-spline on integer knots without end conditions: `size_u - degree_u` spans
/// along u and `size_v - degree_v` along v. Uniform knots keep the surface as smooth as its degree
/// allows (C4 for quintics), and a net sampled from a fair function stays fair: the spline only
/// averages the net, it never overshoots.
struct UniformSpline {
    int degree_u;
    int degree_v;
    Net net;

    int spans_u() const { return net.size_u() - degree_u; }
    int spans_v() const { return net.size_v() - degree_v; }
};

/// Control net of the Bezier patch of span (i, j). Neighbouring spans share their border points
/// bit for bit.
Net bezier_net(const UniformSpline& spline, int i, int j);

} // namespace keiko::fixtures
