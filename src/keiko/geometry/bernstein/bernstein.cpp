#include "keiko/geometry/bernstein/bernstein.h"

#include "keiko/geometry/bernstein/de_casteljau.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Below this width (about 50 halvings) two roots are one.
constexpr double narrowest = 1e-15;

int sign_variations(std::span<const double> c, double noise) {
    int count = 0;
    double last = 0;
    for (const double x : c) {
        if (!(std::abs(x) > noise)) continue;
        if (last * x < 0) ++count;
        last = std::copysign(1, x);
    }
    return count;
}

/// The polynomial on [begin, end], by its coefficients there.
struct Stretch {
    double begin, end;
    std::vector<double> c;
};

std::pair<Stretch, Stretch> halves(const Stretch& whole) {
    const double middle = (whole.begin + whole.end) / 2;
    auto [left, right] = bernstein_parts(whole.c);
    return {{whole.begin, middle, std::move(left)}, {middle, whole.end, std::move(right)}};
}

/// Adds the roots in a stretch. A root right at a cut is found from both sides, or, if the
/// coefficient there is zero, from neither: it is added here, and the caller drops doubles.
void find(const Stretch& stretch, double noise, std::vector<double>& roots) {
    const int variations = sign_variations(stretch.c, noise);
    if (variations == 0) return;
    if (stretch.end - stretch.begin < narrowest) {
        roots.push_back((stretch.begin + stretch.end) / 2);
        return;
    }
    const auto [left, right] = halves(stretch);
    find(left, noise, roots);
    if (!(std::abs(right.c.front()) > noise)) roots.push_back(right.begin);
    find(right, noise, roots);
}

} // namespace

BernsteinRow bernstein_values(int degree, double t) {
    assert(degree >= 0 && degree <= max_degree);
    BernsteinRow row{};
    row[0] = 1;
    for (std::size_t n = 1; n <= static_cast<std::size_t>(degree); ++n) raise_degree(row, n, t);
    return row;
}

std::vector<double> bernstein_roots(std::span<const double> coefficients, double noise) {
    std::vector<double> roots;
    find({0, 1, {coefficients.begin(), coefficients.end()}}, noise, roots);
    std::sort(roots.begin(), roots.end());
    const auto same = [](double a, double b) { return b - a < 4 * narrowest; };
    roots.erase(std::unique(roots.begin(), roots.end(), same), roots.end());
    std::erase_if(roots, [](double t) { return !(t > narrowest && t < 1 - narrowest); });
    return roots;
}

} // namespace keiko
