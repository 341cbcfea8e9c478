#include "keiko/maps/reaction_diffusion.h"

#include "keiko/maps/lattice_noise.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace keiko {
namespace {

constexpr int side = 128;       ///< cells of the periodic grid
constexpr int steps = 8000;     ///< of one unit of time: the pattern covers the grid by then
constexpr int first_spots = 24; ///< where the reaction begins
/// Rates 2e-5 and 1e-5 on cells of 2.5 / 256.
constexpr double cell = 2.5 / 256;
constexpr double diffusion_u = 2e-5 / (cell * cell), diffusion_v = 1e-5 / (cell * cell);

std::size_t index(int x, int y) {
    return static_cast<std::size_t>((y & (side - 1)) * side + (x & (side - 1)));
}

struct Substances {
    std::vector<double> u = std::vector<double>(std::size_t{side} * side, 1.0);
    std::vector<double> v = std::vector<double>(std::size_t{side} * side, 0.0);
};

/// Squares where half of the first substance has become the second.
Substances begun(std::uint32_t seed) {
    Substances all;
    for (int spot = 0; spot < first_spots; ++spot) {
        const auto x0 = static_cast<int>(lattice_hash(spot, 0, 0, seed) % side);
        const auto y0 = static_cast<int>(lattice_hash(spot, 1, 0, seed) % side);
        for (int y = y0; y < y0 + 5; ++y)
            for (int x = x0; x < x0 + 5; ++x) all.u[index(x, y)] = 0.5, all.v[index(x, y)] = 0.25;
    }
    return all;
}

/// One step of the cells from x0 to x1 of a row, whose neighbours beside lie at x - left and x +
/// right.
void advance_row(const Substances& from, Substances& to, int y, int x0, int x1, int left, int right,
                 double feed, double kill) {
    const auto row = [](const std::vector<double>& values, int number) {
        return values.data() + index(0, number);
    };
    const double *u = row(from.u, y), *u_up = row(from.u, y - 1), *u_down = row(from.u, y + 1);
    const double *v = row(from.v, y), *v_up = row(from.v, y - 1), *v_down = row(from.v, y + 1);
    double* u_to = to.u.data() + index(0, y);
    double* v_to = to.v.data() + index(0, y);
    for (int x = x0; x < x1; ++x) {
        const double reacting = u[x] * v[x] * v[x];
        const double u_spread = u[x - left] + u[x + right] + u_up[x] + u_down[x] - 4 * u[x];
        const double v_spread = v[x - left] + v[x + right] + v_up[x] + v_down[x] - 4 * v[x];
        u_to[x] = u[x] + diffusion_u * u_spread - reacting + feed * (1 - u[x]);
        v_to[x] = v[x] + diffusion_v * v_spread + reacting - (feed + kill) * v[x];
    }
}

void advance(const Substances& from, Substances& to, double feed, double kill) {
    for (int y = 0; y < side; ++y) {
        advance_row(from, to, y, 0, 1, 1 - side, 1, feed, kill);
        advance_row(from, to, y, 1, side - 1, 1, 1, feed, kill);
        advance_row(from, to, y, side - 1, side, 1, 1 - side, feed, kill);
    }
}

} // namespace

Image reaction_diffusion(double feed, double kill, std::uint32_t seed) {
    Substances now = begun(seed), next;
    for (int step = 0; step < steps; ++step) {
        advance(now, next, feed, kill);
        std::swap(now, next);
    }
    const double most = *std::max_element(now.v.begin(), now.v.end());
    const double least = *std::min_element(now.v.begin(), now.v.end());
    constexpr double nothing = 1e-6;
    Image picture(side, side, 1);
    if (!(most - least > nothing)) return picture;
    for (std::size_t i = 0; i < now.v.size(); ++i)
        picture.values[i] = static_cast<float>((now.v[i] - least) / (most - least));
    return picture;
}

} // namespace keiko
