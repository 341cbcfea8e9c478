#include "revolved.h"

#include <array>

namespace keiko::fixtures {
namespace {

/// Control points of a quarter of the unit circle, anticlockwise from (1, 0): a cubic whose radius
/// has an error of at most 2.8e-4.
constexpr double kHandle = 0.5522847498;
constexpr std::array<std::array<double, 2>, 4> kQuarter{
    {{1, 0}, {1, kHandle}, {kHandle, 1}, {0, 1}}};

/// Point of the cubic circle in a quadrant, as (cosine, sine).
std::array<double, 2> around(int i, int quadrant) {
    std::array<double, 2> p = kQuarter[static_cast<std::size_t>(i)];
    for (int k = 0; k < quadrant; ++k) p = {-p[1], p[0]};
    return p;
}

} // namespace

void append_revolved(std::vector<Net>& patches, const std::vector<ProfilePoint>& profile) {
    for (std::size_t first = 0; first + 3 < profile.size(); first += 3)
        for (int quadrant = 0; quadrant < 4; ++quadrant)
            patches.push_back(sample_net(4, 4, [&](int i, int j) {
                const auto [radius, z] = profile[first + static_cast<std::size_t>(j)];
                const auto [cosine, sine] = around(i, quadrant);
                return gp_XYZ(radius * cosine, radius * sine, z);
            }));
}

void append_pipe(std::vector<Net>& patches, const std::vector<PipePoint>& pipe) {
    const gp_XYZ side(0, 1, 0);
    for (std::size_t first = 0; first + 3 < pipe.size(); first += 3)
        for (int quadrant = 0; quadrant < 4; ++quadrant)
            patches.push_back(sample_net(4, 4, [&](int i, int j) {
                const PipePoint& p = pipe[first + static_cast<std::size_t>(j)];
                const auto [cosine, sine] = around(i, quadrant);
                return p.middle + p.up * (p.height * cosine) + side * (p.width * sine);
            }));
}

} // namespace keiko::fixtures
