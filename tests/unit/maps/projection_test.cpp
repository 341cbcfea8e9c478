#include "keiko/maps/projection.h"

#include "keiko/geometry/bezier/bezier.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <array>
#include <numbers>

namespace keiko {
namespace {

using test::OracleRow;
using test::OracleTable;

MapProjection projection_of(const OracleRow& row) {
    MapProjection projection;
    const std::string& kind = row.text("in.kind");
    projection.kind = kind == "planar"        ? ProjectionKind::planar
                      : kind == "cylindrical" ? ProjectionKind::cylindrical
                      : kind == "spherical"   ? ProjectionKind::spherical
                                              : ProjectionKind::parameter;
    projection.scale = {row.number("in.su"), row.number("in.sv")};
    projection.offset = {row.number("in.ou"), row.number("in.ov")};
    if (projection.kind == ProjectionKind::parameter) return projection;
    projection.origin = row.vector("in.O");
    if (projection.kind == ProjectionKind::planar) {
        projection.u = row.vector("in.a"), projection.v = row.vector("in.b");
    } else {
        projection.axis = row.vector("in.a"), projection.u = row.vector("in.b");
    }
    if (row.has("in.h")) projection.height = row.number("in.h");
    return projection;
}

/// Parameters of a place on a bicubic patch by Newton's method from a grid of starts.
Vec2 parameters_of(const std::vector<Vec3>& points, const Vec3& place) {
    std::vector<Vec4> net;
    for (const Vec3& p : points) net.emplace_back(p.x, p.y, p.z, 1);
    const BezierPatchView patch{3, 3, net};
    for (int start = 0; start < 25; ++start) {
        Vec2 uv(0.1 + 0.2 * (start % 5), 0.1 + 0.2 * (start / 5));
        for (int step = 0; step < 30; ++step) {
            const SurfaceDerivatives s = evaluate(patch, uv, 1);
            const Vec3 off = place - s.position(), n = s.du().cross(s.dv());
            uv += Vec2(off.cross(s.dv()).dot(n), s.du().cross(off).dot(n)) / n.length2();
        }
        const double left = (evaluate(patch, uv, 1).position() - place).length();
        if (left < 1e-9 && uv.x > -1e-9 && uv.x < 1 + 1e-9 && uv.y > -1e-9 && uv.y < 1 + 1e-9)
            return uv;
    }
    ADD_FAILURE() << "the place is not on the patch";
    return Vec2(0);
}

TEST(MapProjection, CoordinatesAreTheOracles) {
    const OracleTable table("map_coords");
    ASSERT_EQ(table.size(), 16U);
    int parameters = 0;
    for (const OracleRow& row : table) {
        const MapProjection projection = projection_of(row);
        const bool own = projection.kind == ProjectionKind::parameter;
        const double tolerance = own ? 1e-10 : 1e-11;
        parameters += own ? 1 : 0;
        const ProjectedPlace at =
            own ? ProjectedPlace{parameters_of(row.points("in.patch"), row.vector("in.X"))}
                : projected(projection, row.vector("in.X"));
        EXPECT_NEAR(at.at.x, row.number("out.u"), tolerance) << row.id();
        EXPECT_NEAR(at.at.y, row.number("out.v"), tolerance) << row.id();
        const Vec2 scaled = at.scaled(projection.scale, projection.offset).at;
        EXPECT_NEAR(wrapped(scaled.x), row.number("out.uw"), tolerance) << row.id();
        EXPECT_NEAR(wrapped(scaled.y), row.number("out.vw"), tolerance) << row.id();
    }
    EXPECT_GT(parameters, 0);
}

TEST(MapProjection, GradientsAreThoseOfDifferences) {
    MapProjection projection{.origin = {10, 20, 30},
                             .u = {300, 40, 5},
                             .v = {-30, 200, 70},
                             .axis = {0.3, -0.2, 1},
                             .height = 250};
    for (const ProjectionKind kind :
         {ProjectionKind::planar, ProjectionKind::cylindrical, ProjectionKind::spherical}) {
        projection.kind = kind;
        const Vec3 place(150, -120, 260);
        const ProjectedPlace at = projected(projection, place);
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 step(0);
            step[axis] = 1e-4;
            const Vec2 change =
                projected(projection, place + step).at - projected(projection, place - step).at;
            EXPECT_NEAR(at.grad_u[axis], change.x / 2e-4, 1e-9);
            EXPECT_NEAR(at.grad_v[axis], change.y / 2e-4, 1e-9);
        }
    }
}

TEST(MapProjection, WrapsNegativeCoordinatesIntoTheTile) {
    EXPECT_DOUBLE_EQ(wrapped(-0.25), 0.75);
    EXPECT_EQ(wrapped(-1e-30), 0);
    EXPECT_EQ(wrapped(3), 0);
}

TEST(MapProjection, AxisOfACylinderHasNoGradientOfU) {
    const MapProjection projection{.kind = ProjectionKind::cylindrical};
    EXPECT_EQ(projected(projection, Vec3(0, 0, 500)).grad_u, Vec3(0));
    EXPECT_DOUBLE_EQ(projected(projection, Vec3(0, 0, 500)).at.y, 0.5);
}

} // namespace
} // namespace keiko
