#pragma once

#include "keiko/light/luminance/gloss_kernel.h"

#include "tests/support/oracle.h"

namespace keiko::test {

inline Distribution distribution_in(const OracleRow& row) {
    const std::string& name = row.text("in.dist");
    const auto kind = name == "phong"   ? DistributionKind::phong
                      : name == "blinn" ? DistributionKind::blinn
                      : name == "gauss" ? DistributionKind::gauss
                      : name == "tr"    ? DistributionKind::trowbridge_reitz
                                        : DistributionKind::beckmann;
    return {kind, row.number("in.param")};
}

inline Shadowing shadowing_in(const OracleRow& row) {
    const std::string& name = row.text("in.G");
    return name == "vcav"    ? Shadowing::cavities
           : name == "smith" ? Shadowing::smith
                             : Shadowing::none;
}

} // namespace keiko::test
