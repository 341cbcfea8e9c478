#include "keiko/light/luminance/projected_solid_angle.h"
#include "keiko/math/vec.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

using namespace keiko;

namespace {

LinePiece piece_in(const test::OracleRow& row) {
    const Vec3 a = row.vector("in.A"), b = row.vector("in.B"), point = row.vector("in.P");
    const Vec3 along = (b - a).normalized(), normal = row.unit("in.N");
    const double x = along.dot(a - point);
    const Vec3 foot = a - along * x - point;
    return {x, x + (b - a).length(), foot.length(), normal.dot(along),
            normal.dot(foot.normalized())};
}

} // namespace

TEST(LineIrradiance, AgreesWithOracle) {
    const test::OracleTable table("line_irradiance");
    test::WorstError cosine("E_cos");
    for (const auto& row : table) {
        const LinePiece lit = above_horizon(piece_in(row));
        const double strength = row.number("in.Iq");
        cosine.compare(row, strength * cosine_line_integral(lit), row.number("out.E_cos"), 1e-11);
    }
}

TEST(LineIrradiance, NothingOfALineBelowTheHorizonIsLeft) {
    const LinePiece parallel{-1, 2, 1.5, 0, -0.3};
    EXPECT_FALSE(above_horizon(parallel).begin < above_horizon(parallel).end);
    const LinePiece tilted{-1, 2, 1.5, 0.6, -0.8};
    EXPECT_DOUBLE_EQ(above_horizon(tilted).begin, 2);
}
