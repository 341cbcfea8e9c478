#include "keiko/raster/shadow_casters.h"
#include "keiko/raster/z_buffer.h"

#include "tests/bench/hidden_peers.h"
#include "tests/bench/sphere_cluster.h"
#include "tests/bench/uniform_grid.h"
#include "tests/bench/whitted_patches.h"
#include "tests/support/picture_interior.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko::bench {
namespace {

TEST(HiddenPeers, EdgesAgainstTrianglesAreVisibleWhereRaysSeeThem) {
    const SurfaceMesh mesh = SphereCluster(4).mesh(4);
    const Camera camera = SphereCluster::camera(64);
    const ShadowCasters bodies(mesh);
    const std::vector<IntervalSet> visible = visible_edges(mesh, camera);
    ASSERT_EQ(visible.size(), 3 * mesh.triangles.size());
    int seen = 0, hidden = 0;
    for (std::size_t i = 0; i < visible.size(); ++i) {
        const auto& corners = mesh.triangles[i / 3];
        const Vec3 &a = mesh.positions[corners[i % 3]], &b = mesh.positions[corners[(i + 1) % 3]];
        for (double t = 0.05; t < 1; t += 0.1) {
            bool near_end = false;
            for (const ParameterInterval& part : visible[i])
                near_end |= std::abs(t - part.begin) < 1e-6 || std::abs(t - part.end) < 1e-6;
            if (near_end) continue;
            // A little towards the eye, off the triangles that have the edge.
            const Vec3 place = a + (b - a) * t;
            const Vec3 before = place + (camera.eye - place) * 1e-7;
            const bool is_hidden = bodies.layers(before, Viewpoint::at(camera.eye)) > 0;
            EXPECT_EQ(visible[i].contains(t), !is_hidden) << i << " at " << t;
            ++(is_hidden ? hidden : seen);
        }
    }
    EXPECT_GT(seen, 300);
    EXPECT_GT(hidden, 300);
}

TEST(HiddenPeers, RaysAgainstTrianglesShowTheZBuffers) {
    const SurfaceMesh mesh = SphereCluster(6).mesh(6);
    const Camera camera = SphereCluster::camera(48);
    EXPECT_EQ(test::wrong_inside(faces_of(mesh, z_buffer(mesh, camera)),
                                 faces_of(mesh, cast_triangles(mesh, camera))),
              0);
}

TEST(WhittedPatches, MeetSpheresWhereTheirQuadraticsDo) {
    const SphereCluster cluster(5);
    const WhittedPatches patches(cluster.model(), 1e-4);
    const Camera camera = SphereCluster::camera(24);
    int met = 0;
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x) {
            const Ray ray = camera.ray(x + 0.5, y + 0.5);
            const auto truth = cluster.first(ray);
            const auto found = patches.first(ray);
            ASSERT_EQ(truth.has_value(), found.has_value());
            if (!truth) continue;
            ++met;
            EXPECT_NEAR(*found, truth->t, 0.02); // flat at the rim
        }
    EXPECT_GT(met, 50);
}

TEST(UniformGrid, FindsTheTrianglesOfEveryRay) {
    const SurfaceMesh mesh = SphereCluster(6).mesh(8);
    const UniformGrid grid(mesh);
    const Camera camera = SphereCluster::camera(48);
    const ItemBuffer seen = cast_triangles(mesh, camera);
    const ShadowCasters bodies(mesh);
    int met = 0;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 48; ++x) {
            const Ray ray = camera.ray(x + 0.5, y + 0.5);
            const auto found = grid.first(ray);
            ASSERT_EQ(found.has_value(), seen.at(x, y) != no_index);
            if (!found) continue;
            ++met;
            const auto corners = bodies.corners(seen.at(x, y));
            const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
            EXPECT_NEAR((ray.at(*found) - corners[0]).dot(normal.normalized()), 0, 1e-9);
        }
    EXPECT_GT(met, 200);
}

} // namespace
} // namespace keiko::bench
