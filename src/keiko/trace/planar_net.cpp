#include "keiko/trace/planar_net.h"

namespace keiko {
namespace {

/// `lines` Bezier polynomials side by side, coefficient i of line k at c[i * step + k * stride]:
/// cut down to [a, b], in place.
void restrict_lines(double* c, std::size_t count, std::size_t step, std::size_t lines,
                    std::size_t stride, double a, double b) {
    const auto blend = [&](std::size_t to, std::size_t from, std::size_t with, double t) {
        for (std::size_t k = 0; k < lines; ++k) {
            const std::size_t line = k * stride;
            c[to * step + line] = (1 - t) * c[from * step + line] + t * c[with * step + line];
        }
    };
    if (b != 1)
        for (std::size_t level = 1; level < count; ++level)
            for (std::size_t i = count - 1; i >= level; --i) blend(i, i - 1, i, b);
    if (a != 0)
        for (std::size_t level = 1; level < count; ++level)
            for (std::size_t i = 0; i + level < count; ++i) blend(i, i, i + 1, a / b);
}

/// Values and first derivatives of the Bernstein polynomials, without the cost of higher ones.
struct Basis {
    BernsteinRow value, derivative;

    Basis(int degree, double t) {
        const auto at = [](BernsteinRow& row, int i) -> double& {
            return row[static_cast<std::size_t>(i)];
        };
        at(value, 0) = 1;
        for (int n = 1; n < degree; ++n) raise_degree(value, static_cast<std::size_t>(n), t);
        if (degree == 0) {
            at(derivative, 0) = 0;
            return;
        }
        at(derivative, 0) = -degree * at(value, 0);
        for (int i = 1; i < degree; ++i)
            at(derivative, i) = degree * (at(value, i - 1) - at(value, i));
        at(derivative, degree) = degree * at(value, degree - 1);
        raise_degree(value, static_cast<std::size_t>(degree), t);
    }
};

} // namespace

PlanarNet restricted(const PlanarNet& net, const Box2& box) {
    const std::size_t rows = net.rows(), columns = net.columns();
    PlanarNet part;
    part.degree_u = net.degree_u;
    part.degree_v = net.degree_v;
    std::copy_n(net.f.begin(), net.size(), part.f.begin());
    std::copy_n(net.g.begin(), net.size(), part.g.begin());
    for (double* c : {part.f.data(), part.g.data()}) {
        restrict_lines(c, rows, columns, columns, 1, box.lower.x, box.upper.x);
        restrict_lines(c, columns, 1, rows, columns, box.lower.y, box.upper.y);
    }
    return part;
}

PlanarPoint evaluate(const PlanarNet& net, const Vec2& uv) {
    const Basis u(net.degree_u, uv.x), v(net.degree_v, uv.y);
    PlanarPoint p{Vec2(0), Vec2(0), Vec2(0)};
    for (std::size_t i = 0, at = 0; i < net.rows(); ++i) {
        Vec2 along(0), slope(0);
        for (std::size_t j = 0; j < net.columns(); ++j, ++at) {
            const Vec2 c(net.f[at], net.g[at]);
            along += c * v.value[j];
            slope += c * v.derivative[j];
        }
        p.value += along * u.value[i];
        p.du += along * u.derivative[i];
        p.dv += slope * u.value[i];
    }
    return p;
}

} // namespace keiko
