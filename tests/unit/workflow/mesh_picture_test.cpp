#include "keiko/workflow/mesh_picture.h"

#include "keiko/base/error.h"

#include "tests/support/analytic_models.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

TEST(MeshPicture, FacetsOfAPixelRefuseWhatOnlyMeshesHave) {
    const Scene scene = scene_of_model(test::torus_model(100, 20));
    Camera camera;
    camera.eye = Vec3(400, 0, 100), camera.width = 16, camera.height = 12;
    MeshLook look;
    look.by_pixels = true;
    EXPECT_EQ(mesh_film(scene, {}, camera, look).color.width, 16);
    look.hidden_surfaces = HiddenSurfaces::painter;
    EXPECT_THROW(mesh_film(scene, {}, camera, look), FieldError);
    look.hidden_surfaces = HiddenSurfaces::z_buffer, look.shadows = MeshShadows::ray;
    EXPECT_THROW(mesh_film(scene, {}, camera, look), FieldError);
}

} // namespace
} // namespace keiko
