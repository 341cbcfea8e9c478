#include "keiko/radiosity/hemicube.h"

#include "keiko/base/error.h"
#include "keiko/light/luminance/projected_solid_angle.h"

#include "tests/support/hand_mesh.h"
#include "tests/support/oracle.h"
#include "tests/unit/radiosity/box_room.h"
#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

namespace keiko {
namespace {

TEST(Hemicube, HasTheExactFormFactorsOfItsCells) {
    test::WorstError error("dF_exact");
    for (const test::OracleRow& row : test::OracleTable("hemicube")) {
        const Hemicube cube(row.integer("in.n"));
        const int i = row.integer("in.i"), j = row.integer("in.j");
        const double factor = row.text("in.face") == "top" ? cube.top(i, j) : cube.side(i, j);
        error.compare(row, factor, row.number("out.dF_exact"), 1e-10);
    }
}

TEST(Hemicube, SumsToOneAtAnyResolution) {
    for (const int n : {2, 16, 64}) {
        const Hemicube cube(n);
        double sum = 0;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                sum += cube.top(i, j) + (j < n / 2 ? 4 * cube.side(i, j) : 0);
        EXPECT_NEAR(sum, 1, 1e-12) << n;
    }
}

/// A mesh of two triangles for each rectangle.
SurfaceMesh mesh_of(const std::vector<std::vector<Vec3>>& rectangles) {
    SurfaceMesh mesh;
    for (const auto& corners : rectangles) {
        test::add_triangle(mesh, {corners[0], corners[1], corners[2]});
        test::add_triangle(mesh, {corners[0], corners[2], corners[3]});
    }
    return mesh;
}

TEST(Hemicube, AgreesWithTheBoundaryIntegralToItsCells) {
    const auto room = test::box_room({2, 3, 1.5}, 3);
    const SurfaceMesh mesh = mesh_of(room);
    double coarse = 0, fine = 0;
    for (const int n : {32, 256}) {
        const Hemicube cube(n);
        double& worst = n == 32 ? coarse : fine;
        for (std::size_t e = 0; e < room.size(); e += 5) {
            const Vec3 middle = middle_of(room[e]), normal = polygon_normal(room[e]).normalized();
            const std::vector<double> factors = cube.form_factors(mesh, middle, normal);
            EXPECT_NEAR(std::accumulate(factors.begin(), factors.end(), 0.0), 1, 1e-9);
            for (std::size_t k = 0; k < room.size(); ++k) {
                if (k == e) continue;
                const double exact =
                    projected_solid_angle(room[k], middle, normal) / std::numbers::pi;
                worst = std::max(worst, std::abs(factors[2 * k] + factors[2 * k + 1] - exact));
            }
        }
    }
    EXPECT_LT(coarse, 0.4 / 32);
    EXPECT_LT(fine, 0.4 / 256);
}

TEST(Hemicube, TellsBacksFromFrontsAndHidesWhatIsBehind) {
    const auto lower = test::parallelogram(Vec3(-1, -1, 1), Vec3(2, 0, 0), Vec3(0, 2, 0));
    const auto upper = test::parallelogram(Vec3(-9, -9, 2), Vec3(0, 18, 0), Vec3(18, 0, 0));
    const SurfaceMesh mesh = mesh_of({lower, upper});
    const Hemicube cube(128);
    const std::vector<double> factors = cube.form_factors(mesh, Vec3(0), Vec3(0, 0, 1));
    const auto factor = [](const std::vector<Vec3>& corners) {
        return projected_solid_angle(corners, Vec3(0), Vec3(0, 0, 1)) / std::numbers::pi;
    };
    EXPECT_EQ(factors[0] + factors[1], 0);
    EXPECT_NEAR(factors[4] + factors[5], factor(lower), 2e-3);
    EXPECT_NEAR(factors[2] + factors[3], factor(upper) - factor(lower), 2e-3);
    EXPECT_EQ(factors[6] + factors[7], 0);
}

TEST(Hemicube, RefusesOddNumbersOfCells) {
    EXPECT_THROW(Hemicube(33), FieldError);
    EXPECT_THROW(Hemicube(0), FieldError);
    EXPECT_THROW(Hemicube(8192), FieldError);
}

} // namespace
} // namespace keiko
