#include "keiko/base/units.h"
#include "keiko/light/luminance/clear_coat.h"
#include "keiko/math/quadrature.h"

#include "tests/support/lobes.h"
#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <numbers>

using namespace keiko;

namespace {

using std::numbers::pi;

/// Integral of D over the hemisphere, times the cosine for half vectors.
double norm(const Distribution& lobe) {
    const auto ring = [&](double alpha) {
        const double cosine = std::cos(alpha), sine = std::sin(alpha);
        const double weight = lobe.of_half_vectors() ? cosine : 1;
        return 2 * pi * sine * weight * lobe.density(cosine, sine * sine);
    };
    return integrate_adaptively(ring, 0, pi / 2, 1e-13);
}

} // namespace

TEST(Distribution, NormAndPeakAgreeWithOracle) {
    const test::OracleTable table("lobe_norm");
    test::WorstError whole("D_norm"), peak("D0");
    for (const auto& row : table) {
        const Distribution lobe = test::distribution_in(row);
        whole.compare(row, norm(lobe), row.number("out.D_norm"), 1e-11);
        peak.compare(row, lobe.density(1, 0), row.number("out.D0"), 1e-11);
    }
}

TEST(DirectionalAlbedo, AgreesWithOracle) {
    const test::OracleTable table("lobe_norm");
    test::WorstError above("above"), albedo("albedo");
    for (const auto& row : table) {
        const double c = std::cos(degrees_to_radians(row.number("in.thetav_deg")));
        Gloss gloss{.distribution = test::distribution_in(row)};
        above.compare(row, directional_albedo(gloss, c, 1e-7).g, row.number("out.above"), 1e-6);
        if (!row.has("out.albedo")) continue;
        gloss.mode = GlossMode::brdf;
        gloss.shadowing = test::shadowing_in(row);
        albedo.compare(row, directional_albedo(gloss, c, 1e-7).g, row.number("out.albedo"), 1e-6);
    }
}
