#include "keiko/inspect/basics/line_field.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

CPlane plane(const Vec3& origin, const Vec3& u, const Vec3& v) {
    CPlane result;
    result.origin = origin, result.u = u, result.v = v;
    return result;
}

Camera camera_at(const Vec3& eye) {
    Camera camera;
    camera.eye = eye, camera.target = Vec3(0);
    return camera;
}

TEST(LineField, ImageIsWhereTheMirroredRayOfTheOracleMeetsThePlane) {
    test::WorstError along("along"), across("across");
    for (const test::OracleRow& row : test::OracleTable("mirror_jacobian")) {
        const CPlane lamps = plane(row.vector("in.Oc"), row.unit("in.U"), row.unit("in.V"));
        const LineField field(LineLook::reflection, LineEye(camera_at(row.vector("in.E"))), lamps,
                              row.vector("out.X"));
        // The side and the length of the normal do not count.
        const auto image = field.image(row.vector("out.X"), row.unit("out.Nn") * -3.0);
        EXPECT_TRUE(image.faces) << row.id();
        along.compare(row, image.along, row.number("out.u"), 1e-9);
        across.compare(row, image.value, row.number("out.v"), 1e-9);
    }
}

TEST(LineField, APlaneMirrorShowsTheLampsOfTheMirroredEye) {
    const Vec3 eye(300, -400, 1000), place(20, 70, 0);
    const CPlane lamps = plane({-500, -500, 2000}, {1000, 0, 0}, {0, 1000, 0});
    const LineField field(LineLook::reflection, LineEye(camera_at(eye)), lamps, Vec3(0));
    const Vec3 below(eye.x, eye.y, -eye.z);
    const Vec3 hit = below + (place - below) * 3.0; // heights -1000, 0, 2000
    const auto image = field.image(place, {0, 0, 1});
    EXPECT_NEAR(image.along, hit.x + 500, 1e-9);
    EXPECT_NEAR(image.value, hit.y + 500, 1e-9);
    EXPECT_NEAR(image.reach, (hit - place).length(), 1e-9);
}

TEST(LineField, RatioIsTheImagesValueForEveryLook) {
    const Vec3 place(20, 70, 30), normal(0.2, -0.3, 2);
    const CPlane lamps = plane({-500, -500, 2000}, {1000, 100, 0}, {-100, 1000, 0});
    for (const LineLook look : {LineLook::reflection, LineLook::highlight, LineLook::isophote}) {
        const LineField field(look, LineEye(camera_at({300, -400, 1000})), lamps, Vec3(0));
        const Triple<double> s{place.x, place.y, place.z}, n{normal.x, normal.y, normal.z};
        const double value = field.image(place, normal).value;
        const auto whole = field.ratio(s, n), shifted = field.ratio(s, n, value);
        EXPECT_NEAR(whole.above / whole.below, value, 1e-9 * std::abs(value)) << name_of(look);
        EXPECT_NEAR(shifted.residual(0) / shifted.below, 0, 1e-9) << name_of(look);
    }
}

TEST(LineField, ATurnedNormalMovesTheReflectionByTwiceItsAngle) {
    const CPlane lamps = plane({-500, -500, 2000}, {1000, 0, 0}, {0, 1000, 0});
    const double turn = 0.1; // degrees
    const double tangent = std::tan(turn * std::acos(-1.0) / 180);
    for (const LineLook look : {LineLook::reflection, LineLook::highlight}) {
        const LineField field(look, LineEye(camera_at({0, 0, 1000})), lamps, Vec3(0));
        const auto straight = field.image(Vec3(0), {0, 0, 1});
        const auto turned = field.image(Vec3(0), {0, tangent, 1});
        EXPECT_NEAR(field.normal_turn(straight, turned.value - straight.value), turn, 1e-12)
            << name_of(look);
    }
}

} // namespace
} // namespace keiko
