#include "keiko/raster/averaged_normals.h"

#include "tests/support/hand_mesh.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

TEST(AveragedNormals, OfACubesCornerAreItsDiagonal) {
    SurfaceMesh mesh;
    test::add_triangle(mesh, {Vec3(0), Vec3(0, 1, 0), Vec3(1, 0, 0)});
    test::add_triangle(mesh, {Vec3(0), Vec3(0, 0, 1), Vec3(0, 1, 0)});
    test::add_triangle(mesh, {Vec3(0), Vec3(1, 0, 0), Vec3(0, 0, 1)});
    const std::vector<Vec3> normals = averaged_normals(mesh);
    for (const std::size_t corner : {0U, 3U, 6U}) // of the cube, one a triangle
        EXPECT_LT((normals[corner] + Vec3(1) / std::sqrt(3.0)).length(), 1e-15);
}

TEST(AveragedNormals, OfOtherFacesDoNotCount) {
    SurfaceMesh mesh;
    test::add_triangle(mesh, {Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, 1);
    test::add_triangle(mesh, {Vec3(0), Vec3(0, 1, 0), Vec3(0, 0, 1)}, 2);
    EXPECT_EQ(averaged_normals(mesh).front(), Vec3(0, 0, 1));
}

TEST(AveragedNormals, OfASphereAreNearItsOwn) {
    const SurfaceMesh mesh = test::sphere_mesh(30, 60);
    const std::vector<Vec3> normals = averaged_normals(mesh);
    double most = 0;
    for (std::size_t i = 0; i < normals.size(); ++i)
        most = std::max(most, angle_between(normals[i], mesh.normals[i]));
    EXPECT_LT(most, std::numbers::pi / 60); // a cell
    EXPECT_GT(most, 1e-4);
}

} // namespace
} // namespace keiko
