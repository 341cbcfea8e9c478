#include "uniform_spline.h"

namespace keiko::fixtures {
namespace {

using Matrix = std::vector<std::vector<double>>;

/// Weights of the span's `degree + 1` control points in its Bezier point `ones`: the blossom of
/// the span [0, 1] with `ones` arguments 1 and the others 0 (Ramshaw's de Boor recursion).
std::vector<double> blossom_weights(int degree, int ones) {
    const auto n = static_cast<std::size_t>(degree + 1);
    Matrix weights(n, std::vector<double>(n, 0.0));
    for (std::size_t i = 0; i < n; ++i) weights[i][i] = 1.0;
    for (int r = 1; r <= degree; ++r) {
        const double argument = r <= ones ? 1.0 : 0.0;
        for (int i = degree; i >= r; --i) {
            const double alpha = (argument - (i - degree)) / (degree + 1 - r);
            auto& upper = weights[static_cast<std::size_t>(i)];
            const auto& lower = weights[static_cast<std::size_t>(i - 1)];
            for (std::size_t k = 0; k < n; ++k)
                upper[k] = (1.0 - alpha) * lower[k] + alpha * upper[k];
        }
    }
    return weights.back();
}

/// Row j holds the weights of Bezier point j.
Matrix extraction(int degree) {
    Matrix rows;
    for (int j = 0; j <= degree; ++j) rows.push_back(blossom_weights(degree, j));
    // The last point is the next span's first: the same weights, one control point further, so
    // that rounding cannot open the joint.
    auto& last = rows.back();
    for (std::size_t k = 1; k < last.size(); ++k) last[k] = rows.front()[k - 1];
    last.front() = 0.0;
    rows.front().back() = 0.0;
    return rows;
}

gp_XYZ weighted_sum(const std::vector<double>& weights, const std::function<gp_XYZ(int)>& point) {
    gp_XYZ sum;
    for (std::size_t k = 0; k < weights.size(); ++k)
        if (weights[k] != 0.0) sum += point(static_cast<int>(k)) * weights[k];
    return sum;
}

} // namespace

Net bezier_net(const UniformSpline& spline, int i, int j) {
    const Matrix along_u = extraction(spline.degree_u);
    const Matrix along_v = extraction(spline.degree_v);
    return sample_net(spline.degree_u + 1, spline.degree_v + 1, [&](int a, int b) {
        return weighted_sum(along_u[static_cast<std::size_t>(a)], [&](int k) {
            return weighted_sum(along_v[static_cast<std::size_t>(b)],
                                [&](int l) { return spline.net(i + k, j + l); });
        });
    });
}

} // namespace keiko::fixtures
