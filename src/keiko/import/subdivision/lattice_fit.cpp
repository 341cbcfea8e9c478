#include "keiko/import/subdivision/limit_patches.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace keiko::subdivision {
namespace {

// Newton's form on a uniform lattice: with n = degree and forward differences D[a][b] at the
// origin, the polynomial is the sum of D[a][b] C(n u, a) C(n v, b), C being binomials.

constexpr int most = 4;
using Matrix = std::array<std::array<double, most + 1>, most + 1>;
using Samples = std::array<std::array<Vec3, most + 1>, most + 1>;

double binomial(int n, int k) {
    double value = 1;
    for (int i = 0; i < k; ++i) value = value * (n - i) / (i + 1);
    return value;
}

/// matrix[a][i]: Bernstein coefficient i of C(n u, a).
Matrix bernstein_of_newton(int n) {
    Matrix result{};
    std::array<double, most + 1> monomials{1};
    for (int a = 0; a <= n; ++a) {
        for (int i = 0; i <= n; ++i)
            for (int k = 0; k <= i; ++k)
                result[a][i] += monomials[k] * binomial(i, k) / binomial(n, k);
        // C(n u, a + 1) = C(n u, a) (n u - a) / (a + 1)
        for (int k = n; k >= 0; --k)
            monomials[k] = ((k > 0 ? n * monomials[k - 1] : 0) - a * monomials[k]) / (a + 1);
    }
    return result;
}

/// Forward differences of samples (i, j) with i, j <= n and i + j <= total, in place.
void difference(Samples& s, int n, int total) {
    for (int level = 1; level <= n; ++level)
        for (int i = n; i >= level; --i)
            for (int j = 0; j <= std::min(n, total - i); ++j) s[i][j] -= s[i - 1][j];
    for (int level = 1; level <= n; ++level)
        for (int j = n; j >= level; --j)
            for (int i = 0; i <= std::min(n, total - j); ++i) s[i][j] -= s[i][j - 1];
}

Samples differences(int n, int total, const SurfaceSample& surface) {
    Samples samples;
    for (auto& row : samples) row.fill(Vec3(0));
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= std::min(n, total - i); ++j)
            samples[i][j] = surface(double(i) / n, double(j) / n);
    difference(samples, n, total);
    return samples;
}

} // namespace

std::vector<Vec3> fit_square(int n, const SurfaceSample& surface) {
    assert(n <= most);
    const Samples samples = differences(n, 2 * n, surface);
    const Matrix matrix = bernstein_of_newton(n);
    std::vector<Vec3> points;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j) {
            Vec3 sum(0);
            for (int a = 0; a <= n; ++a)
                for (int b = 0; b <= n; ++b) sum += samples[a][b] * (matrix[a][i] * matrix[b][j]);
            points.push_back(sum);
        }
    return points;
}

SurfaceSample triangle_polynomial(const SurfaceSample& surface) {
    constexpr int n = 4;
    return [samples = differences(n, n, surface)](double u, double v) {
        std::array<double, n + 1> at_u{1}, at_v{1};
        for (int k = 0; k < n; ++k) {
            at_u[k + 1] = at_u[k] * (n * u - k) / (k + 1);
            at_v[k + 1] = at_v[k] * (n * v - k) / (k + 1);
        }
        Vec3 sum(0);
        for (int a = 0; a <= n; ++a)
            for (int b = 0; a + b <= n; ++b) sum += samples[a][b] * (at_u[a] * at_v[b]);
        return sum;
    };
}

} // namespace keiko::subdivision
