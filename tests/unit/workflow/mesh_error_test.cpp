#include "keiko/workflow/mesh_error.h"

#include "keiko/base/error.h"

#include "tests/support/analytic_models.h"
#include <gtest/gtest.h>

#include <filesystem>

namespace keiko {
namespace {

TEST(MeshError, LimitsTheTrianglesOfAllMeshesTogether) {
    Scene scene = scene_of_model(test::torus_model(100, 20));
    scene.set_picture_size(64, 48);
    MeshErrorOptions options;
    options.deviations = {1, 0.9};
    options.mesher = Mesher::spans;
    options.views = {"front"};
    options.rig = std::filesystem::path(KEIKO_SOURCE_DIR) / "lightrigs" / "tunnel-12.toml";
    const MeshErrorReport report = mesh_error(scene, options);
    options.most_triangles = report.meshes[0].triangles + report.meshes[1].triangles;
    EXPECT_EQ(mesh_error(scene, options).meshes[1].triangles, report.meshes[1].triangles);
    options.most_triangles -= 1;
    EXPECT_THROW(mesh_error(scene, options), Error);
}

} // namespace
} // namespace keiko
