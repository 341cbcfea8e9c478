#pragma once

#include "keiko/light/areas/curved_lights.h"

#include "tests/support/oracle.h"

#include <variant>
#include <vector>

namespace keiko::test {

/// The parts of the body of a row of area_curved, of luminance 1.
inline std::vector<std::variant<DiscLight, FrustumLight, EllipsoidLight>> parts_of(
    const OracleRow& row) {
    const std::vector<double> b = row.list("in.body");
    if (row.text("in.kind") == "ellipsoid")
        return {
            EllipsoidLight{{b[0], b[1], b[2]}, {b[3], 0, 0}, {0, b[4], 0}, {0, 0, b[5]}, Rgb(1)}};
    const FrustumLight side{{b[0], b[1], b[2]}, {b[3], b[4], b[5]}, b[6], b[6], Rgb(1)};
    return {side, DiscLight{side.from, -side.along(), b[6], Rgb(1)},
            DiscLight{side.to, side.along(), b[6], Rgb(1)}};
}

} // namespace keiko::test
