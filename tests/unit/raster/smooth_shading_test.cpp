#include "keiko/raster/smooth_shading.h"

#include "tests/support/oracle.h"

namespace keiko {
namespace {

using test::OracleRow;

std::array<double, 3> depths_of(const OracleRow& row) {
    return {row.number("in.w0"), row.number("in.w1"), row.number("in.w2")};
}

std::array<double, 3> luminances_of(const OracleRow& row) {
    return {row.number("in.I0"), row.number("in.I1"), row.number("in.I2")};
}

/// Weights at the row's pixel of its triangle as a pinhole at the origin sees it along z, with
/// corners of these depths.
Vec3 weights_of(const OracleRow& row, const std::array<double, 3>& depths) {
    const std::array<Vec3, 3> corners{
        Vec3(row.number("in.x0"), row.number("in.y0"), 1) * depths[0],
        Vec3(row.number("in.x1"), row.number("in.y1"), 1) * depths[1],
        Vec3(row.number("in.x2"), row.number("in.y2"), 1) * depths[2]};
    Ray ray;
    ray.origin = Vec3(0), ray.direction = Vec3(row.number("in.px"), row.number("in.py"), 1);
    return ray_weights(corners, ray);
}

TEST(SmoothShading, AgreesWithTheOracleInPerspective) {
    const test::OracleTable table("smooth_shading");
    test::WorstError luminance("out.persp_I"), depth("out.depth"), inverse("out.inv_depth");
    for (const OracleRow& row : table) {
        const std::array<double, 3> depths = depths_of(row);
        const Vec3 weights = weights_of(row, depths);
        luminance.compare(row, mixed(weights, luminances_of(row)), row.number("out.persp_I"),
                          1e-12);
        depth.compare(row, mixed(weights, depths), row.number("out.depth"), 1e-12);
        inverse.compare(row, 1 / mixed(weights, depths), row.number("out.inv_depth"), 1e-12);
    }
}

TEST(SmoothShading, AgreesWithTheOracleInThePicture) {
    const test::OracleTable table("smooth_shading");
    test::WorstError gouraud("out.gouraud");
    for (const OracleRow& row : table) {
        const Vec3 weights = weights_of(row, {1, 1, 1}); // across the line of sight: no perspective
        gouraud.compare(row, mixed(weights, luminances_of(row)), row.number("out.gouraud"), 1e-12);
        const Vec3 normal =
            mixed_normal(weights, {row.unit("in.n0"), row.unit("in.n1"), row.unit("in.n2")});
        EXPECT_LT((normal - row.vector("out.phongN")).length(), 1e-12) << row.id();
    }
}

TEST(SmoothShading, SharesATriangleSeenEdgeOnEvenly) {
    Ray ray;
    ray.origin = Vec3(0), ray.direction = Vec3(1, 0, 0);
    const Vec3 weights = ray_weights({Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(1, 1, 0)}, ray);
    EXPECT_EQ(weights, Vec3(1.0 / 3));
}

} // namespace
} // namespace keiko
