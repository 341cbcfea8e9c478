#pragma once

#include "keiko/light/spotlight/spotlight.h"

#include "tests/support/oracle.h"

#include <string>

namespace keiko::test {

/// The spotlight of a row of spot_distribution or spot_flux.
inline Spotlight spotlight_in(const OracleRow& row, DotReading reading) {
    const std::string base = row.text("in.base"), pattern = row.text("in.pattern");
    const BeamEdge edge = base == "sharp"  ? BeamEdge::sharp
                          : base == "soft" ? BeamEdge::soft
                                           : BeamEdge::mixed;
    Spotlight light{.half_angle = row.number("in.gamma_deg"),
                    .profile = EdgeProfile{edge, row.number("in.qmix")},
                    .intensity = Rgb(row.number("in.I0"))};
    const double dphi = row.number("in.dphi_deg");
    if (pattern == "radial")
        light.pattern = Petals{static_cast<int>(std::lround(360 / dphi)), row.number("in.qphi")};
    else if (pattern.starts_with("polka"))
        light.pattern = Dots{dphi, row.number("in.dth_deg"), row.number("in.qphi"),
                             row.number("in.qth"), reading};
    return light;
}

} // namespace keiko::test
