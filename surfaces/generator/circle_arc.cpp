#include "circle_arc.h"

#include <cmath>

namespace keiko::fixtures {

std::array<gp_XY, kArcDegree + 1> circle_arc(double start, double sweep) {
    const auto half = [](double angle, double turn) {
        const gp_XY place(std::cos(angle), std::sin(angle));
        const gp_XY velocity(-std::sin(angle) * turn, std::cos(angle) * turn);
        const gp_XY second = place + velocity / kArcDegree;
        const gp_XY third = second * 2.0 - place - place * (turn * turn / 20.0);
        return std::array{place, second, third};
    };
    const auto first = half(start, sweep);
    const auto last = half(start + sweep, -sweep);
    return {first[0], first[1], first[2], last[2], last[1], last[0]};
}

} // namespace keiko::fixtures
