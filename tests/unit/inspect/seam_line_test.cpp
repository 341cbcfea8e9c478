#include "keiko/inspect/seams/seam_line.h"

#include "tests/unit/inspect/sheets.h"
#include <gtest/gtest.h>

#include <algorithm>

namespace keiko {
namespace {

double binomial(int n, int k) {
    return k == 0 ? 1 : binomial(n - 1, k - 1) * n / k;
}

/// Two flat sheets whose gap along x waves between 0.01 and 0.03 mm, about, as a Chebyshev
/// polynomial of even degree does, and grows by `rise` mm.
SurfaceModel wavy_gap(int degree, double rise) {
    test::ModelBuilder builder;
    test::flat_sheet(builder, {0, 50, 0});
    std::vector<Vec3> points;
    for (int i = 0; i <= degree; ++i) {
        const double wave = binomial(2 * degree, 2 * i) / binomial(degree, i), x = 1.0 * i / degree;
        const double gap = 0.02 + rise * x + (i % 2 == 0 ? -0.01 : 0.01) * wave;
        points.emplace_back(test::sheet_length * x, -gap, 0);
        points.emplace_back(test::sheet_length * x, -50, 0);
    }
    builder.patch(degree, 1, points);
    return builder.build();
}

TEST(SeamLine, FindsTheWidestPlaceHoweverManyPieces) {
    for (const int degree : {14, 16, 20})
        for (const int pieces : {1, 4, 8})
            for (const double rise : {-0.001, 0.001}) {
                const SurfaceModel model = wavy_gap(degree, rise);
                const BoundaryCurves curves(model);
                const SeamProbe whole(curves, pair_seams(model, 0.5).at(0));
                const auto at = [&](double share) {
                    return whole.at(whole.begin() + share * (whole.end() - whole.begin()));
                };
                double widest = 0;
                for (int i = 0; i <= 20000; ++i) widest = std::max(widest, at(i / 20000.0).gap);
                SeamLine line{0, 0, 0, 1, {}};
                for (int i = 0; i < pieces; ++i)
                    line.probes.push_back(whole.part(at(1.0 * i / pieces), at((i + 1.0) / pieces)));
                const auto stretches =
                    measure_line(model, line, {}, stretch_limits(50, 50, {}, 0.5));
                ASSERT_EQ(stretches.size(), 1U);
                const MeasuredValue& gap = stretches.front().seam.gap;
                EXPECT_GE(gap.value + gap.bound, widest - 1e-9) << degree << ", " << pieces;
                EXPECT_LE(gap.value, widest + 1e-6) << degree << ", " << pieces;
            }
}

} // namespace
} // namespace keiko
